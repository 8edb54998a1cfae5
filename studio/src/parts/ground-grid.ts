/** The ground below flights that are seen from above: lines of distance, places to either side, the target line. */

import { svg, type TemplateResult } from "lit-html";
import { type Formatter, sideOf } from "../quantities/formatter";
import { type Scale, ticks } from "./axes";

/** Pixels on the left for the places to either side. */
export const GROUND_LEFT = 44;
/** Pixels below for the distances. */
export const GROUND_BOTTOM = 36;

export interface Ground {
  /** From distances towards the target and to the right to places in the picture. */
  along: Scale;
  right: Scale;
  alongTicks: readonly number[];
  /** Distances to the right at the upper and the lower edge. */
  across: readonly [number, number];
  /** Pixels of the whole picture to its right end, and of the upper and the lower edge of the ground. */
  width: number;
  top: number;
  bottom: number;
  /** The unit of distances, as it is printed. */
  unit: string;
}

export function groundGrid(formatter: Formatter, ground: Ground): TemplateResult {
  const { along, right, alongTicks, across, width, top, bottom, unit } = ground;
  const { sides } = formatter.quantity("side");
  /** "L" or "R" behind a distance, as the first letters of the core's words for its sides. */
  const letter = (tick: number): string => ` ${sideOf(sides, tick, 0).charAt(0).toUpperCase()}`.trimEnd();
  return svg`
    ${alongTicks.map(
      (tick) => svg`
        <line class="grid" x1=${along.at(tick)} x2=${along.at(tick)} y1=${top} y2=${bottom}></line>
        <text class="tick" x=${along.at(tick)} y=${bottom + 15} text-anchor="middle">${tick}</text>`,
    )}
    ${ticks(across, 5).map(
      (tick) => svg`<text class="tick" x=${GROUND_LEFT - 6} y=${right.at(tick) + 4} text-anchor="end">
        ${Math.abs(tick)}${letter(tick)}</text>`,
    )}
    <line class="target" x1=${GROUND_LEFT} x2=${width} y1=${right.at(0)} y2=${right.at(0)}></line>
    <text class="tick" x=${width - 2} y=${bottom + GROUND_BOTTOM - 4} text-anchor="end">
      distance towards the target, ${unit}
    </text>` as TemplateResult;
}
