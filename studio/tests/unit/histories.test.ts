import { expect, test } from "vitest";
import type { History } from "../../src/core/types";
import { historyCharts } from "../../src/scenes/models/histories";

const array = (values: number[], width = 1) => ({
  values: Float64Array.from(values),
  shape: [values.length / width, width],
});
/** The face drags the ball's surface down, and then lets it spring back. */
const history = {
  model: "rings",
  arrays: {
    time: array([0, 1e-4, 2e-4]),
    normal_force: array([0, 9e3, 0]),
    force_y: array([0, -900, 300]),
    sliding_y: array([5, 1, -1]),
    ball_spin: array([0, 0, 0, 0, 0, 300, 0, 0, 250], 3),
  },
} as unknown as History;

test("friction down the face, which makes backspin, is drawn above zero, as in the finite elements", () => {
  const friction = historyCharts({ models: [] }, [history]).find(({ y }) => y.quantity === "tangential");
  expect(Array.from(friction?.lines[0].y ?? [], (force) => force + 0)).toEqual([0, 900, -300]);
});
