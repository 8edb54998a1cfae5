import { describe, expect, test } from "vitest";
import type { Values } from "../../src/core/types";
import { type Setup, slopeOf, withClub } from "../../src/equipment/design";
import { chosenSet, strikeOf } from "../../src/equipment/equipment";
import { type Amount, Units } from "../../src/quantities/units";
import { asChanges, exactAmount, readClub, writeClub } from "../../src/scenes/design/club-file";
import { cgInFace, inClub, onFace, sweetSpot } from "../../src/scenes/design/geometry";
import { DESIGN_SETTINGS } from "../../src/scenes/design/settings";
import { fromLink, type LinkContext, toLink } from "../../src/state/link";
import { changed, initialState } from "../../src/state/state";
import { description, equipment } from "../described";

const units = new Units(description);
const usual = initialState(equipment, "golf");
const names = description.inputs.map(({ name }) => name);
const driver = equipment.clubs.driver.columns as Values;

function setupOf(model = "response", parameters = ""): Setup {
  const chosen = { ...usual, model, parameters };
  return {
    strike: strikeOf(description, equipment, chosen, { speed: 47, loft: 0.2 }),
    golfer: equipment.golfers["handicap-10-driver"].right,
    names,
    face: chosenSet(equipment, chosen),
    speedExponent: equipment.speed_exponent,
  };
}
const input = ({ strike }: Setup, name: string): number => strike.inputs[names.indexOf(name)];

describe("a club with other numbers", () => {
  test("more loft is delivered with as much more, by golfers too", () => {
    const after = withClub(setupOf(), { static_loft: driver.static_loft + 0.02 });
    expect(input(after, "loft")).toBeCloseTo(0.22, 12);
    const place = after.golfer?.variables.indexOf("loft") ?? -1;
    expect(after.golfer?.mean[place]).toBeCloseTo((setupOf().golfer?.mean[place] ?? 0) + 0.02, 12);
  });

  test("26 g more cost 2.7 mph of 110, by golfers in mean and spread", () => {
    const light = { ...setupOf(), strike: { ...setupOf().strike } };
    light.strike.inputs = light.strike.inputs.map((each, i) => (names[i] === "club_mass" ? 0.174 : each));
    const factor = input(withClub(light, { club_mass: 0.2 }), "speed") / 47;
    expect(110 * (1 - factor)).toBeCloseTo(2.7, 1);
    const after = withClub(light, { club_mass: 0.2 }).golfer;
    const place = after?.variables.indexOf("speed") ?? -1;
    expect((after?.covariance[place][place] ?? 0) / (light.golfer?.covariance[place][place] ?? 1)).toBeCloseTo(
      factor ** 2,
      12,
    );
  });

  test("nothing changes with the club's own numbers", () => {
    expect(withClub(setupOf(), driver)).toEqual(setupOf());
  });

  test("a face that the parameters include is not counted twice", () => {
    const both = (setup: Setup): number[] => [input(setup, "characteristic_time"), input(setup, "included_time")];
    const faster = { characteristic_time: 240e-6 };
    expect(both(withClub(setupOf(), faster))).toEqual([240e-6, 0]);
    expect(both(withClub(setupOf("standard"), faster))).toEqual([240e-6, 250e-6]);
    expect(both(withClub(setupOf("standard", "penner"), faster))).toEqual([240e-6, 240e-6]);
    expect(both(withClub(setupOf("standard"), { characteristic_time: 0 }))).toEqual([250e-6, 250e-6]);
  });

  test("slopes by mass have what the speed loses, those by loft what is delivered", () => {
    const slopes: Values = { club_mass: 100, speed: 2, static_loft: 3, loft: 5, cg_x: 7 };
    const setup = setupOf();
    expect(slopeOf(setup, slopes, "club_mass")).toBeCloseTo(100 - (0.18 * 47 * 2) / 0.204, 9);
    expect(slopeOf(setup, slopes, "static_loft")).toBe(8);
    expect(slopeOf(setup, slopes, "cg_x")).toBe(7);
  });
});

describe("the drawn head", () => {
  test("the driver's CG is 42.3 mm behind the face and 2.9 mm above its normal, as it was published", () => {
    const [out, up, toe] = cgInFace(driver);
    expect([-out, up, toe].map((each) => Math.round(each * 1e4) / 10)).toEqual([42.3, 2.9, -1]);
    expect(inClub([out, up, toe], driver.static_loft).map((each) => each + 0)).toEqual([
      expect.closeTo(-driver.cg_x, 12),
      expect.closeTo(-driver.cg_y, 12),
      -driver.cg_z,
    ]);
  });

  test("the normal at the sweet spot passes through the CG, of flat faces and of curved ones", () => {
    const flat = { ...driver, bulge: Infinity, roll: Infinity };
    const [, up, toe] = cgInFace(flat);
    expect(sweetSpot(flat).slice(1)).toEqual([up, toe]);
    const round = { ...driver, cg_z: 0, bulge: 0.3, roll: 0.3 };
    const [spot, cg] = [sweetSpot(round), cgInFace(round)];
    // The normal of a circle passes through its centre, 300 mm behind the face centre: all three are on one line.
    const slope = ([x, y]: readonly number[]): number => y / (x + 0.3);
    expect(slope(spot)).toBeCloseTo(slope(cg), 9);
  });

  test("a curved face falls back by h squared over twice the radius", () => {
    // The next term of the circle is h^4 / 8 R^3, some 4 um.
    expect(onFace(0, 0.03, driver)[0]).toBeCloseTo(-(0.03 ** 2) / (2 * 0.305), 5);
  });
});

describe("a club's file", () => {
  const given: Record<string, Amount> = {
    cg_x: { value: 44.25, unit: "mm" },
    iyy: { value: 5800, unit: "g cm2" },
    static_loft: { value: 0.6, unit: "deg" },
  };
  const write = (club: string, changes: Record<string, Amount> = given): string =>
    writeClub(equipment, units, { club, hand: "right" }, changes);
  const reread = (text: string): ReturnType<typeof readClub> => readClub(text, equipment, description);

  test("every club is read back as it was written, to the last bit", async () => {
    for (const [club, { columns, kind, parameters }] of Object.entries(equipment.clubs)) {
      const file = await reread(write(club, {}));
      expect([file.kind, file.parameters]).toEqual([kind, parameters]);
      expect(asChanges(file, equipment, units)).toEqual({ club, changes: {} });
      for (const [name, amount] of Object.entries(file.amounts))
        expect(amount.value === Infinity ? null : units.toSi(amount), `${club} ${name}`).toBe(columns[name]);
    }
  });

  test("changes come back as they were given", async () => {
    const file = await reread(write("driver"));
    expect(asChanges(file, equipment, units)).toEqual({ club: "driver", changes: given });
    expect(write("driver")).toContain('cg_x = "changed in the studio"');
    expect(write("driver")).toContain(`mass = "driver, clubface ${equipment.version}"`);
  });

  test("a club of another name is taken for the nearest loft of its kind", async () => {
    const text = write("driver", {}).replace('"driver-changed"', '"mine"').replace('"9.8 deg"', '"14.6 deg"');
    const { club, changes } = asChanges(await reread(text), equipment, units);
    expect(equipment.clubs[club].kind).toBe("wood");
    expect(Math.abs((equipment.clubs[club].columns.static_loft ?? 0) - (14.6 * Math.PI) / 180)).toBeLessThan(0.02);
    expect(changes.cg_x).toEqual({ value: 42.18, unit: "mm" });
  });

  test.each([
    ["mass = ", "line 1"],
    [write("driver").replace(/cg_x = "44.*\n/, ""), "cg_x is missing"],
    [write("driver").replace("44.25 mm", "44.25 g"), 'cg_x is "44.25 g": g does not fit'],
    [write("driver").replace("44.25 mm", "44.25"), 'cg_x is "44.25"; cg_x must be text with its unit'],
    [write("driver").replace("0.6 deg", "80 deg"), "it must be from 0 to 75 deg"],
    [write("driver").replace('"wood"', '"putter"'), 'kind is "putter"; it must be wood, hybrid, iron'],
    [`speed = 3\n${write("driver")}`, "speed"],
    [`cor = 0.82\n${write("driver")}`, "characteristic_time"],
    [write("driver").replace('"5800 g cm2"', "true"), "iyy is true"],
  ])("a damaged file says why (%#)", async (text, why) => {
    await expect(reread(text)).rejects.toThrow(why);
  });

  test("the shortest number is found that stands for a value, and only if there is one", () => {
    expect(exactAmount(units, 0.04218, "mm")).toEqual({ value: 42.18, unit: "mm" });
    expect(exactAmount(units, (9.8 * Math.PI) / 180, "deg")).toEqual({ value: 9.8, unit: "deg" });
    const { value, unit } = exactAmount(units, 1 / 3, "mm");
    expect(unit ? units.toSi({ value, unit }) : value).toBe(1 / 3);
  });
});

describe("the link", () => {
  const context: LinkContext = {
    equipment,
    units,
    inputs: description.inputs,
    scenes: ["shot", "design"],
    settings: DESIGN_SETTINGS,
    usual,
  };

  test("has what differs from the club's own, with its unit", () => {
    const design = {
      kind: "settings",
      settings: { cg_x: { value: 44, unit: "mm" }, iyy: { value: 5900, unit: "g cm2" } },
    } as const;
    const state = changed({ ...usual, scene: "design" }, design, equipment, DESIGN_SETTINGS);
    const link = toLink(state, context);
    expect(link).toContain("&cg_x=44mm&iyy=5900g%20cm2");
    expect(fromLink(link, context)).toEqual({ state, problems: [] });
  });

  test("another club is shown with its own numbers, and what was chosen else stays", () => {
    const design = { kind: "settings", settings: { cg_x: { value: 44, unit: "mm" }, best: "total" } } as const;
    const state = changed(usual, design, equipment, DESIGN_SETTINGS);
    expect(changed(state, { kind: "club", club: "7-iron" }, equipment, DESIGN_SETTINGS).settings).toEqual({
      best: "total",
    });
  });

  test("an amount that does not fit is reported", () => {
    expect(fromLink("#cg_x=44g&iyy=5900", context).problems).toHaveLength(2);
  });
});
