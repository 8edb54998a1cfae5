/** Clubs, balls and parameter sets as `data.py` writes them, and the inputs of a strike made of them. */

import type { Description, Quantity, Strike, Values } from "../core/types";
import type { Tree } from "../quantities/tree";
import type { ElementsData } from "./elements";

export type AmountPair = [value: number, unit: string];

export interface ClubEntry {
  label: string;
  kind: string;
  /** Kind of club as published figures distinguish them. */
  published_kind: string;
  /** Family of clubs whose published parameter sets it takes. */
  parameters: string;
  description: string;
  /** Speed, attack angle and dynamic loft of the tour average. */
  typical: Record<"speed" | "attack" | "loft", AmountPair>;
  /** Corners of the face, towards the toe and up the face [m]. */
  outline: [number, number][];
  outline_source: string;
  /** SI by the names of the core's inputs; null is infinite. */
  columns: Record<string, number | null>;
  space: SpaceEntry;
  /** Names of the rules that hold for its kind. */
  rules: string[];
}

/** The space that a head is assumed to fill [SI]. */
export interface SpaceEntry {
  shape: string;
  centre: [number, number, number];
  /** From face to back, from sole to crown, from heel to toe. */
  size: [number, number, number];
  volume: number | null;
  free_mass: number;
  origin: string;
}

/** A limit of the rules of golf [SI]. */
export interface RuleEntry {
  title: string;
  /** The number that is limited. */
  of: string;
  most: number;
  /** The number that is the limit in the place of `most`. */
  most_of?: string;
  tolerance: number;
  source: string;
  /** The greatest loft for which it holds. */
  steepest: number | null;
}

/** A number of a club's file. */
export interface FileField {
  key: string;
  /** The input of the core. */
  column: string;
  needed: boolean;
  unit: string;
  /** Bounds in this unit. */
  least: number | null;
  most: number | null;
  /** The word for infinity. */
  infinite: string | null;
}

export interface BallEntry {
  label: string;
  description: string;
  columns: Values;
}

export interface SetEntry {
  model: string;
  name: string;
  label: string;
  source: string;
  reference: string;
  caveats: string[];
  values: number[];
  /** Whether the values describe ball and face together, and the characteristic time of that face, where it is known. */
  includes_face: boolean;
  characteristic_time: number | null;
}

/** How the shots of a golfer are distributed, as `clubface_dispersion` takes it. */
export interface Distribution {
  variables: string[];
  mean: number[];
  covariance: number[][];
  mirrored: string[];
  mishit_share: number;
  mishit_scale: number;
}

export interface GolferEntry {
  title: string;
  /** The club that the shots are of. */
  club: string;
  /** The shots with a club of either hand. */
  right: Distribution;
  left: Distribution;
  /** Figures in words, and where they come from. */
  sources: [figures: string, source: string][];
}

/** Usual measures of a hole [m], and the strokes to hole out from green, fairway, rough and recovery by distance [m]. */
export interface HoleEntry {
  fairway: number;
  rough: number;
  green: number;
  tables: { distance: number[]; strokes: number[] }[];
}

/** Places of the parameter set and of the face by the name of the published set, "" for the usual one. */
type Choices = Record<string, [set: number, face: number]>;

/** One comparison with published figures: errors in SI, or shares of the published values. */
export interface PublishedComparison {
  title: string;
  quantity: string;
  /** The quantity as which the errors are read, or `share`. */
  reads_as: string;
  /** A word of the certainties. */
  certainty: string;
  /** Places of the sources. */
  sources: number[];
  figures: number;
  /** How many of them are within the tolerance; null where there is none. */
  within: number | null;
  tolerance: number | null;
  /** Mean of the magnitudes of the errors, their mean, and the largest; null where it is not published. */
  size: number;
  bias: number | null;
  worst: number | null;
}

/** Places of comparisons by kind of club and output. */
type ComparisonPlaces = Record<string, Record<string, number[]>>;

/** What is known of the numbers of a shot: equations, and how sure they are. */
export interface Numbers {
  /** Names of the numbers that can be explained. */
  explained: string[];
  /** Values of equations that are no columns of the core. */
  terms: Record<string, { symbol: string; label: string; quantity: string }>;
  equations: Record<string, { title: string; tree: Tree }[]>;
  certainty: {
    certainties: Record<string, string>;
    models: Record<string, ComparisonPlaces>;
    flights: ComparisonPlaces;
    rows: PublishedComparison[];
    sources: string[];
  };
}

/** Published figures that lessons name, in SI. */
export interface LessonFigures {
  rules: Record<string, { title: string; most: number; tolerance: number; source: string }>;
  /** How far from path to face balls start, and the spread, by club. */
  start_shares: { source: string; rows: Record<string, [share: number, spread: number]> };
  /** Launch angle and spin of one wedge, by the covers of the balls. */
  wedge_covers: { source: string; rows: Record<string, [launch: number, spin: number]> };
  /** Spin over that of a rigid ball that rolls off the face, with lofts that a monitor computed from the ball. */
  loft_ratio: { source: string; value: number };
  /** Who says where on the head a monitor measures. */
  club_data: { source: string };
}

/** What maps of a face are of. */
export interface FaceMapEntry {
  quantities: string[];
  /** Share of the best ball speed from which a point counts as part of the effective face. */
  share: number;
}

export interface Equipment {
  version: string;
  numbers: Numbers;
  defaults: { model: string; ball: string; club: string };
  inputs: string[];
  clubs: Record<string, ClubEntry>;
  balls: Record<string, BallEntry>;
  /** Quantities that the core does not know. */
  quantities: Quantity[];
  rules: Record<string, RuleEntry>;
  club_file: { fields: FileField[]; keys: string[]; kinds: string[] };
  /** Clubhead speed is proportional to the mass of the head to minus this power. */
  speed_exponent: number;
  golfers: Record<string, GolferEntry>;
  hole: HoleEntry;
  /** Inputs of a flight in SI by the names of grounds. */
  grounds: Record<string, Values>;
  face_map: FaceMapEntry;
  sets: SetEntry[];
  faces: [characteristicTime: number, includedTime: number][];
  choices: Record<string, Record<string, Record<string, Choices>>>;
  elements: ElementsData;
  lessons: LessonFigures;
}

export const HANDS = ["right", "left"] as const;
export type Hand = (typeof HANDS)[number];

export interface Chosen {
  club: string;
  ball: string;
  model: string;
  /** Name of a published parameter set, "" for the usual one. */
  parameters: string;
  hand: Hand;
}

/** The names of the parameter sets that a club, a ball and a model leave to choose from; the first is the usual one. */
export const setNames = (equipment: Equipment, { model, club, ball }: Chosen): string[] =>
  Object.keys(equipment.choices[model][club][ball]);

function choice(equipment: Equipment, { model, club, ball, parameters }: Chosen): [number, number] {
  const known = equipment.choices[model][club][ball];
  return known[parameters] ?? known[""];
}

export const chosenSet = (equipment: Equipment, chosen: Chosen): SetEntry =>
  equipment.sets[choice(equipment, chosen)[0]];

/** 1 for a right-handed club, whose toe is to the right of its heel seen from behind, -1 for a left-handed one. */
export const handSign = ({ hand }: Pick<Chosen, "hand">): number => (hand === "left" ? -1 : 1);

/** What stands for an input of a delivery that is left out [SI]: the loft of the club, and otherwise 0. */
export const usualValue = (equipment: Equipment, { club }: Pick<Chosen, "club">, name: string): number =>
  name === "loft" ? (equipment.clubs[club].columns.static_loft ?? 0) : 0;

/** The strike of a delivery in SI. */
export function strikeOf(description: Description, equipment: Equipment, chosen: Chosen, delivery: Values): Strike {
  const [set, face] = choice(equipment, chosen);
  const [characteristic_time, included_time] = equipment.faces[face];
  const club = Object.entries(equipment.clubs[chosen.club].columns).map(([name, value]) => [name, value ?? Infinity]);
  const values: Values = {
    ...equipment.balls[chosen.ball].columns,
    ...Object.fromEntries(club),
    characteristic_time,
    included_time,
    hand: handSign(chosen),
    ...delivery,
  };
  const inputs = description.inputs.map(({ name }) => values[name] ?? usualValue(equipment, chosen, name));
  return { model: chosen.model, inputs, parameters: equipment.sets[set].values, flight: {} };
}
