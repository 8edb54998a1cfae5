import { readFileSync } from "node:fs";
import { expect, test } from "vitest";
import type { Values } from "../../src/core/types";
import { curveOf, shapeOf } from "../../src/scenes/shot/shot-shape";
import { equipment } from "../described";

type Stored = Record<"azimuth" | "carry" | "side" | "hand" | "curve", number> & { name: string };

const stored = JSON.parse(readFileSync(new URL("shapes.json", import.meta.url), "utf8")) as Stored[];

test("curves and names are those of the package", () => {
  for (const { name, hand, curve, ...values } of stored) {
    expect(curveOf(values)).toBeCloseTo(curve, 9);
    expect(shapeOf(values, equipment.shot_shape, hand)).toBe(name);
  }
  expect(new Set(stored.map(({ name }) => name)).size).toBeGreaterThanOrEqual(12);
});

test("a ball that does not fly has no name", () => {
  const values: Values = { azimuth: 0, carry: 0, side: 0 };
  expect(shapeOf(values, equipment.shot_shape, 1)).toBe("");
});
