/** What makes a number: contributions of the inputs of a delivery that add up to it. */

import type { LoadedCore } from "clubface-core";
import { slopesAndValues } from "./compute";
import type { Strike, Values } from "./types";

/** Places between 0 and 1 and their weights, with which polynomials of the ninth degree are integrated exactly. */
const NODES: readonly (readonly [place: number, weight: number])[] = [
  [0.04691007703066802, 0.11846344252809454],
  [0.23076534494715845, 0.23931433524968324],
  [0.5, 0.28444444444444444],
  [0.7692346550528415, 0.23931433524968324],
  [0.953089922969332, 0.11846344252809454],
];

export interface ContributionsInput {
  strike: Strike;
  /** Inputs of the delivery from which the contributions are counted, in SI by name; the others stay. */
  from: Values;
}

/** Of each output by its name: its value at the start, and what each changed input adds. */
export interface Contributions {
  start: Values;
  parts: Record<string, Values>;
}

/** Integrals of exact derivatives along the straight line from one delivery to the other; null where one misses. */
export function computeContributions(core: LoadedCore, { strike, from }: ContributionsInput): Contributions | null {
  const places = core.description.inputs.map(({ name }, place) => ({ name, place }));
  const changed = places.filter(({ name, place }) => name in from && strike.inputs[place] !== from[name]);
  const between = (share: number): Strike => {
    const inputs = [...strike.inputs];
    for (const { name, place } of changed) inputs[place] = from[name] + share * (strike.inputs[place] - from[name]);
    return { ...strike, inputs };
  };
  const first = slopesAndValues(core, between(0));
  if (!first) return null;
  const parts: Record<string, Values> = {};
  for (const [share, weight] of NODES) {
    const there = slopesAndValues(core, between(share));
    if (!there) return null;
    for (const [output, slopes] of Object.entries(there.slopes)) {
      parts[output] ??= {};
      for (const { name, place } of changed)
        parts[output][name] = (parts[output][name] ?? 0) + weight * slopes[name] * (strike.inputs[place] - from[name]);
    }
  }
  return { start: first.values, parts };
}
