import { expect, test } from "vitest";
import { isApart, type Named, placeLabels } from "../../src/parts/place-labels";

/** Twelve landings one behind the other, as a bag's clubs have them seen from behind on a phone. */
const LANDINGS = Array.from({ length: 12 }, (_, i): Named => ({ at: [170, 100 + 7 * i], width: 60, height: 18 }));
const PHONE = { width: 340, height: 340 };

test("names cover neither each other nor a point nor what stands already, and stay in the picture", () => {
  const mark = { x: 60, y: 130, width: 50, height: 18 };
  const boxes = placeLabels(LANDINGS, PHONE, { taken: [mark], places: [] }).filter((box) => box !== null);
  expect(boxes.length).toBeGreaterThan(6);
  const points = LANDINGS.map(({ at: [x, y] }) => ({ x, y, width: 0, height: 0 }));
  boxes.forEach((box, i) => {
    expect([mark, ...points, ...boxes.slice(0, i)].every((other) => isApart(box, other))).toBe(true);
    expect(Math.abs(box.x - 170) + box.width / 2).toBeLessThanOrEqual(170);
    expect(Math.abs(box.y - 170) + box.height / 2).toBeLessThanOrEqual(170);
  });
});

test("the first name stands next to its point, and what has no room is left out", () => {
  const [first] = placeLabels(LANDINGS, PHONE);
  expect(Math.abs((first?.x ?? 0) - 170)).toBeLessThan(60);
  expect(first?.y).toBe(100);
  const small = placeLabels(LANDINGS, { width: 340, height: 120 });
  expect(small.some((box) => box === null)).toBe(true);
  expect(placeLabels(LANDINGS, { width: 50, height: 340 }).every((box) => box === null)).toBe(true);
});
