import { describe, expect, test } from "vitest";
import { inkOn, luminance, mapPalette } from "../../src/scenes/map/colours";
import { contours, extended, type Field, rangeOf, refined, valueAt } from "../../src/scenes/map/field";
import { deviationsOf } from "../../src/scenes/map/golfer-spread";
import { isOnFace } from "../../src/scenes/map/mapped";
import { levelDigits } from "../../src/scenes/map/scales";

const evenly = (least: number, most: number, count: number): number[] =>
  Array.from({ length: count }, (_, i) => least + (i * (most - least)) / (count - 1));

const fieldOf = (value: (toe: number, high: number) => number, columns = 21, rows = 11): Field => {
  const [toe, high] = [evenly(-0.05, 0.05, columns), evenly(-0.025, 0.025, rows)];
  return { toe, high, values: high.flatMap((up) => toe.map((across) => value(across, up))) };
};

describe("a field", () => {
  const parabola = (toe: number, high: number): number => 70 - 1e3 * (toe ** 2 + 2 * high ** 2);

  test("has its own values at its points, and those of a parabola in between", () => {
    const field = fieldOf(parabola);
    expect(valueAt(field, [0.05, -0.025])).toBeCloseTo(parabola(0.05, -0.025), 12);
    expect(valueAt(field, [0.0123, 0.0071])).toBeCloseTo(parabola(0.0123, 0.0071), 10);
    expect(valueAt(field, [0.06, 0])).toBeNaN();
    const fine = refined(field, 8);
    expect(fine.toe.length).toBe(161);
    expect(fine.high.length).toBe(81);
    for (let i = 0; i < fine.values.length; i += 97) {
      const place: [number, number] = [fine.toe[i % 161], fine.high[Math.floor(i / 161)]];
      expect(fine.values[i]).toBeCloseTo(valueAt(field, place), 10);
    }
  });

  test("is straight where a neighbour has no value, and has none where a corner has none", () => {
    const field = fieldOf((toe, high) => (toe > 0.041 ? Number.NaN : toe + high));
    expect(valueAt(field, [0.0375, 0.001])).toBeCloseTo(0.0385, 12);
    expect(valueAt(field, [0.0475, 0.001])).toBeNaN();
  });

  test("goes on straight beyond what is known, to the corners in two steps", () => {
    const slope = (toe: number, high: number): number => 3 * toe - 2 * high;
    const cut = fieldOf((toe, high) => (toe > 0.041 || high > 0.011 ? Number.NaN : slope(toe, high)));
    const place = 8 * 21 + 19;
    expect([cut.toe[19], cut.high[8], cut.values[place]]).toEqual([expect.closeTo(0.045), expect.closeTo(0.015), NaN]);
    expect(extended(cut).values[place - 21]).toBeCloseTo(slope(0.045, 0.01), 12);
    expect(extended(cut).values[place]).toBeNaN();
    expect(extended(extended(cut)).values[place]).toBeCloseTo(slope(0.045, 0.015), 12);
    expect(extended(cut).values[5]).toBe(cut.values[5]);
  });

  test("has the range of the points that count", () => {
    const { values } = fieldOf((toe) => toe);
    expect(rangeOf(values, () => true)).toEqual([-0.05, 0.05]);
    expect(rangeOf(values, (place) => place % 21 === 10)).toEqual([0, 0]);
    expect(rangeOf([Number.NaN], () => true)).toBeNull();
  });
});

describe("contour lines", () => {
  test("of a cone are one closed circle", () => {
    const lines = contours(
      refined(
        fieldOf((toe, high) => Math.hypot(toe, high), 41, 21),
        4,
      ),
      0.0203,
    );
    expect(lines).toHaveLength(1);
    expect(lines[0][0]).toEqual(lines[0][lines[0].length - 1]);
    for (const [toe, high] of lines[0]) expect(Math.hypot(toe, high)).toBeCloseTo(0.0203, 5);
    const around = lines[0]
      .slice(1)
      .reduce((sum, [x, y], i) => sum + Math.hypot(x - lines[0][i][0], y - lines[0][i][1]), 0);
    expect(around / (2 * Math.PI * 0.0203)).toBeCloseTo(1, 2);
  });

  test("of a slope run from edge to edge, those of a saddle do not cross", () => {
    const [line, ...others] = contours(
      fieldOf((toe) => toe),
      0.0125,
    );
    expect(others).toEqual([]);
    expect(line).toHaveLength(11);
    for (const [toe] of line) expect(toe).toBeCloseTo(0.0125, 12);
    const saddle = contours(
      fieldOf((toe, high) => toe * high, 20, 10),
      1e-9,
    );
    expect(saddle).toHaveLength(2);
    // Each stays where the product is positive.
    for (const part of saddle) expect(new Set(part.map(([toe, high]) => `${toe > 0}, ${high > 0}`)).size).toBe(1);
    expect(
      contours(
        fieldOf(() => 1),
        2,
      ),
    ).toEqual([]);
  });
});

describe("colours", () => {
  test("grow lighter evenly, and away from the middle darker or lighter by the theme", () => {
    const even = mapPalette(false, false);
    const steps = evenly(0, 1, 17).map((share) => luminance(even(share)));
    for (let i = 1; i < steps.length; i += 1) expect(steps[i]).toBeGreaterThan(steps[i - 1]);
    for (const isDark of [false, true]) {
      const sides = mapPalette(true, isDark);
      const middle = luminance(sides(0.5));
      for (const share of [0, 0.2, 0.8, 1]) expect(luminance(sides(share)) < middle).toBe(!isDark);
      // Blue on one side and orange on the other, whatever the theme.
      expect(sides(0.1)[2]).toBeGreaterThan(sides(0.1)[0]);
      expect(sides(0.9)[0]).toBeGreaterThan(sides(0.9)[2]);
    }
  });

  test("carry an ink that can be read", () => {
    for (const palette of [mapPalette(false, false), mapPalette(true, false), mapPalette(true, true)])
      for (const share of evenly(0, 1, 41)) {
        const colour = palette(share);
        const ink = inkOn(colour) === "#000" ? 0 : 1;
        const [dark, light] = [luminance(colour), ink].sort((a, b) => a - b);
        expect((light + 0.05) / (dark + 0.05)).toBeGreaterThan(4.5);
      }
  });
});

test("a point is on the face where it is inside all outlines, whichever way round their corners go", () => {
  const corners: [number, number][] = [
    [-3, -2],
    [2.5, -2],
    [3, -1],
    [3, 1],
    [2, 2],
    [-3, 0],
  ];
  for (const outline of [corners, [...corners].reverse()]) {
    expect(isOnFace([outline], [0, 0])).toBe(true);
    expect(isOnFace([outline], [2, 2])).toBe(true);
    expect(isOnFace([outline], [-2.5, 0.5])).toBe(false);
    expect(
      isOnFace(
        [
          outline,
          [
            [0.5, -1],
            [1, -1],
            [1, 1],
          ],
        ],
        [0, 0],
      ),
    ).toBe(false);
  }
});

test("levels have the decimals that distinguish them", () => {
  expect(levelDigits([100, 120, 140])).toBe(0);
  expect(levelDigits([1, 1.5, 2])).toBe(1);
  expect(levelDigits([-0.02, 0, 0.02])).toBe(2);
  expect(levelDigits([])).toBe(0);
});

test("the spread of a golfer counts mishits as many times as wide as they are", () => {
  const distribution = {
    mean: [0, 0],
    mirrored: [],
    covariance: [
      [4e-6, 0],
      [0, 9e-6],
    ],
  };
  const known = { ...distribution, variables: ["toe", "high"], mishit_share: 0.25, mishit_scale: 3 };
  const [toe, high] = deviationsOf(known);
  expect(toe).toBeCloseTo(0.002 * Math.sqrt(3), 12);
  expect(high).toBeCloseTo(0.003 * Math.sqrt(3), 12);
  expect(deviationsOf({ ...known, variables: ["speed", "high"] })[0]).toBe(0);
});
