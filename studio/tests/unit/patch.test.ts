import { describe, expect, test } from "vitest";
import type { ElementsImpact } from "../../src/core/elements";
import { bothSides, rising, roundUp } from "../../src/parts/colours";
import { middleLine, patchAt, patchLimits, senses } from "../../src/scenes/elements/patch";
import { valueAt } from "../../src/scenes/elements/shape-fields";

const array = (...values: number[]): { values: Float64Array; shape: number[] } => ({
  values: Float64Array.from(values),
  shape: [values.length],
});

/** Two records of a patch: two nodes at 5 us, three at 10 us; the ball has left at 15 us. */
const impact = {
  arrays: {
    "motion.time": array(0, 5e-6, 10e-6, 15e-6, 20e-6),
    "motion.radius": array(0.02, 0.019, 0.018, 0.019, 0.02),
    "patch.time": array(5e-6, 5e-6, 10e-6, 10e-6, 10e-6),
    "patch.up": array(-1e-3, 1e-3, -2e-3, 0, 2e-3),
    "patch.toe": array(0, 0, 0, 0, 3e-3),
    "patch.area": array(4e-6, 4e-6, 4e-6, 4e-6, 4e-6),
    "patch.normal": array(40, 40, 80, 120, 80),
    "patch.tangential": array(10, 10, 20, -4, -8),
  },
} as unknown as ElementsImpact;

describe("pressure and shear", () => {
  test("are those of the record next to a moment, and none where the ball does not touch", () => {
    expect(patchAt(impact, 6e-6)).toHaveLength(2);
    expect(patchAt(impact, 9e-6)).toHaveLength(3);
    expect(patchAt(impact, 20e-6)).toHaveLength(0);
  });

  test("have limits over the whole impact, of either sign", () => {
    expect(patchLimits(impact)).toEqual({ normal: 120 / 4e-6, tangential: 20 / 4e-6, reach: 3e-3 });
  });

  test("make backspin and take it", () => {
    expect(senses(patchAt(impact, 10e-6))).toEqual([20, -12]);
  });

  test("have a line up the face through the middle", () => {
    expect(middleLine(patchAt(impact, 10e-6)).map(({ up }) => up)).toEqual([-2e-3, 0]);
  });
});

test("a value between two records lies between theirs", () => {
  expect(valueAt(impact, "motion", "radius", 7.5e-6)).toBeCloseTo(0.0185, 12);
  expect(valueAt(impact, "motion", "radius", 1)).toBe(0.02);
});

describe("colours", () => {
  test("of both signs are pale at zero, and as strong on either side", () => {
    const scale = bothSides(10);
    expect(Math.min(...scale.at(0))).toBeGreaterThan(230);
    expect(scale.at(-10)).not.toEqual(scale.at(10));
    expect(scale.at(99)).toEqual(scale.at(10));
  });

  test("that rise begin at zero and become brighter", () => {
    const scale = rising(4);
    const brightness = [0, 1, 2, 3, 4].map((value) => {
      const [red, green, blue] = scale.at(value);
      return 0.2126 * red + 0.7152 * green + 0.0722 * blue;
    });
    for (let i = 1; i < brightness.length; i += 1) expect(brightness[i]).toBeGreaterThan(brightness[i - 1]);
  });

  test("end at a round number that is not below the largest value", () => {
    expect([0.0061, 37, 40, 41, 99].map(roundUp)).toEqual([0.008, 40, 40, 50, 100]);
    expect(roundUp(0)).toBe(1);
  });
});
