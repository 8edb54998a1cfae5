/** What the workers compute of a club that is designed: numbers, limits, averages, and where the best one lies. */

import type { LoadedCore } from "clubface-core";
import { type Setup, withClub } from "../equipment/design";
import type { Report } from "./computations";
import { computeModel, flightInputs, slopesAndValues } from "./compute";
import type { Computed, Dispersion, Margin, Slopes, Space, Values } from "./types";

/** Mass properties in the order in which the core takes those of a head. */
export const MASS_PROPERTIES = ["club_mass", "cg_x", "cg_y", "cg_z", "ixx", "iyy", "izz", "ixy", "ixz", "iyz"];

/** The same strike with two clubs, and the derivatives with the second by all that changes with a club. */
export function computeDesign(
  core: LoadedCore,
  { own, designed }: { own: Setup; designed: Setup },
): { own: Computed; designed: Computed; slopes: Slopes } {
  const by = core.description.inputs.flatMap(({ name, group, differentiable }, place) =>
    differentiable && (group === "club" || name === "loft" || name === "speed") ? [place] : [],
  );
  const computed = computeModel(core, designed.strike);
  return {
    own: computeModel(core, own.strike),
    designed: computed,
    slopes: computed.failure ? {} : (slopesAndValues(core, designed.strike, by)?.slopes ?? {}),
  };
}

export interface Limits {
  /** All conditions on the head, and what a margin may be below 0. */
  margins: Margin[];
  rounding: number;
  /** Where each of the mass properties may lie while the others stay, within the range that was asked for [SI]. */
  allowed: Record<string, [least: number, most: number][]>;
}

const SAMPLES = 161;
const HALVINGS = 30;

export function computeLimits(
  core: LoadedCore,
  { space, values, ranges }: { space: Space; values: Values; ranges: Record<string, readonly [number, number]> },
): Limits {
  const here = MASS_PROPERTIES.map((name) => values[name]);
  const { margins, rounding } = core.buildable(space, here, 1);
  /** Whether heads can be built that differ from this one in one of the mass properties each. */
  const areBuilt = (changes: [property: number, value: number][]): boolean[] => {
    if (!changes.length) return [];
    const columns = here.map((own, i) =>
      Float64Array.from(changes, ([property, value]) => (property === i ? value : own)),
    );
    return Array.from(core.buildable(space, columns, changes.length).least, (least) => least >= -rounding);
  };
  const asked = MASS_PROPERTIES.flatMap((name, property) =>
    ranges[name] ? [{ name, property, range: ranges[name] }] : [],
  );
  const at = ([least, most]: readonly [number, number], i: number): number =>
    least + ((most - least) * i) / (SAMPLES - 1);
  const samples = areBuilt(
    asked.flatMap(({ property, range }) =>
      Array.from({ length: SAMPLES }, (_, i): [number, number] => [property, at(range, i)]),
    ),
  );
  // Each end between two samples is found by halving, all of them together.
  const ends: { property: number; inside: number; outside: number }[] = [];
  const intervals = asked.map(({ property, range }, k) => {
    const isBuilt = (i: number): boolean => i >= 0 && i < SAMPLES && samples[k * SAMPLES + i];
    const end = (inside: number, outside: number): { inside: number } => {
      const isEdge = outside < 0 || outside >= SAMPLES;
      const made = { property, inside: at(range, inside), outside: at(range, isEdge ? inside : outside) };
      if (!isEdge) ends.push(made);
      return made;
    };
    const result: [{ inside: number }, { inside: number }][] = [];
    for (let i = 0; i < SAMPLES; i += 1) {
      if (isBuilt(i) && !isBuilt(i - 1)) result.push([end(i, i - 1), { inside: at(range, i) }]);
      if (isBuilt(i) && !isBuilt(i + 1)) result[result.length - 1][1] = end(i, i + 1);
    }
    return result;
  });
  for (let i = 0; i < HALVINGS && ends.length; i += 1) {
    const middles = ends.map(({ property, inside, outside }): [number, number] => [property, (inside + outside) / 2]);
    areBuilt(middles).forEach((isBuilt, j) => {
      if (isBuilt) ends[j].inside = middles[j][1];
      else ends[j].outside = middles[j][1];
    });
  }
  const allowed = asked.map(({ name }, k): [string, [number, number][]] => [
    name,
    intervals[k].map(([least, most]) => [least.inside, most.inside]),
  ]);
  return { margins, rounding, allowed: Object.fromEntries(allowed) };
}

/** What the ellipse of landings holds, and which shots are drawn: the same for all clubs. */
const ELLIPSE = 0.9;
const SEED = 1;

function dispersion(core: LoadedCore, { strike, golfer }: Setup, count: number): Dispersion {
  const { model, inputs, parameters } = strike;
  const launched = new Set(core.description.outputs.map(({ name }) => name));
  const flight = flightInputs(core, strike, Object.fromEntries([...launched].map((name) => [name, 0])));
  const setup = { model, inputs, parameters, flight, golfer, seed: SEED, ellipses: [ELLIPSE] };
  return core.dispersion(setup, count).text;
}

/** The shots of a golfer with two clubs. */
export function computeAverage(
  core: LoadedCore,
  { own, designed, count }: { own: Setup; designed: Setup; count: number },
  report: Report,
): { own: Dispersion; designed: Dispersion } {
  const first = dispersion(core, own, count);
  report(0.5);
  return { own: first, designed: dispersion(core, designed, count) };
}

/** What is looked for: an output of the strike, or a mean or spread of the golfer's shots. */
export interface Objective {
  output: string;
  part: "value" | "mean" | "spread";
  /** 1 where more is better, -1 where less is. */
  sign: number;
}

export interface OptimumInput {
  setup: Setup;
  objective: Objective;
  axes: [ChartAxis, ChartAxis];
  space: Space;
  /** Points along each axis, and shots of a golfer at each point. */
  points: number;
  shots: number;
}

export interface ChartAxis {
  name: string;
  range: readonly [number, number];
  /** The greatest value by the rules; Infinity where there is none. */
  most: number;
}

export interface Optimum {
  axes: [ChartAxis, ChartAxis];
  objective: Objective;
  /** Places along both axes [SI], and values, one row of the first axis after the other. */
  x: number[];
  y: number[];
  values: Float64Array;
  /** Smallest margins of heads on a finer grid over the same axes, and what they may be below 0 where they can be built. */
  margins: { columns: number; values: Float64Array; rounding: number };
  /** Whether each of `values` is of a head that can be built, and is within the rules. */
  isAllowed: boolean[];
  best: { x: number; y: number; value: number } | null;
  here: number;
  /** How the value grows along both axes, by differences [SI]; null for one strike, whose derivatives are exact. */
  slopes: [number, number] | null;
}

type Point = [x: number, y: number];

/** Halvings of the grid about its best point, and the step of differences as a part of an axis. */
const REFINED = 6;
const STEP = 0.01;

/** Points along each axis of the area that can be built. */
const FINE = 49;

const placesOf = (axes: ChartAxis[], count: number): number[][] =>
  axes.map(({ range: [least, most] }) =>
    Array.from({ length: count }, (_, i) => least + ((most - least) * i) / (count - 1)),
  );

function gridOf(axes: ChartAxis[], count: number): Point[] {
  const [across, upwards] = placesOf(axes, count);
  return upwards.flatMap((y) => across.map((x): Point => [x, y]));
}

export function computeOptimum(core: LoadedCore, input: OptimumInput, report: Report): Optimum {
  const { setup, objective, axes, space, points: count } = input;
  const places = placesOf(axes, count);
  const grid = gridOf(axes, count);
  const values = valuesAt(core, input, grid, report);
  const margins = (points: Point[]): { least: Float64Array; rounding: number } => {
    const columns = MASS_PROPERTIES.map((name) => {
      const own = setup.strike.inputs[setup.names.indexOf(name)];
      return Float64Array.from(points, (point) => point[axes.findIndex((axis) => axis.name === name)] ?? own);
    });
    return core.buildable(space, columns, points.length);
  };
  const areAllowed = (points: Point[]): boolean[] => {
    const { least, rounding } = margins(points);
    const isWithin = (point: Point): boolean => axes.every(({ most }, i) => point[i] <= most * (1 + rounding));
    return points.map((point, i) => least[i] >= -rounding && isWithin(point));
  };
  const isAllowed = areAllowed(grid);
  const fineMargins = margins(gridOf(axes, FINE));
  const merit = (value: number): number => (Number.isFinite(value) ? objective.sign * value : -Infinity);
  let best: Optimum["best"] = null;
  grid.forEach(([x, y], i) => {
    if (isAllowed[i] && merit(values[i]) > (best ? merit(best.value) : -Infinity)) best = { x, y, value: values[i] };
  });
  const steps = axes.map(({ range: [least, most] }) => (most - least) / (count - 1));
  for (let halving = 1; best && halving <= REFINED; halving += 1) {
    const { x, y, value } = best as { x: number; y: number; value: number };
    const around = [-1, 0, 1]
      .flatMap((i) =>
        [-1, 0, 1].map((j): Point => [x + (i * steps[0]) / 2 ** halving, y + (j * steps[1]) / 2 ** halving]),
      )
      .filter((point) => axes.every(({ range: [least, most] }, i) => point[i] >= least && point[i] <= most));
    const isFine = areAllowed(around);
    const tried = valuesAt(core, input, around, () => undefined);
    let top = value;
    around.forEach((point, i) => {
      if (!isFine[i] || !(merit(tried[i]) > merit(top))) return;
      top = tried[i];
      best = { x: point[0], y: point[1], value: tried[i] };
    });
  }
  const inputOf = ({ name }: ChartAxis): number => setup.strike.inputs[setup.names.indexOf(name)];
  const here: Point = [inputOf(axes[0]), inputOf(axes[1])];
  const shifts = axes.map(({ range: [least, most] }) => STEP * (most - least));
  const neighbours: Point[] = [
    here,
    [here[0] + shifts[0], here[1]],
    [here[0] - shifts[0], here[1]],
    [here[0], here[1] + shifts[1]],
    [here[0], here[1] - shifts[1]],
  ];
  const near = valuesAt(core, input, setup.golfer ? neighbours : [here], () => undefined);
  const slopes: Optimum["slopes"] = setup.golfer
    ? [(near[1] - near[2]) / (2 * shifts[0]), (near[3] - near[4]) / (2 * shifts[1])]
    : null;
  return {
    axes,
    objective,
    x: places[0],
    y: places[1],
    values,
    margins: { columns: FINE, values: fineMargins.least, rounding: fineMargins.rounding },
    isAllowed,
    best,
    here: near[0],
    slopes,
  };
}

/** The objective at points of the chart; NaN where there is no shot. */
function valuesAt(core: LoadedCore, input: OptimumInput, points: Point[], report: Report): Float64Array {
  const { setup, objective, axes, shots } = input;
  const setups = points.map((point) => withClub(setup, { [axes[0].name]: point[0], [axes[1].name]: point[1] }));
  if (!setup.golfer) return strikesAt(core, setups, objective.output);
  return Float64Array.from(setups, (each, i) => {
    report(i / setups.length);
    try {
      const { mean, spread } = dispersion(core, each, shots).quantities[objective.output];
      return objective.part === "spread" ? spread : mean;
    } catch {
      return Number.NaN; // no shot of this club has a result
    }
  });
}

/** An output of the launch or of the flight of many strikes of one model. */
function strikesAt(core: LoadedCore, setups: Setup[], output: string): Float64Array {
  const { outputs, flight_outputs } = core.description;
  const [{ strike }] = setups;
  const rows = setups.length;
  const columns = strike.inputs.map((_, i) => Float64Array.from(setups, (each) => each.strike.inputs[i]));
  const launch = core.launches(strike.model, columns, strike.parameters, rows);
  const launched = outputs.findIndex(({ name }) => name === output);
  if (launched >= 0) return launch.outputs[launched];
  const usual = flightInputs(core, strike, {});
  const flights = core.description.flight_inputs.map(({ name }, i) => {
    const place = outputs.findIndex((each) => each.name === name);
    return place < 0 ? usual[i] : launch.outputs[place];
  });
  return core.flights(flights, rows).outputs[flight_outputs.findIndex(({ name }) => name === output)];
}
