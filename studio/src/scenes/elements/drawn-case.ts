/** A case whose impact is drawn, and the colours of all of them together. */

import { type Context, choiceSetting } from "../../context";
import type { ElementsImpact } from "../../core/elements";
import { bothSides, type ColourScale, rising, roundUp } from "../../parts/colours";
import type { NamedCase } from "./numbers";
import { patchLimits, type Traction } from "./patch";
import { displacements, frameAt, most, speeds } from "./shape-fields";

/** A case whose impact can be drawn, at its moment. */
export interface DrawnCase extends NamedCase {
  impact: ElementsImpact;
  frame: number;
  moment: number;
}

export const drawnCase = (each: NamedCase & { impact: ElementsImpact }, moment: number): DrawnCase => {
  const frame = frameAt(each.impact, moment);
  return { ...each, frame, moment: each.impact.times[frame] };
};

export interface Scales {
  shape: ColourScale;
  patch: Record<Traction, ColourScale>;
  /** Half the side of the maps of the patch [m]. */
  reach: number;
}

/** The scales of all cases together, so that the same colour means the same. */
export function scales(context: Context, cases: DrawnCase[]): Scales {
  const largest = (of: (impact: ElementsImpact) => number): number =>
    Math.max(0, ...cases.map(({ impact }) => of(impact)));
  const field = choiceSetting(context, "colour") === "speed" ? speeds : displacements;
  const limits = (name: keyof ReturnType<typeof patchLimits>) => largest((impact) => patchLimits(impact)[name]);
  return {
    shape: rising(roundUp(largest((impact) => most(impact, field)))),
    patch: { normal: rising(roundUp(limits("normal"))), tangential: bothSides(roundUp(limits("tangential"))) },
    reach: 1.1 * Math.max(5e-3, limits("reach")),
  };
}
