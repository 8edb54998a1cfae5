/** A face struck everywhere, by one club or two at the same points. */

import type { LoadedCore } from "clubface-core";
import { flightInputs } from "./compute";
import type { FaceMapSummary, Strike } from "./types";

/** A club that strikes with all of its face, whose outline are corners towards the toe and up it [m]. */
export interface StruckFace {
  strike: Strike;
  outline: [number, number][];
}

/** What is asked beyond the values over the face. */
export interface MapDetails {
  /** Quantities whose greatest values are searched. */
  best?: string[];
  /** Share of the best ball speed from which a point counts as part of the effective face. */
  share?: number;
  /** The point that impacts scatter about and their standard deviations [m], towards the toe and up. */
  scatter?: { about: [number, number]; deviations: [number, number] };
}

export interface MapInput {
  /** The club, and perhaps the one whose map is taken from its own. */
  faces: StruckFace[];
  /** Points towards the toe and up the face. */
  grid: [number, number];
  details: MapDetails | null;
}

export interface FaceValues {
  /** Values [SI] by the names of the quantities, row by row from the lowest one up. */
  values: Record<string, Float64Array>;
  /** 1 where a point is on the face. */
  inside: ArrayLike<number>;
  summary: FaceMapSummary;
  /** Why there is no forgiveness though it was asked for, "" otherwise. */
  failure: string;
}

export interface FaceMaps {
  input: MapInput;
  /** Places of the points [m]. */
  toe: Float64Array;
  high: Float64Array;
  faces: FaceValues[];
}

/** What a scatter of impacts that does not fit the face is called in an error. */
const SCATTER = /^(spread|about): /;

export function mapFaces(core: LoadedCore, input: MapInput): FaceMaps {
  let points: [number[], number[]] | null = null;
  let places: Pick<FaceMaps, "toe" | "high"> = { toe: new Float64Array(), high: new Float64Array() };
  const faces = input.faces.map((face) => {
    const setup = setupOf(core, face, input.details, points ? { points } : { grid: input.grid });
    const { text, arrays, failure } = mapped(core, setup);
    places = { toe: arrays.toe.values, high: arrays.high.values };
    points ??= [Array.from(places.toe), Array.from(places.high)];
    const count = places.toe.length * places.high.length;
    const values = Object.fromEntries(
      text.quantities.map((name, i) => [name, arrays.values.values.slice(i * count, (i + 1) * count)]),
    );
    return { values, inside: arrays.inside.values, summary: text, failure };
  });
  return { input, ...places, faces };
}

interface Setup extends MapDetails {
  model: string;
  inputs: number[];
  parameters: number[];
  flight: number[];
  outline: [number, number][];
  points?: [number[], number[]];
  grid?: [number, number];
}

function setupOf(
  core: LoadedCore,
  { strike, outline }: StruckFace,
  details: MapDetails | null,
  where: Pick<Setup, "points" | "grid">,
): Setup {
  const { model, inputs, parameters } = strike;
  return { model, inputs, parameters, flight: flightInputs(core, strike, {}), outline, ...where, ...details };
}

/** The map; without forgiveness where impacts cannot scatter so. */
function mapped(core: LoadedCore, setup: Setup): ReturnType<LoadedCore["faceMap"]> & { failure: string } {
  try {
    return { ...core.faceMap(setup), failure: "" };
  } catch (error) {
    const message = error instanceof Error ? error.message : String(error);
    if (!setup.scatter || !SCATTER.test(message)) throw error;
    return { ...core.faceMap({ ...setup, scatter: undefined }), failure: message.replace(SCATTER, "") };
  }
}
