/** Pressure and shear between ball and face: what each node of the patch carries, as maps over the face. */

import type { ElementsImpact } from "../../core/elements";
import type { ColourScale } from "../../parts/colours";

/** Quantities of the patch: the force over the part of the surface that belongs to a node [Pa]. */
export const TRACTIONS = ["normal", "tangential"] as const;
export type Traction = (typeof TRACTIONS)[number];

export interface PatchPoint {
  /** From the mass centre of the ball [m]. */
  up: number;
  toe: number;
  area: number;
  /** Forces [N], the second positive where it makes backspin. */
  normal: number;
  tangential: number;
}

interface Moments {
  times: number[];
  /** Where each begins among the points, and where the last ends. */
  starts: number[];
}
const known = new WeakMap<ElementsImpact, Moments>();

function momentsOf(impact: ElementsImpact): Moments {
  const before = known.get(impact);
  if (before) return before;
  const { values } = impact.arrays["patch.time"];
  const result: Moments = { times: [], starts: [] };
  values.forEach((time, i) => {
    if (i && values[i - 1] === time) return;
    result.times.push(time);
    result.starts.push(i);
  });
  result.starts.push(values.length);
  known.set(impact, result);
  return result;
}

/** The nodes that touch at the record next to a moment; none where the ball does not touch. */
export function patchAt(impact: ElementsImpact, moment: number): PatchPoint[] {
  const { times, starts } = momentsOf(impact);
  const records = impact.arrays["motion.time"].values;
  const interval = records.length > 1 ? records[1] - records[0] : Number.POSITIVE_INFINITY;
  let best = 0;
  times.forEach((time, i) => {
    if (Math.abs(time - moment) < Math.abs(times[best] - moment)) best = i;
  });
  if (!times.length || Math.abs(times[best] - moment) > interval) return [];
  const value = (name: string, i: number): number => impact.arrays[`patch.${name}`].values[i];
  return Array.from({ length: starts[best + 1] - starts[best] }, (_, k) => {
    const i = starts[best] + k;
    const [up, toe, area, normal, tangential] = ["up", "toe", "area", "normal", "tangential"].map((name) =>
      value(name, i),
    );
    return { up, toe, area, normal, tangential };
  });
}

export const traction = (point: PatchPoint, name: Traction): number => point[name] / point.area;

export interface PatchLimits {
  /** Largest pressure and shear, with either sign [Pa]. */
  normal: number;
  tangential: number;
  /** How far from the middle the patch reaches [m]. */
  reach: number;
}

/** The largest values of a whole impact. */
export function patchLimits({ arrays }: ElementsImpact): PatchLimits {
  const [area, up, toe] = ["area", "up", "toe"].map((name) => arrays[`patch.${name}`].values);
  const largest = (values: Float64Array, by: (i: number) => number): number =>
    values.reduce((greatest, value, i) => Math.max(greatest, Math.abs(value) / by(i)), 0);
  return {
    normal: largest(arrays["patch.normal"].values, (i) => area[i]),
    tangential: largest(arrays["patch.tangential"].values, (i) => area[i]),
    reach: Math.max(
      largest(up, () => 1),
      largest(toe, () => 1),
    ),
  };
}

/** The force along the face by its sense [N]: what makes backspin, and what takes it (below zero). */
export const senses = (points: PatchPoint[]): [makes: number, takes: number] =>
  points.reduce<[number, number]>(
    ([makes, takes], { tangential }) => [makes + Math.max(0, tangential), takes + Math.min(0, tangential)],
    [0, 0],
  );

/** The nodes on the line up the face through the middle, from below. */
export function middleLine(points: PatchPoint[]): PatchPoint[] {
  const nearest = Math.min(...points.map(({ toe }) => Math.abs(toe)));
  const near = points.filter(({ toe, area }) => Math.abs(toe) < nearest + 0.3 * Math.sqrt(area));
  return near.sort((a, b) => a.up - b.up);
}

export interface PatchMap {
  points: PatchPoint[];
  name: Traction;
  scale: ColourScale;
  /** Half the side of the map [m]. */
  reach: number;
  /** 1 where the toe is on the right, -1 on the left. */
  side: number;
  ink: string;
  line: string;
}

/** Cells of a map along one side: each has the colour of the node that is nearest. */
const CELLS = 120;
/** Distance between lines [m]. */
const GRID = 5e-3;

export function drawPatch(canvas: HTMLCanvasElement, map: PatchMap): void {
  const context = canvas.getContext("2d");
  if (!context) return;
  const { width } = canvas;
  context.clearRect(0, 0, width, width);
  const { points, scale, reach, side, name } = map;
  const cell = width / CELLS;
  for (let row = 0; row < CELLS; row += 1)
    for (let column = 0; column < CELLS; column += 1) {
      const toe = (((column + 0.5) / CELLS) * 2 - 1) * reach * side;
      const up = (1 - ((row + 0.5) / CELLS) * 2) * reach;
      const point = nearest(points, up, toe);
      if (!point) continue;
      context.fillStyle = `rgb(${scale.at(traction(point, name)).join(" ")})`;
      context.fillRect(Math.floor(column * cell), Math.floor(row * cell), Math.ceil(cell), Math.ceil(cell));
    }
  context.lineWidth = Math.max(1, width / 400);
  const at = (value: number): number => ((value / reach + 1) / 2) * width;
  for (let place = -Math.floor(reach / GRID) * GRID; place <= reach; place += GRID) {
    context.strokeStyle = Math.abs(place) < 1e-9 ? map.ink : map.line;
    context.globalAlpha = Math.abs(place) < 1e-9 ? 0.6 : 0.4;
    context.beginPath();
    context.moveTo(at(place), 0);
    context.lineTo(at(place), width);
    context.moveTo(0, at(place));
    context.lineTo(width, at(place));
    context.stroke();
  }
  context.globalAlpha = 1;
}

/** The node next to a place, if the place belongs to its part of the surface. */
function nearest(points: PatchPoint[], up: number, toe: number): PatchPoint | undefined {
  let [best, distance]: [PatchPoint | undefined, number] = [undefined, Number.POSITIVE_INFINITY];
  for (const point of points) {
    const square = (point.up - up) ** 2 + (point.toe - toe) ** 2;
    if (square < distance) [best, distance] = [point, square];
  }
  return best && distance <= 0.55 * best.area ? best : undefined;
}
