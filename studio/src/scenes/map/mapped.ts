/** What is mapped: the clubs, the quantity, and the values that are shown of what was computed. */

import { type Context, choiceSetting, delivered, outlineOf, settingSi, strike } from "../../context";
import type { FaceMaps, MapDetails, StruckFace } from "../../core/face-map";
import type { Wanted } from "../../core/lanes";
import { handSign } from "../../equipment/equipment";
import { outputOf } from "../../state/store";
import { extended, type Field, type Place, rangeOf, refined, valueAt } from "./field";
import { NO_CLUB } from "./settings";

/** Points towards the toe and up the face: while a slider moves, and then. */
const COARSE: [number, number] = [15, 11];
const FINE: [number, number] = [41, 41];
/** About as many points along a side are drawn. */
const DRAWN = 161;

/** The club, and the one whose map is taken from its own. */
export function clubsOf(context: Context): string[] {
  const other = choiceSetting(context, "map_minus");
  return other === NO_CLUB || other === context.state.club ? [context.state.club] : [context.state.club, other];
}

/** A map is of the whole face, wherever the shot strikes it. */
const facesOf = (context: Context): StruckFace[] =>
  clubsOf(context).map((club) => ({
    strike: strike(context, { club, parameters: setFor(context, club) }, { toe: 0, high: 0 }),
    outline: outlineOf(context, club),
  }));

/** A parameter set that was chosen belongs to the first club. */
const setFor = ({ state }: Context, club: string): string => (club === state.club ? state.parameters : "");

/** What is asked about a face as a whole, and where it stands: by contact models the last takes some seconds. */
const DETAILS = ["map", "map-forgiveness", "map-area"] as const;
export type Details = (typeof DETAILS)[number];

const detailsOf = (context: Context): Record<Details, MapDetails> => ({
  map: { best: ["ball_speed", "carry"] },
  "map-forgiveness": {
    scatter: {
      about: [delivered(context, "toe"), delivered(context, "high")],
      deviations: [settingSi(context, "strikes_toe"), settingSi(context, "strikes_high")],
    },
  },
  "map-area": { share: context.equipment.face_map.share },
});

/** What takes less than this is computed on the page [ms]. */
const AT_ONCE = 8;
/** How long the delivery rests before the face is integrated over [ms]. */
const REST = 150;

/** A few points at once, then all of them with the best ones, then what is integrated over the face. */
export function wantedMaps(context: Context): Wanted[] {
  const faces = facesOf(context);
  const details = detailsOf(context);
  const before = context.model.results["map-first"]?.milliseconds ?? Infinity;
  const map = (slot: string, grid: [number, number], details: MapDetails | null): Wanted<"faceMap"> => ({
    kind: "faceMap",
    input: { faces, grid, details },
    slot,
    lane: "batch",
  });
  return [
    { ...map("map-first", COARSE, null), lane: before < AT_ONCE ? "page" : "batch" },
    map("map", FINE, details.map),
    // Integrals have points of their own, whatever those of the map.
    { ...map("map-forgiveness", COARSE, details["map-forgiveness"]), rest: REST },
    { ...map("map-area", COARSE, details["map-area"]), rest: REST },
  ];
}

const facesKey = ({ input }: FaceMaps): string => JSON.stringify(input.faces);

/** The newest map: that of all points unless a few of a newer one are known. */
export function newestMaps({ model }: Context): FaceMaps | null {
  const [first, whole] = [outputOf(model, "faceMap", "map-first"), outputOf(model, "faceMap", "map")];
  if (!first || !whole) return whole ?? first;
  return facesKey(first) === facesKey(whole) ? whole : first;
}

export const detailedMaps = ({ model }: Context, name: Details): FaceMaps | null => outputOf(model, "faceMap", name);

/** Whether details are still those of another face or delivery. */
export function areDetailsOld(context: Context, name: Details): boolean {
  const [details, newest] = [detailedMaps(context, name), newestMaps(context)];
  return details !== null && newest !== null && facesKey(details) !== facesKey(newest);
}

/** A quantity over the face, as it is drawn. */
export interface Shown {
  maps: FaceMaps;
  /** Name of the quantity. */
  name: string;
  isDifference: boolean;
  /** Whether it has two sides, about 0. */
  isDiverging: boolean;
  /** What is known, the same with values just beyond it, and finer ones in between. */
  known: Field;
  field: Field;
  drawn: Field;
  /** Least and greatest value on the face [SI]. */
  range: [number, number];
  /** The ball speed of the first club, and that at which its effective face ends. */
  speed: Field;
  /** Corners of the face, or of both faces. */
  outlines: Place[][];
  /** 1 where the toe is on the right. */
  side: number;
}

let latest: { inputs: readonly unknown[]; shown: Shown | null } = { inputs: [], shown: null };

/** The same object as long as nothing that it is made of changes. */
export function shownMap(context: Context): Shown | null {
  const maps = newestMaps(context);
  const inputs = [maps, choiceSetting(context, "map"), handSign(context.state)];
  if (inputs.some((input, i) => input !== latest.inputs[i])) latest = { inputs, shown: maps && made(context, maps) };
  return latest.shown;
}

function made(context: Context, maps: FaceMaps): Shown | null {
  const name = choiceSetting(context, "map");
  const [first, second] = maps.faces;
  const { toe, high } = maps;
  const isOn = (place: number): boolean => maps.faces.every(({ inside }) => inside[place] === 1);
  const values = second ? first.values[name].map((value, i) => value - second.values[name][i]) : first.values[name];
  const known = { toe, high, values };
  // A second face may end within the box around the first; twice, so that corners are reached.
  const field = extended(extended(known));
  const range = rangeOf(values, isOn);
  if (!range) return null;
  const times = Math.max(1, Math.round((DRAWN - 1) / (Math.max(toe.length, high.length) - 1)));
  const sides = context.formatter.quantity(name).sides;
  return {
    maps,
    name,
    isDifference: second !== undefined,
    isDiverging: second !== undefined || (sides?.[0] === "left" && sides[1] === "right"),
    known,
    field,
    drawn: refined(field, times),
    range,
    speed: refined({ toe, high, values: first.values.ball_speed }, times),
    outlines: maps.input.faces.map(({ outline }) => outline),
    side: handSign(context.state),
  };
}

/** Whether a point is on all outlines, which bulge outwards everywhere. */
export const isOnFace = (outlines: Place[][], [toe, high]: Place): boolean =>
  outlines.every((corners) => {
    const turns = corners.map(([x, y], i) => {
      const [u, v] = corners[(i + 1) % corners.length];
      return (u - x) * (high - y) - (v - y) * (toe - x);
    });
    return turns.every((turn) => turn >= -1e-12) || turns.every((turn) => turn <= 1e-12);
  });

/** The value at a point of the face [SI]; NaN off the face. */
export const shownAt = ({ field, outlines }: Shown, place: Place): number =>
  isOnFace(outlines, place) ? valueAt(field, place) : Number.NaN;
