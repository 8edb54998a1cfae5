import { expect, test } from "vitest";
import { areaBelow, contours, type Grid, type Place } from "../../src/parts/contours";

/** A grid of a function of column and row. */
function gridOf(columns: number, rows: number, value: (column: number, row: number) => number): Grid {
  const values = Array.from({ length: columns * rows }, (_, i) => value(i % columns, Math.floor(i / columns)));
  return { columns, rows, values };
}

const areaOf = (polygon: Place[]): number =>
  Math.abs(
    polygon.reduce((sum, [x, y], i) => {
      const [nextX, nextY] = polygon[(i + 1) % polygon.length];
      return sum + (x * nextY - nextX * y) / 2;
    }, 0),
  );

test("the contour of a plane is its straight line", () => {
  const lines = contours(
    gridOf(6, 5, (x, y) => 2 * x + y),
    4.5,
  );
  expect(lines).toHaveLength(1);
  expect(lines[0].length).toBeGreaterThan(5);
  for (const [x, y] of lines.flat()) expect(2 * x + y).toBeCloseTo(4.5, 12);
});

test("the contour of a cone is a circle, closed", () => {
  const lines = contours(
    gridOf(41, 41, (x, y) => Math.hypot(x - 20, y - 20)),
    12,
  );
  // Between two points the cone is taken for straight: at most 1 / (8 * 11) off.
  for (const [x, y] of lines.flat()) expect(Math.abs(Math.hypot(x - 20, y - 20) - 12)).toBeLessThan(1 / (8 * 11));
  expect(lines).toHaveLength(1);
  expect(lines[0][lines[0].length - 1]).toEqual(lines[0][0]);
});

test("the area below a level of a plane is that part of the grid", () => {
  const polygons = areaBelow(
    gridOf(11, 11, (x) => x),
    3.25,
  );
  expect(polygons.map(areaOf).reduce((sum, each) => sum + each, 0)).toBeCloseTo(32.5, 9);
});

test("what has no value is below every level, and has no contour", () => {
  const grid = gridOf(3, 3, () => Number.NaN);
  expect(areaBelow(grid, -1e9).map(areaOf)).toEqual([1, 1, 1, 1]);
  expect(contours(grid, 0)).toEqual([]);
});
