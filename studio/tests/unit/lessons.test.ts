import { describe, expect, test } from "vitest";
import { crossing, peak, spread } from "../../src/scenes/learn/lesson";
import { LEARN_SETTINGS, LESSON_NAMES, LESSON_SLIDERS } from "../../src/scenes/learn/settings";
import { description } from "../described";

describe("settings of the lessons", () => {
  test("every slider begins with the name of its lesson, and is of a quantity that the core describes", () => {
    for (const [name, setting] of Object.entries(LESSON_SLIDERS)) {
      expect(LESSON_NAMES.some((lesson) => name.startsWith(`${lesson}_`))).toBe(true);
      const known = description.quantities.map((each) => each.name);
      expect(setting.kind === "amount" && known.includes(setting.quantity)).toBe(true);
    }
  });

  test("no lesson is without a slider, and the first one is usual", () => {
    for (const lesson of LESSON_NAMES)
      expect(Object.keys(LESSON_SLIDERS).some((name) => name.startsWith(`${lesson}_`))).toBe(true);
    expect(LEARN_SETTINGS.lesson.usual).toBe(LESSON_NAMES[0]);
  });
});

describe("what is read from curves", () => {
  const x = spread(-2, 4, 25);

  test("the top of a parabola is found between its points", () => {
    const [at, height] = peak(
      x,
      x.map((each) => 7 - (each - 0.8) ** 2),
    );
    expect(at).toBeCloseTo(0.8, 12);
    expect(height).toBeCloseTo(7, 12);
  });

  test("the top at an end is that end", () => {
    expect(peak(x, x)).toEqual([4, 4]);
  });

  test("a line crosses its level where it does, and nowhere else", () => {
    const y = x.map((each) => 3 * each - 1);
    expect(crossing(x, y, 2)).toBeCloseTo(1, 12);
    expect(crossing(x, y, 100)).toBeNaN();
    expect(crossing([], [])).toBeNaN();
  });
});
