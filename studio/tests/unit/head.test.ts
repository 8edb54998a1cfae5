import { readFileSync } from "node:fs";
import { describe, expect, test } from "vitest";
import type { Values } from "../../src/core/types";
import { dot, minus, size, times, type Vector } from "../../src/parts/vectors";
import { poseAt, poseAtImpact } from "../../src/scenes/shot/head-pose";
import { headShape } from "../../src/scenes/shot/head-shape";
import { equipment } from "../described";

interface Stored {
  inputs: Record<string, number | null>;
  ball_from_cg: [number, number, number];
}

const stored = JSON.parse(readFileSync(new URL("poses.json", import.meta.url), "utf8")) as Stored[];
/** Numbers of which JSON has null for infinite ones. */
const valuesOf = (inputs: Record<string, number | null>): Values =>
  Object.fromEntries(Object.entries(inputs).map(([name, value]) => [name, value ?? Infinity]));

test("the head is where the core has it at first touch, for both hands", () => {
  for (const each of stored) {
    const { cg, ball } = poseAtImpact(valuesOf(each.inputs));
    // The last digits: sines and roots come in another order here.
    expect(size(minus(minus(ball, cg), each.ball_from_cg))).toBeLessThan(1e-12);
  }
});

describe("around impact", () => {
  const outputs: Values = {
    velocity_x: 66,
    velocity_y: 14,
    velocity_z: 2,
    spin_x: 3,
    spin_y: 20,
    spin_z: 260,
    club_velocity_x: 28,
    club_velocity_y: 1,
    club_velocity_z: 0.5,
    club_spin_x: 10,
    club_spin_y: -60,
    club_spin_z: 20,
    contact_time: 450e-6,
  };
  const inputs = valuesOf(stored[0].inputs);
  const distance = (time: number): number => {
    const { ball, contact, normal } = poseAt(inputs, outputs, time);
    return dot(minus(ball, contact), normal) / inputs.ball_radius;
  };

  test("the ball touches the face at first touch and at separation, is pressed in between and leaves then", () => {
    expect(distance(0)).toBeCloseTo(1, 12);
    expect(distance(outputs.contact_time)).toBeCloseTo(1, 9);
    expect(poseAt(inputs, outputs, 200e-6).flattened).toBeLessThan(0.95);
    expect(distance(1e-3)).toBeGreaterThan(1.2);
    expect(poseAt(inputs, outputs, 1e-3).flattened).toBe(1);
  });

  test("before and after it, head and ball move as computed", () => {
    const velocity = (time: number, part: "cg" | "ball"): Vector =>
      times(minus(poseAt(inputs, outputs, time + 1e-6)[part], poseAt(inputs, outputs, time)[part]), 1e6);
    expect(size(velocity(-2e-3, "cg"))).toBeCloseTo(40, 6);
    expect(velocity(-2e-3, "ball")).toEqual([0, 0, 0]);
    expect(size(minus(velocity(2e-3, "cg"), [28, 1, 0.5]))).toBeLessThan(1e-6);
    expect(size(minus(velocity(2e-3, "ball"), [66, 14, 2]))).toBeLessThan(1e-6);
  });

  test("a model without contact time has both at once", () => {
    const { ball } = poseAt(inputs, { ...outputs, contact_time: Number.NaN }, 1e-3);
    expect(ball[0]).toBeCloseTo(0.066, 9);
  });
});

test("every club has a head of finite points whose face is in front of its body", () => {
  for (const { kind, outline, columns } of Object.values(equipment.clubs)) {
    const { face, body } = headShape(kind, outline, valuesOf(columns));
    expect([...face.positions, ...body.positions].every(Number.isFinite)).toBe(true);
    expect(Math.max(...body.triangles)).toBe(body.positions.length / 3 - 1);
    // The sole of an iron and the head of a wood or hybrid are at least as deep as this.
    const back = Math.min(...body.positions.filter((_, i) => i % 3 === 0));
    expect(back).toBeLessThan(kind === "iron" ? -0.01 : -0.03);
  }
});
