import { describe, expect, test } from "vitest";
import { Units } from "../../src/quantities/units";
import { CONDITIONS, flightConditions } from "../../src/state/conditions";
import { fromLink, toLink } from "../../src/state/link";
import type { SettingValue } from "../../src/state/settings";
import { initialState } from "../../src/state/state";
import { description, equipment } from "../described";

const units = new Units(description);
const usual = initialState(equipment, "golf");
const inputs = (settings: Record<string, SettingValue>) => flightConditions({ settings }, equipment, units);
const wind = (from: number) => inputs({ wind: { value: 10, unit: "m/s" }, wind_from: { value: from, unit: "deg" } });

describe("the conditions of a flight", () => {
  test("are those of the core where none is given", () => {
    expect(inputs({})).toEqual({});
    for (const name of ["temperature", "humidity", "pressure"] as const) {
      const { usual: amount } = CONDITIONS[name];
      if (typeof amount === "string") throw new Error(`${name} is no amount`);
      const input = description.flight_inputs.find((each) => each.name === name);
      expect(units.toSi(amount)).toBe(input?.default);
    }
    for (const [name, value] of Object.entries(equipment.grounds[CONDITIONS.ground.usual])) {
      expect(value).toBe(description.flight_inputs.find((each) => each.name === name)?.default);
    }
  });

  test("a wind from the target blows against the ball, one from the right to the left", () => {
    expect(wind(0).wind_x).toBe(-10);
    expect(wind(0).wind_z).toBeCloseTo(0, 12);
    expect(wind(90).wind_z).toBe(-10);
    expect(wind(90).wind_x).toBeCloseTo(0, 12);
    expect(wind(180).wind_x).toBe(10);
    expect(wind(-45).wind_z).toBeCloseTo(10 * Math.SQRT1_2, 12);
    expect(inputs({ wind_from: { value: 90, unit: "deg" } })).toEqual({});
  });

  test("a pressure that is given holds, and the altitude does not count", () => {
    const altitude = { value: 1600, unit: "m" };
    expect(inputs({ altitude })).toEqual({ altitude: 1600 });
    expect(inputs({ altitude, pressure: { value: 840, unit: "hPa" } })).toEqual({ pressure: 84000 });
  });

  test("a ground has the inputs of the package", () => {
    expect(inputs({ ground: "firm green" })).toEqual(equipment.grounds["firm green"]);
  });

  test("stand in the link of every scene", () => {
    const settings = {
      wind: { value: 15, unit: "km/h" },
      wind_from: { value: -30, unit: "deg" },
      altitude: { value: 5280, unit: "ft" },
      temperature: { value: 68, unit: "degF" },
      humidity: { value: 40, unit: "%" },
      ground: "soft fairway",
    };
    const context = {
      equipment,
      units,
      inputs: description.inputs,
      scenes: ["shot", "models"],
      settings: CONDITIONS,
      usual,
    };
    const link = toLink({ ...usual, settings }, context);
    expect(link).toContain("&wind=15km/h&wind_from=-30deg&altitude=5280ft&temperature=68degF&humidity=40%25");
    const read = fromLink(link, context);
    expect(read.problems).toEqual([]);
    expect(read.state.settings).toEqual(settings);
  });
});
