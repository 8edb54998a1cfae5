/** Plays the flights as long as they last; the eye follows a single ball. */

import type { Group, Mesh } from "three";
import { isMotionReduced } from "../../parts/measure";
import type { Stage } from "../../parts/stage";
import { minus, plus, times as scaled, type Vector } from "../../parts/vectors";
import { followBall } from "./range-camera";
import type { Extent, Flying } from "./range-content";
import type { View } from "./settings";

export interface Played {
  stage: Stage;
  /** What the balls are added to. */
  group: Group;
  flights: Flying[];
  view: View;
  extent: Extent;
  /** Takes in all of the range again. */
  look(): void;
}

/** Time that bounces and roll are shown for, and that the eye then rests [s]. */
const RUN = 2.5;
const REST = 1;
/** Size of a ball as a share of the range: it would not be seen at its own. */
const BALL = 0.008;
/** Time in which the eye comes up to the ball [s]. */
const CATCH_UP = 0.35;

let end: (() => void) | null = null;

/** Ends what is played. */
export function endPlay(): void {
  end?.();
  end = null;
}

/** Shows the flights from the start; without motion it shows start, apex, landing and rest one after the other. */
export function play(range: Played): void {
  endPlay();
  const { stage, group, flights, view, extent, look } = range;
  if (!flights.length) return;
  const { three } = stage;
  const isStill = isMotionReduced();
  const balls = flights.map((): Mesh => {
    const ball = new three.Mesh(
      new three.SphereGeometry(extent.far * BALL, 20, 14),
      new three.MeshStandardMaterial({ color: "white", roughness: 0.4 }),
    );
    group.add(ball);
    return ball;
  });
  const longest = Math.max(...flights.map(({ times }) => times[times.length - 1]));
  const moments = isStill ? stills(flights[0]) : null;
  let frame = 0;
  let last = performance.now();
  const begun = last;
  const show = (now: number): void => {
    if (!stage.renderer.domElement.isConnected) {
      end = null;
      return;
    }
    const elapsed = (now - begun) / 1e3;
    const time = moments ? moments[Math.min(Math.floor(elapsed), moments.length - 1)] : elapsed;
    flights.forEach((flight, i) => {
      const at = placeAt(flight, time);
      balls[i].position.set(at[0], at[1] + extent.far * BALL, at[2]);
    });
    if (flights.length === 1) {
      const share = isStill ? 1 : 1 - Math.exp(-(now - last) / 1e3 / CATCH_UP);
      followBall(stage, view, placeAt(flights[0], time), extent.far, share);
    }
    last = now;
    stage.redraw();
    if (elapsed > (moments ? moments.length : longest + RUN + REST)) {
      endPlay();
      return;
    }
    frame = requestAnimationFrame(show);
  };
  end = () => {
    cancelAnimationFrame(frame);
    for (const ball of balls) {
      ball.removeFromParent();
      ball.geometry.dispose();
    }
    look();
    stage.redraw();
  };
  frame = requestAnimationFrame(show);
}

/** Moments of the start, the apex, the landing and the rest. */
function stills({ path, times }: Flying): number[] {
  const highest = path.reduce((best, each, i) => (each[1] > path[best][1] ? i : best), 0);
  const landed = times[times.length - 1];
  return [0, times[highest], landed, landed + RUN];
}

/** Where a ball is some time after it was struck. */
export function placeAt({ path, times, rest }: Flying, time: number): Vector {
  const last = path.length - 1;
  const between = (a: Vector, b: Vector, share: number): Vector => plus(a, scaled(minus(b, a), share));
  if (time >= times[last]) {
    // Bounces and roll are computed as a whole; the ball is shown to slow down evenly.
    const done = Math.min((time - times[last]) / RUN, 1);
    return between(path[last], rest, 1 - (1 - done) ** 2);
  }
  let next = 1;
  while (next < last && times[next] < time) next += 1;
  const span = times[next] - times[next - 1];
  return between(path[next - 1], path[next], span > 0 ? (time - times[next - 1]) / span : 1);
}
