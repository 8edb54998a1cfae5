/**
 * The head as it is drawn: the face as it is, and behind it a body that is made up to suit the kind of club, its face
 * and its mass centre. No head is measured here. Points are in face axes, from the face centre [m].
 */

import type { Values } from "../../core/types";
import { times, turned, type Vector } from "../../parts/vectors";
import { faceForward } from "./head-pose";

/** Corners of triangles. */
export interface Surface {
  positions: number[];
  triangles: number[];
}

export interface Tube {
  from: Vector;
  to: Vector;
  radius: number;
}

export interface HeadShape {
  face: Surface;
  body: Surface;
  hosel: Tube;
  shaft: Tube;
}

/** Points around the face, and rings from its centre to its edge. */
const AROUND = 96;
const RINGS = 10;
/** Rings from the face of a wood to its tail. */
const BACK = 28;
/** Depth of the mass centre of a wood over the length of its body. */
const CG_SHARE = 0.38;
/** How much wider and higher a wood is than its face, and where along its length it is widest. */
const WIDER = 0.14;
const WIDEST = 0.35;
const HIGHER = 0.1;
/** Thickness of an iron at its top line and at its sole [m]; the sole of a lofted club is wider. */
const TOP_LINE = 5e-3;
const SOLE = [15e-3, 25e-3] as const;
const STEEP = 60 * (Math.PI / 180);
/** The part of an iron's back that is left when the cavity is cut, and its depth over the thickness. */
const CAVITY = 0.72;
/** Lie by kind of club [rad], which only tilts the shaft that is drawn. */
const LIE: Record<string, number> = { wood: 1.01, hybrid: 1.04, iron: 1.09 };
const HOSEL = { radius: 6.5e-3, length: 60e-3 };
const SHAFT = { radius: 4.5e-3, length: 0.42 };

export function headShape(kind: string, outline: readonly (readonly [number, number])[], columns: Values): HeadShape {
  const edge = evenly(outline, AROUND);
  const place = (toe: number, high: number): Vector => [faceForward(columns, toe, high), high, toe];
  const rings = Array.from({ length: RINGS + 1 }, (_, i) =>
    edge.map(([toe, high]) => place((toe * i) / RINGS, (high * i) / RINGS)),
  );
  const rim = rings[RINGS];
  const backwards = kind === "iron" ? ironBack(rim, columns) : woodBack(rim, columns);
  return { face: skin(rings), body: skin([rim, ...backwards]), ...neck(kind, edge, columns) };
}

/** Points at even distances along a closed line. */
function evenly(corners: readonly (readonly [number, number])[], count: number): [number, number][] {
  const lengths = corners.map(([x, y], i) => {
    const [nextX, nextY] = corners[(i + 1) % corners.length];
    return Math.hypot(nextX - x, nextY - y);
  });
  const whole = lengths.reduce((sum, length) => sum + length, 0);
  const result: [number, number][] = [];
  let [corner, before] = [0, 0];
  for (let i = 0; i < count; i += 1) {
    const wanted = (i * whole) / count;
    while (before + lengths[corner] < wanted && corner < corners.length - 1) {
      before += lengths[corner];
      corner += 1;
    }
    const [x, y] = corners[corner];
    const [nextX, nextY] = corners[(corner + 1) % corners.length];
    const share = lengths[corner] > 0 ? (wanted - before) / lengths[corner] : 0;
    result.push([x + share * (nextX - x), y + share * (nextY - y)]);
  }
  return result;
}

/** Rings of points, each joined to the next. */
function skin(rings: readonly (readonly Vector[])[]): Surface {
  const positions = rings.flat(2);
  const triangles: number[] = [];
  for (let ring = 0; ring + 1 < rings.length; ring += 1)
    for (let i = 0; i < AROUND; i += 1) {
      const [here, next] = [ring * AROUND + i, ring * AROUND + ((i + 1) % AROUND)];
      triangles.push(here, next, here + AROUND, next, next + AROUND, here + AROUND);
    }
  return { positions, triangles };
}

const turn = (a: Vector, angle: number): Vector => turned(a, [0, 0, angle]);

/** Rings behind the face of a wood or hybrid, whose sole is level at the club's own loft. */
function woodBack(rim: readonly Vector[], { static_loft, cg_x, face_width }: Values): Vector[][] {
  const length = Math.min(Math.max(cg_x / CG_SHARE, 0.45 * face_width), 1.1 * face_width);
  const level = rim.map((point) => turn(point, static_loft));
  const lowest = Math.min(...level.map(([, y]) => y));
  const tail = 0.35 * lowest;
  return Array.from({ length: BACK }, (_, k) => {
    const share = 1 - (1 - (k + 1) / BACK) ** 2;
    const past = Math.max(0, (share - WIDEST) / (1 - WIDEST));
    const wide =
      (1 + WIDER * Math.sin((Math.PI / 2) * Math.min(share / WIDEST, 1))) * Math.sqrt(Math.max(0, 1 - past ** 2.2));
    const crown =
      (1 + HIGHER * Math.sin(Math.PI * Math.min(share * 2.2, 1))) * Math.sqrt(Math.max(0, 1 - share ** 1.7));
    const sole = Math.sqrt(Math.max(0, 1 - share ** 3));
    return level.map(([x, y, z]): Vector => {
      const height = tail * share + y * (y > 0 ? crown : sole) * (1 - 0.25 * share);
      return turn([x * (1 - share) - length * share, Math.max(height, lowest), z * wide], -static_loft);
    });
  });
}

/** Rings behind the face of an iron: the rim, its back, and a cavity. */
function ironBack(rim: readonly Vector[], { static_loft }: Values): Vector[][] {
  const heights = rim.map(([, high]) => high);
  const [least, most] = [Math.min(...heights), Math.max(...heights)];
  const sole = SOLE[0] + (SOLE[1] - SOLE[0]) * Math.min(Math.max(static_loft / STEEP, 0), 1);
  const thickness = (high: number): number => TOP_LINE + (sole - TOP_LINE) * ((most - high) / (most - least)) ** 1.5;
  const scaled = (point: Vector, share: number, depth: number): Vector => {
    const [, high, toe] = times(point, share);
    return [-depth * thickness(high), high, toe];
  };
  const rings = [0.25, 0.5, 0.75, 1].map((depth) => rim.map((point) => scaled(point, 1 - 0.03 * depth, depth)));
  const wall = rim.map((point) => scaled(point, CAVITY + 0.12, 1));
  const floor = rim.map((point): Vector => [-0.6 * TOP_LINE, CAVITY * point[1], CAVITY * point[2]]);
  const middle = rim.map((): Vector => [-0.6 * TOP_LINE, 0, 0]);
  return [...rings, wall, floor, middle];
}

function neck(
  kind: string,
  edge: readonly (readonly [number, number])[],
  { static_loft }: Values,
): Pick<HeadShape, "hosel" | "shaft"> {
  const heel = Math.min(...edge.map(([toe]) => toe));
  const heights = edge.map(([, high]) => high);
  const [lowest, highest] = [Math.min(...heights), Math.max(...heights)];
  const lie = LIE[kind] ?? LIE["iron"];
  const upwards: Vector = [0, Math.sin(lie), -Math.cos(lie)];
  const level: Vector = kind === "iron" ? [-4e-3, 0.55 * lowest, heel + 1e-3] : [-14e-3, 0.35 * highest, 0.78 * heel];
  const at = (far: number): Vector =>
    turn([level[0], level[1] + far * upwards[1], level[2] + far * upwards[2]], -static_loft);
  return {
    hosel: { from: at(0), to: at(HOSEL.length), radius: HOSEL.radius },
    shaft: { from: at(HOSEL.length), to: at(SHAFT.length), radius: SHAFT.radius },
  };
}
