import { describe, expect, test } from "vitest";
import { Formatter, join } from "../../src/quantities/formatter";
import { Units } from "../../src/quantities/units";
import { description } from "../described";

const units = new Units(description);

describe("amounts with units", () => {
  test("a text with a unit is converted as the package does it, to the last bit", () => {
    expect(units.toSi(units.parse("105 mph", "mph"))).toBe((105 * 44704) / 100000);
    expect(units.toSi(units.parse("12.8deg", "deg"))).toBe((12.8 * Math.PI) / 180);
    expect(units.toSi(units.parse("77 degF", "K"))).toBeCloseTo(298.15, 9);
  });

  test("a number alone is in the unit that is shown", () => {
    expect(units.parse("46.9", "m/s")).toEqual({ value: 46.9, unit: "m/s" });
  });

  test("commas, signs and degree signs are read as people write them", () => {
    expect(units.parse("46,9 m/s", "mph")).toEqual({ value: 46.9, unit: "m/s" });
    expect(units.parse("−1.3°", "deg")).toEqual({ value: -1.3, unit: "deg" });
    expect(units.parse(" +2 degrees ", "deg")).toEqual({ value: 2, unit: "deg" });
    expect(units.parse("1e-1 deg", "deg")).toEqual({ value: 0.1, unit: "deg" });
  });

  test.each(["", "fast", "mph", "12 13", "1.2.3 mph", "105 mm", "105 furlongs", "1e999 mph"])(
    "%j is refused with what is wanted",
    (text) => {
      expect(() => units.parse(text, "mph")).toThrow(/give a number in m\/s, mph, km\/h, ft\/s/);
    },
  );

  test("what is converted to a unit and back is the same to rounding", () => {
    for (const unit of description.units) {
      const si = units.toSi({ value: 3.7, unit: unit.symbol });
      expect(units.fromSi(si, unit.symbol)).toBeCloseTo(3.7, 9);
    }
  });
});

describe("values as people read them", () => {
  const formatter = new Formatter(description, "en-US");

  test("words stand for signs", () => {
    expect(formatter.text("side", -2, "golf")).toBe("2.2 yd left");
    expect(formatter.text("azimuth", 0.02, "metric")).toBe("1.1° right");
    expect(formatter.text("ball_speed", 69, "golf")).toBe("154.3 mph");
  });

  test("zero has no side, and no minus sign", () => {
    expect(formatter.text("side", -1e-9, "golf")).toBe("0.0 yd");
    expect(formatter.text("cor_slope", -1e-9, "golf")).toBe("0.0000 s/m");
  });

  test("the form of numbers is that of the browser's language", () => {
    expect(new Formatter(description, "de-DE").text("carry", 201.25, "metric")).toBe("201,3 m");
  });

  test("every quantity can be shown in both systems", () => {
    for (const { name } of description.quantities)
      for (const system of ["golf", "metric"] as const) expect(formatter.text(name, 0.1, system)).toMatch(/\d/);
  });

  test("powers stand above", () => {
    expect(formatter.units.symbol("g cm2")).toBe("g cm²");
    expect(formatter.units.symbol("kg/m3")).toBe("kg/m³");
    expect(formatter.units.symbol("m/s")).toBe("m/s");
  });

  test("a degree sign follows its number at once", () => {
    expect(join("2.0", "°", "up")).toBe("2.0° up");
    expect(join("0.830", "")).toBe("0.830");
  });
});
