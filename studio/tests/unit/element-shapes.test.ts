import { describe, expect, test } from "vitest";
import { drawnParts } from "../../src/core/element-shapes";

/** A block of 2 x 2 x 2 cubes about the origin, corners in binary order; the upper half is another piece. */
function block(): { nodes: number[]; elements: number[]; piece: number[] } {
  const at = (i: number, j: number, k: number): number => i + 3 * j + 9 * k;
  const nodes: number[] = [];
  for (let k = 0; k < 3; k += 1)
    for (let j = 0; j < 3; j += 1) for (let i = 0; i < 3; i += 1) nodes.push(i - 1, j - 1, k - 1);
  const [elements, piece]: [number[], number[]] = [[], []];
  for (let k = 0; k < 2; k += 1)
    for (let j = 0; j < 2; j += 1)
      for (let i = 0; i < 2; i += 1) {
        for (let corner = 0; corner < 8; corner += 1)
          elements.push(at(i + (corner & 1), j + ((corner >> 1) & 1), k + (corner >> 2)));
        piece.push(j);
      }
  return { nodes, elements, piece };
}

describe("what is drawn of a mesh", () => {
  const { nodes, elements, piece } = block();
  const drawn = drawnParts(nodes, elements, piece);
  const place = (corner: number): number[] => {
    const node = drawn.nodes[corner];
    return nodes.slice(3 * node, 3 * node + 3);
  };
  const quads = (corners: Uint32Array): number[][][] =>
    Array.from({ length: corners.length / 4 }, (_, i) => Array.from(corners.subarray(4 * i, 4 * i + 4), place));

  test("the surface has four quadrilaterals a side, each with its corners counterclockwise from outside", () => {
    expect(drawn.surface.pieces).toHaveLength(24);
    for (const [a, b, , d] of quads(drawn.surface.corners)) {
      const [u, v] = [b.map((value, i) => value - a[i]), d.map((value, i) => value - a[i])];
      const normal = [u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2], u[0] * v[1] - u[1] * v[0]];
      const outside = normal.findIndex((value) => Math.abs(value) > 0.5);
      expect(normal[outside]).toBe(a[outside]);
    }
  });

  test("the half towards the heel comes first", () => {
    expect(drawn.half).toBe(12);
    quads(drawn.surface.corners).forEach((corners, i) => {
      const middle = corners.reduce((sum, [, , toe]) => sum + toe, 0);
      expect(Math.sign(middle)).toBe(i < drawn.half ? -1 : 1);
    });
  });

  test("the section lies in the middle plane, with the pieces on both sides of their border", () => {
    expect(
      quads(drawn.section.corners)
        .flat()
        .every(([, , toe]) => toe === 0),
    ).toBe(true);
    expect([...drawn.section.pieces].sort()).toEqual([0, 0, 1, 1]);
  });
});
