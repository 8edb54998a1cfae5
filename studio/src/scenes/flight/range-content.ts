/** What flies over the range: flights with their names and colours, and the landings of a golfer. */

import { type Context, choiceSetting } from "../../context";
import type { Dispersion, Shot, Values } from "../../core/types";
import { seriesLook } from "../../parts/colours";
import type { Vector } from "../../parts/vectors";
import { outputOf } from "../../state/store";

export interface Flying {
  name: string;
  /** Variable of the page that holds its colour. */
  colour: string;
  isDashed: boolean;
  values: Values;
  /** Positions [m] of the moments [s]; the last one is the landing. */
  path: Vector[];
  times: ArrayLike<number>;
  rest: Vector;
}

export interface Content {
  flights: Flying[];
  /** Landings of a golfer, ahead and to the right by turns [m], and the ellipses that hold shares of them. */
  landings: ArrayLike<number>;
  ellipses: Dispersion["ellipses"];
}

const NONE: Content = { flights: [], landings: [], ellipses: [] };

export function contentOf(context: Context): Content {
  const { model, equipment, state } = context;
  const flying = choiceSetting(context, "flying");
  if (flying === "clubs") {
    const bag = (outputOf(model, "bag") ?? []).filter(({ failure }) => !failure);
    const flights = bag.map((shot, i) => {
      const { number, isDashed } = seriesLook(i);
      return flight(equipment.clubs[shot.club].label, { colour: `--series-${number}`, isDashed }, shot);
    });
    return { ...NONE, flights };
  }
  const shot = model.good;
  const flights = shot
    ? [flight(equipment.clubs[state.club].label, { colour: "--flight", isDashed: false }, shot)]
    : [];
  const shots = flying === "golfer" ? outputOf(model, "dispersion") : null;
  return { flights, landings: shots?.landings.values ?? [], ellipses: shots?.ellipses ?? [] };
}

function flight(name: string, look: Pick<Flying, "colour" | "isDashed">, { path, times, values }: Shot): Flying {
  const points: Vector[] = [];
  for (let i = 0; i + 2 < path.length; i += 3) points.push([path[i], Math.max(path[i + 1], 0), path[i + 2]]);
  const { total, total_side } = values;
  const rest: Vector = [Math.sqrt(Math.max(total ** 2 - total_side ** 2, 0)), 0, total_side];
  return { name, ...look, values, path: points, times, rest };
}

/** Extent of what is drawn: how far ahead, to either side and up [m]. */
export interface Extent {
  far: number;
  side: number;
  high: number;
}

/** An extent in whole steps, so that it stays while little changes. */
export function extentOf({ flights, landings }: Content, step: number): Extent {
  let [far, side, high] = [step, 0.6 * step, step / 5];
  const cover = ([x, y, z]: Vector): void => {
    [far, side, high] = [Math.max(far, x), Math.max(side, Math.abs(z)), Math.max(high, y)];
  };
  for (const { path, rest } of flights) for (const point of [...path, rest]) cover(point);
  for (let i = 0; i + 1 < landings.length; i += 2) cover([landings[i], 0, landings[i + 1]]);
  const upTo = (value: number, size: number): number => Math.ceil((value * 1.02) / size) * size;
  return { far: upTo(far, step / 2), side: upTo(side, step / 5), high: upTo(high, step / 10) };
}

/** Points of an ellipse of landings, ahead and to the right. */
export function outline({ centre, half_axes, angle }: Dispersion["ellipses"][number], count: number): Vector[] {
  return Array.from({ length: count }, (_, i) => {
    const turn = (2 * Math.PI * i) / count;
    const [long, short] = [half_axes[0] * Math.cos(turn), half_axes[1] * Math.sin(turn)];
    const [cos, sin] = [Math.cos(angle), Math.sin(angle)];
    return [centre[0] + long * cos - short * sin, 0, centre[1] + long * sin + short * cos];
  });
}
