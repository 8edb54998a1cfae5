/** What the worker computes for lessons: a few strikes with all that is drawn of them, and curves over one input. */

import type { LoadedCore } from "clubface-core";
import { computeModel, DRAWN, flightInputs } from "./compute";
import type { Computed, CoreArray, Strike, Values } from "./types";

export interface Case {
  strike: Strike;
  /** Whether its flight is drawn. */
  path?: boolean;
  /** Whether its contact is followed in time. */
  history?: boolean;
}

export interface CaseResult extends Computed {
  /** Positions of the ball in flight [m], x y z of each moment after one another; empty where not asked for. */
  path: Float64Array;
  history: Record<string, CoreArray> | null;
}

/** Strikes by their names; `at` are the settings they were made of, which come back with them. */
export interface Cases {
  at: Values;
  cases: Record<string, Case>;
}

export interface CasesResult {
  at: Values;
  cases: Record<string, CaseResult>;
}

export function computeLessonCases(core: LoadedCore, { at, cases }: Cases): CasesResult {
  return { at, cases: mapped(cases, (each) => computeCase(core, each)) };
}

function computeCase(core: LoadedCore, { strike, path, history }: Case): CaseResult {
  const computed = computeModel(core, strike);
  const isWhole = !computed.failure;
  const { model, inputs, parameters } = strike;
  return {
    ...computed,
    path:
      path && isWhole
        ? core.trajectory(flightInputs(core, strike, computed.values)).position.values
        : new Float64Array(),
    history: history && isWhole ? core.history(model, inputs, parameters, DRAWN) : null,
  };
}

/** One strike over the values of an input or of a parameter of its model. */
export interface Curve {
  strike: Strike;
  by: string;
  values: number[];
}

export interface CurveResult {
  x: Float64Array;
  /** Launch and flight at each value; NaN where there is none. */
  y: Record<string, Float64Array>;
}

export const computeLessonCurves = (core: LoadedCore, curves: Record<string, Curve>): Record<string, CurveResult> =>
  mapped(curves, (each) => computeCurve(core, each));

function computeCurve(core: LoadedCore, { strike, by, values }: Curve): CurveResult {
  const shots = values.map((value) => computeModel(core, withValue(core, strike, by, value)).values);
  const { outputs, flight_outputs } = core.description;
  const names = [...outputs, ...flight_outputs].map(({ name }) => name);
  const column = (name: string): Float64Array => Float64Array.from(shots, (each) => each[name] ?? Number.NaN);
  return { x: Float64Array.from(values), y: Object.fromEntries(names.map((name) => [name, column(name)])) };
}

/** A strike with one input, or one parameter of its model, replaced. */
function withValue({ description }: LoadedCore, strike: Strike, name: string, value: number): Strike {
  const input = description.inputs.findIndex((each) => each.name === name);
  if (input >= 0) return { ...strike, inputs: strike.inputs.with(input, value) };
  const { parameters = [] } = description.models.find((each) => each.name === strike.model) ?? {};
  const place = parameters.findIndex((each) => each.name === name);
  if (place < 0) throw new Error(`${name} is neither an input nor a parameter of ${strike.model}`);
  return { ...strike, parameters: strike.parameters.with(place, value) };
}

const mapped = <A, B>(record: Record<string, A>, change: (value: A) => B): Record<string, B> =>
  Object.fromEntries(Object.entries(record).map(([name, value]) => [name, change(value)]));
