/** The shape of a shot: how far it curves from the line on which it starts, and what golfers call that. */

import type { Values } from "../../core/types";
import type { ShapeLimits } from "../../equipment/equipment";

/** Distance of the landing from the line on which the ball starts [m]; to the right is positive. */
export function curveOf({ azimuth, carry, side }: Values): number {
  const along = Math.sqrt(Math.max(carry ** 2 - side ** 2, 0));
  return side * Math.cos(azimuth) - along * Math.sin(azimuth);
}

/** What golfers call a shot, such as "pull hook"; "" of one that does not fly. `hand` is 1 or -1. */
export function shapeOf(values: Values, limits: ShapeLimits, hand: number): string {
  const { azimuth, carry } = values;
  if (!(carry > 0)) return "";
  const start = azimuth * hand;
  const curve = (curveOf(values) * hand) / carry;
  const side = Math.abs(start) > limits.straight_start ? (start < 0 ? "pull" : "push") : "";
  const names = curve < 0 ? ["draw", "hook"] : ["fade", "slice"];
  const bend = Math.abs(curve) > limits.big_curve ? names[1] : Math.abs(curve) > limits.straight_curve ? names[0] : "";
  return [side, bend].filter(Boolean).join(" ") || "straight shot";
}
