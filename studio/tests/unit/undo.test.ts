import { expect, test } from "vitest";
import { begin, redo, settle, step, undo } from "../../src/state/undo";

test("steps are undone and done again in order", () => {
  const both = step(step(begin(1), 2), 3);
  const one = undo(both);
  expect([one.present, undo(one).present, undo(undo(one)).present]).toEqual([2, 1, 1]);
  expect(redo(redo(undo(one))).present).toBe(3);
  expect(redo(both).present).toBe(3);
});

test("the values of a slider that is moved are one step", () => {
  const moved = step(step(step(begin(1), 2, "speed"), 3, "speed"), 4, "speed");
  expect(undo(moved).present).toBe(1);
});

test("a slider that is moved again, or another one, is another step", () => {
  const again = step(settle(step(begin(1), 2, "speed")), 3, "speed");
  expect(undo(again).present).toBe(2);
  expect(undo(step(step(begin(1), 2, "speed"), 3, "face")).present).toBe(2);
});

test("a new step after an undo leaves nothing to do again", () => {
  expect(redo(step(undo(step(begin(1), 2)), 5)).present).toBe(5);
});
