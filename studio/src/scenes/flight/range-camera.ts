/** Where the range is seen from: three views that take all of it in, and one that follows the ball. */

import type { PerspectiveCamera } from "three";
import type { Stage } from "../../parts/stage";
import { cross, dot, minus, plus, times, unit, type Vector } from "../../parts/vectors";
import type { Extent } from "./range-content";
import type { View } from "./settings";

/** From the middle of the range to the eye; from above the target is on the right, or up where the picture is high. */
const TOWARDS: Record<View, (isHigh: boolean) => Vector> = {
  behind: () => [-1, 0.22, 0],
  side: () => [0, 0.12, 1],
  above: (isHigh) => (isHigh ? [-1e-3, 1, 0] : [0, 1, 1e-3]),
};
/** How far the turf reaches beyond what flies over it, to either side [m]. */
const EDGE = 11;
/** Room for what is written at the edges, as shares of the picture. */
const MARGIN: Record<View, number> = { behind: 1.06, side: 1.1, above: 1.14 };

/** What is always in sight to either side of the tee, as a share of the range. */
export const NARROW = 0.2;

/** Shares of the range at which the eye may look from behind. */
const NEARER = [0.1, 0.15, 0.2, 0.25, 0.3, 0.35, 0.4, 0.45, 0.5];

/** Sets the eye so that all corners of the extent are in the picture. */
export function takeView(stage: Stage, view: View, { far, side, high }: Extent): void {
  const { camera, controls } = stage;
  const [width, height] = view === "side" ? [0, high] : view === "above" ? [side + EDGE, 0] : [side, high];
  // From behind the sides of the range may leave the picture before they come to what flies there.
  const widths = [view === "behind" ? Math.min(width, NARROW * far) : width, width];
  const corners = [0, far].flatMap((x, end) =>
    [0, height].flatMap((y) => [-widths[end], widths[end]].map((z): Vector => [x, y, z])),
  );
  const back = unit(TOWARDS[view](camera.aspect < 1));
  // What is near is large: the eye comes closest when it looks at a point before the middle.
  const looks = (view === "behind" ? NEARER : [0.5]).map((share) => {
    const middle: Vector = [far * share, height / 2, 0];
    const distance = distanceFor(camera, corners, middle, back, MARGIN[view]);
    return { middle, distance, eye: plus(middle, times(back, distance)) };
  });
  const { middle, distance, eye } = looks.reduce((best, each) => (each.eye[0] > best.eye[0] ? each : best));
  camera.near = distance / 200;
  camera.far = distance * 20;
  camera.updateProjectionMatrix();
  camera.position.set(...eye);
  controls.target.set(...middle);
  controls.maxPolarAngle = Math.PI / 2 - 0.02;
  controls.update();
}

/** How far the eye stands back from a point to have all corners in sight. */
function distanceFor(
  camera: PerspectiveCamera,
  corners: Vector[],
  middle: Vector,
  back: Vector,
  margin: number,
): number {
  const right = unit(cross([0, 1, 0], back));
  const up = cross(back, right);
  const upwards = Math.tan((camera.fov * Math.PI) / 360);
  const sideways = upwards * camera.aspect;
  return Math.max(
    ...corners.map((corner) => {
      const from = minus(corner, middle);
      const needed = Math.max(Math.abs(dot(from, right)) / sideways, Math.abs(dot(from, up)) / upwards);
      return dot(from, back) + needed * margin;
    }),
  );
}

/** How far the eye stays from the ball that it follows, as shares of the range. */
const FOLLOWED: Record<View, Vector> = {
  behind: [-0.2, 0.06, 0],
  side: [0, 0.05, 0.3],
  above: [-0.001, 0.4, 0],
};

/** Moves the eye a share of the way to where it follows the ball from. */
export function followBall(
  { camera, controls, three }: Stage,
  view: View,
  ball: Vector,
  far: number,
  share: number,
): void {
  const eye = plus(ball, times(FOLLOWED[view], far));
  camera.position.lerp(new three.Vector3(...eye), share);
  controls.target.lerp(new three.Vector3(...ball), share);
  controls.update();
}
