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

/** What the colours of a shape mean: the quantity that gives unit and digits, and a title. */
export const SHAPE_COLOURS: Record<string, [quantity: string, title: string]> = {
  displacement: ["penetration", "Displacement about the mass centre"],
  speed: ["ball_velocity", "Speed over the ground"],
};

/** The scales of all cases together, so that the same colour means the same. */
export function scales(context: Context, cases: DrawnCase[]): Scales {
  const largest = (of: (impact: ElementsImpact) => number): number =>
    Math.max(0, ...cases.map(({ impact }) => of(impact)));
  const field = choiceSetting(context, "colour") === "speed" ? speeds : displacements;
  const limits = (name: keyof ReturnType<typeof patchLimits>) => largest((impact) => patchLimits(impact)[name]);
  const { formatter, state } = context;
  /** A round number in the unit that people read, in SI. */
  const end = (value: number, quantity: string): number => {
    const { unit } = formatter.reading(quantity, state.system);
    return formatter.units.toSi({ value: roundUp(formatter.units.fromSi(value, unit)), unit });
  };
  const [quantity] = SHAPE_COLOURS[choiceSetting(context, "colour")] ?? SHAPE_COLOURS.displacement;
  return {
    shape: rising(
      end(
        largest((impact) => most(impact, field)),
        quantity,
      ),
    ),
    patch: {
      normal: rising(end(limits("normal"), "stress")),
      tangential: bothSides(end(limits("tangential"), "stress")),
    },
    reach: 1.1 * Math.max(5e-3, limits("reach")),
  };
}
