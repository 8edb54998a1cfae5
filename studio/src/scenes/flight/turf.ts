/** The ground of the range: turf in stripes, marks of distance and side, the target line, and a ruler of height. */

import type { Group, Mesh, Object3D } from "three";
import type { Stage } from "../../parts/stage";
import { label } from "../../parts/stage-objects";
import type { Vector } from "../../parts/vectors";
import { NARROW } from "./range-camera";
import type { Extent } from "./range-content";
import type { View } from "./settings";

/** Units in which marks are read: its metres, and how it is written. */
export interface Marks {
  metres: number;
  symbol: string;
}

/** Distances between marks, in their unit. */
export const STEP = 50;
const SIDE_STEP = 20;
/** What lies on the ground is drawn in this order, without depth. */
const LAYERS = { turf: -10, stripe: -9, line: -8 };

export function layTurf(stage: Stage, group: Group, extent: Extent, { metres, symbol }: Marks, view: View): void {
  const { three, colour } = stage;
  const half = extent.side + 10 * metres;
  const far = extent.far + STEP * 0.2 * metres;
  const near = -10 * metres;
  const patch = (x: [number, number], z: [number, number], variable: string, order: number): Mesh => {
    const mesh = new three.Mesh(
      new three.PlaneGeometry(x[1] - x[0], z[1] - z[0]).rotateX(-Math.PI / 2),
      new three.MeshBasicMaterial({ color: colour(variable), depthWrite: false }),
    );
    mesh.position.set((x[0] + x[1]) / 2, 0, (z[0] + z[1]) / 2);
    mesh.renderOrder = order;
    return mesh;
  };
  const line = (from: Vector, to: Vector, variable: string): Object3D => {
    const geometry = new three.BufferGeometry().setFromPoints([from, to].map((each) => new three.Vector3(...each)));
    const result = new three.Line(
      geometry,
      new three.LineBasicMaterial({ color: colour(variable), depthWrite: false }),
    );
    result.renderOrder = LAYERS.line;
    return result;
  };
  // Distances stand on the left of the range, or on the right where that is below on the screen.
  // On a narrow picture the labels of the distances stand on the range.
  const isNarrow = stage.camera.aspect < 1.3;
  const isAcross = view === "side" || (view === "above" && stage.camera.aspect >= 1);
  const [marked, anchor] = isAcross ? [half, [0.5, 1] as const] : [-half, [isNarrow ? -0.05 : 1.05, 0.5] as const];
  group.add(patch([near, far], [-half, half], "--turf", LAYERS.turf));
  for (let at = 0; at * metres < far; at += STEP) {
    const ends: [number, number] = [at * metres, Math.min((at + STEP) * metres, far)];
    if ((at / STEP) % 2 === 0) group.add(patch(ends, [-half, half], "--turf-stripe", LAYERS.stripe));
    group.add(line([ends[0], 0, -half], [ends[0], 0, half], "--turf-line"));
    if (at > 0) group.add(label(stage, `${at} ${symbol}`, "--ink", [ends[0], 0, marked], anchor));
  }
  const sideStep = half > 120 * metres ? 2 * SIDE_STEP : SIDE_STEP;
  for (let at = sideStep; at * metres < half; at += sideStep)
    for (const side of [-at, at]) {
      group.add(line([near, 0, side * metres], [far, 0, side * metres], "--turf-line"));
      if (view === "side") continue;
      group.add(label(stage, `${at}`, "--ink", [near, 0, side * metres], isAcross ? [1.1, 0.5] : [0.5, 1]));
    }
  group.add(patch([near, far], [-0.15 * metres, 0.15 * metres], "--ink", LAYERS.line));
  if (view !== "above") ruler();

  /** An upright scale: on the right from behind, and from the side behind the range, with a line for each height. */
  function ruler(): void {
    const step = extent.high > 60 * metres ? 20 : 10;
    const top = Math.ceil(extent.high / (step * metres)) * step;
    const [edge, anchor] =
      view === "side"
        ? [-half, [1.05, 0.5] as const]
        : [Math.min(half, 0.65 * NARROW * extent.far), [isNarrow ? 1.2 : -0.1, 0.5] as const];
    group.add(line([0, 0, edge], [0, top * metres, edge], "--ink"));
    for (let at = step; at <= top; at += step) {
      const high = at * metres;
      const end: Vector = view === "side" ? [far, high, edge] : [0, high, edge - 3 * metres];
      group.add(line([0, high, edge], end, view === "side" ? "--turf-line" : "--ink"));
      group.add(label(stage, at === top ? `${at} ${symbol} high` : `${at}`, "--ink", [0, high, edge], anchor));
    }
  }
}
