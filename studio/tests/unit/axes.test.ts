import { expect, test } from "vitest";
import { line, scale, ticks } from "../../src/parts/axes";

test("ticks are round and within the range", () => {
  expect(ticks([0, 250], 5)).toEqual([0, 50, 100, 150, 200, 250]);
  expect(ticks([-12, 12], 3)).toEqual([-10, 0, 10]);
  expect(ticks([0, 0.3], 3).map((tick) => tick.toFixed(1))).toEqual(["0.0", "0.1", "0.2", "0.3"]);
});

test("an empty range has no ticks", () => {
  expect(ticks([1, 1], 5)).toEqual([]);
  expect(ticks([0, Number.NaN], 5)).toEqual([]);
});

test("a scale maps ends to ends, upwards too", () => {
  const up = scale([0, 10], [100, 0]);
  expect([up.at(0), up.at(10), up.size]).toEqual([100, 0, 10]);
});

test("a line goes through its points", () => {
  expect(
    line([
      [0, 1],
      [2, 3],
    ]),
  ).toBe("M0.0 1.0L2.0 3.0");
});
