/** What the Python package answers a page that it serves: files, reports, fittings, studies, live shots. */

import type { System } from "../quantities/formatter";

export type Cell = string | number | boolean | null;
export type Row = Record<string, Cell>;

/** A column of a table as the package describes it: numbers are in `unit`. */
export interface ColumnDocument {
  label: string;
  quantity?: string;
  unit?: string;
  meaning?: string;
}

export interface TableDocument {
  columns: Record<string, ColumnDocument>;
  rows: Row[];
}

export interface NoteDocument {
  code: string;
  text: string;
}

/** A result of the package, as its `to_dict()` describes it. */
export interface ResultDocument {
  kind: string;
  title: string;
  values: Row;
  tables: Record<string, TableDocument>;
  summary: NoteDocument[];
  notes: NoteDocument[];
}

/** What is wrong, where, and what would have been accepted. */
export interface ServerMistake {
  where: string;
  what: string;
  allowed: string | null;
}

/** Something that is asked of the package: not yet, on its way, there, or refused. */
export type Asked<T> =
  | { state: "none" | "loading" }
  | { state: "there"; value: T }
  | { state: "refused"; mistake: ServerMistake };

export interface Offers {
  clubface: string;
  studies: boolean;
  live: boolean;
  largest_file: number;
  formats: string[];
  clubs: string[];
  balls: string[];
  objectives: string[];
}

/** A file that was chosen: its bytes stay with the page, so that it can be read again in other units. */
export interface SessionFile {
  source: File;
  /** Where the package has it. */
  place: string;
  read: ResultDocument;
  shots: ResultDocument;
}

export interface Job {
  job: string;
  state: "running" | "done" | "failed" | "cancelled";
  done: number;
  whole: number;
  step: string;
  mistake: ServerMistake | null;
  result: ResultDocument | null;
}

export interface LiveState {
  count: number;
  file: string;
  club: string;
  hand: string;
  links: { protocol: string; address: string; problem: string }[];
  remarks: { at: string; text: string }[];
}

export interface Live {
  /** Shots and flight paths of all events so far. */
  shots: TableDocument;
  paths: TableDocument;
  notes: NoteDocument[];
  state: LiveState | null;
  isConnected: boolean;
}

export interface Session {
  /** The units of the sentences that were asked for. */
  system: System;
  /** Where the package answers, null on a site that it does not serve. */
  api: string | null;
  offers: Asked<Offers>;
  file: Asked<SessionFile>;
  /** The last file that was chosen, and the units, hand and layout given for it. */
  source: File | null;
  reading: Record<string, string>;
  /** The club that alone is shown, "" for all, and the shot that is marked. */
  club: string;
  marked: number | null;
  report: Asked<string>;
  golfer: Asked<ResultDocument>;
  fitting: Asked<Job>;
  /** What is asked of a fitting. */
  wishes: { objective: string; balls: string[]; clubs: string[]; loft: string; only: string };
  studies: Asked<ResultDocument>;
  study: { name: string; report: Asked<string> } | null;
  live: Live | null;
}

export const NOTHING: { state: "none" } = { state: "none" };
const EMPTY: TableDocument = { columns: {}, rows: [] };

export const initialSession = (api: string | null): Session => ({
  system: "golf",
  api,
  offers: NOTHING,
  file: NOTHING,
  source: null,
  reading: {},
  club: "",
  marked: null,
  report: NOTHING,
  golfer: NOTHING,
  fitting: NOTHING,
  wishes: { objective: "carry", balls: ["modern", "distance"], clubs: [], loft: "2 deg", only: "" },
  studies: NOTHING,
  study: null,
  live: null,
});

export const initialLive = (): Live => ({ shots: EMPTY, paths: EMPTY, notes: [], state: null, isConnected: false });

const joined = (before: TableDocument, more: TableDocument | undefined): TableDocument =>
  more ? { columns: { ...before.columns, ...more.columns }, rows: [...before.rows, ...more.rows] } : before;

/** Live shots with those of another event. */
export const withShots = (live: Live, { tables, notes }: ResultDocument): Live => ({
  ...live,
  shots: joined(live.shots, tables.shots),
  paths: joined(live.paths, tables.paths),
  notes,
});
