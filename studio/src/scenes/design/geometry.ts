/** Where face, CG and sweet spot stand in drawings of a head at its static loft: x to the target, y up, z to the toe. */

import type { Values } from "../../core/types";

/** Along the face normal, up the face and towards the toe, from the face centre [m]. */
export type InFace = [out: number, up: number, toe: number];

/** A point in the axes of the club from one in those of its face. */
export function inClub([out, up, toe]: InFace, loft: number): [x: number, y: number, z: number] {
  return [out * Math.cos(loft) - up * Math.sin(loft), out * Math.sin(loft) + up * Math.cos(loft), toe];
}

/** The CG in the axes of the face. */
export function cgInFace({ cg_x, cg_y, cg_z, static_loft }: Values): InFace {
  const [cosine, sine] = [Math.cos(static_loft), Math.sin(static_loft)];
  return [-cg_x * cosine - cg_y * sine, cg_x * sine - cg_y * cosine, -cg_z];
}

/** A point of the face, up the face and towards the toe: how far a curved face falls back there. */
export function onFace(up: number, toe: number, { bulge, roll }: Values): InFace {
  const back = (at: number, radius: number): number =>
    Number.isFinite(radius) ? radius - Math.sqrt(Math.max(0, radius ** 2 - at ** 2)) : 0;
  return [-back(toe, bulge) - back(up, roll), up, toe];
}

/** Where the normal of the face passes through the CG. */
export function sweetSpot(values: Values): InFace {
  const [out, up, toe] = cgInFace(values);
  const across = (at: number, radius: number): number =>
    Number.isFinite(radius) ? (radius * at) / Math.hypot(radius + out, at) : at;
  return onFace(across(up, values.roll), across(toe, values.bulge), values);
}
