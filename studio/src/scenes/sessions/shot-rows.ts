/** Shots of a result as the scene draws them: values in SI, what is computed, and the flight path. */

import type { Units } from "../../quantities/units";
import type { Row, TableDocument } from "../../state/session";

/** A column of numbers: the key of its values, its quantity, and its unit there. */
export interface Measured {
  key: string;
  quantity: string;
  unit: string;
}

export interface ShotRow {
  shot: number;
  /** The club as the file calls it. */
  club: string;
  shape: string;
  /** The quantity that makes the shot a mishit, "" where it is none. */
  mishit: string;
  /** When it was hit, as the file says. */
  date: string;
  /** In SI, by quantity. */
  values: Record<string, number>;
  computed: ReadonlySet<string>;
  /** Distance to the target, height and distance to the right of points [m]. */
  path: [along: number, high: number, right: number][];
}

/** The columns of numbers, in their order. */
export const measuredColumns = ({ columns }: TableDocument): Measured[] =>
  Object.entries(columns).flatMap(([key, { quantity, unit }]) => (quantity && unit ? [{ key, quantity, unit }] : []));

const text = (row: Row, key: string): string => (typeof row[key] === "string" ? row[key] : "");

/** The shots of a table with the points of their flight paths. */
export function shotRows(units: Units, shots: TableDocument, paths: TableDocument | undefined): ShotRow[] {
  const points = new Map<number, ShotRow["path"]>();
  for (const row of paths?.rows ?? []) {
    const path = points.get(Number(row.shot)) ?? [];
    path.push([Number(row.along_m), Number(row.height_m), Number(row.side_m)]);
    points.set(Number(row.shot), path);
  }
  const measured = measuredColumns(shots);
  return shots.rows.map((row) => {
    const values: Record<string, number> = {};
    for (const { key, quantity, unit } of measured) {
      const value = row[key];
      if (typeof value === "number") values[quantity] = units.toSi({ value, unit });
    }
    return {
      shot: Number(row.shot),
      club: text(row, "club"),
      shape: text(row, "shape"),
      mishit: text(row, "mishit"),
      date: text(row, "date"),
      values,
      computed: new Set(text(row, "computed").split(" ").filter(Boolean)),
      path: points.get(Number(row.shot)) ?? [],
    };
  });
}

/** Where a shot lands [m]: as measured, or at the end of its flight path; null where neither is known. */
export function landing({ values, path }: ShotRow): [along: number, right: number] | null {
  const { carry, side } = values;
  if (carry !== undefined && side !== undefined) return [Math.sqrt(Math.max(carry ** 2 - side ** 2, 0)), side];
  const end = path.at(-1);
  return end ? [end[0], end[2]] : null;
}

/** The clubs of shots in the order in which they come, each with how many shots it has. */
export function clubsOf(rows: readonly ShotRow[]): [club: string, shots: number][] {
  const counts = new Map<string, number>();
  for (const { club } of rows) counts.set(club, (counts.get(club) ?? 0) + 1);
  return [...counts];
}
