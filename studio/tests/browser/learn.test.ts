import { readFileSync } from "node:fs";
import { type LoadedCore, load } from "clubface-core";
import type { Page } from "playwright-core";
import { beforeAll, describe, expect, test } from "vitest";
import { flightInputs } from "../../src/core/compute";
import type { Values } from "../../src/core/types";
import { strikeOf } from "../../src/equipment/equipment";
import { equipment } from "../described";
import { TestStudio, violations } from "./site";

const DEGREE = Math.PI / 180;
const MPH = 0.44704;
/** What a lesson shows when its curves have come too, from which its answer is made. */
const READY = '.answer:not(:has(data[value="NaN"])) data';

interface Listed {
  title: string;
  /** What solves the question: slider by slider, the keys that are pressed, and how often at most. */
  moves: Record<string, Record<string, number>>;
}

const LESSONS: Record<string, Listed> = {
  spin: {
    title: "Friction makes the spin, then takes some of it back",
    moves: { "Friction of ball and face": { PageDown: 6, ArrowLeft: 100 } },
  },
  curve: {
    title: "The ball starts near the face and curves away from the path",
    moves: { "Club path": { PageUp: 1, ArrowRight: 60 } },
  },
  gear: {
    title: "A toe strike hooks, so a driver's face bulges",
    moves: { "Radius of the bulge": { PageDown: 6, ArrowLeft: 100 } },
  },
  height: {
    title: "A drive struck high launches higher and spins less",
    moves: { "Up the face": { PageUp: 3, ArrowRight: 60 } },
  },
  descent: {
    title: "A descending blow spins more, if the loft stays",
    moves: { "Attack angle": { PageDown: 4 }, "Dynamic loft": { PageDown: 3, ArrowLeft: 30 } },
  },
  wet: {
    title: "A wet wedge launches high because the ball slides",
    moves: { "Friction of ball and face": { PageDown: 3, ArrowLeft: 60 } },
  },
  rules: {
    title: "The rules limit how far a face gives and how steady a head is",
    moves: { "Characteristic time of the face": { PageUp: 3 }, "Moment of inertia, vertical axis": { PageUp: 8 } },
  },
  monitors: { title: "Two monitors can disagree and both be right", moves: { "Closure rate": { PageUp: 3 } } },
};
const NAMES = Object.keys(LESSONS);

const studio = new TestStudio();
let core: LoadedCore;

beforeAll(async () => {
  core = await load(readFileSync(new URL("../../generated/clubface.wasm", import.meta.url)));
});

const link = (name: string, more = ""): string => `#scene=learn&lesson=${name}&units=golf${more}`;
const slider = (page: Page, label: string) => page.getByRole("slider", { name: `${label}, slider` });
const verdict = async (page: Page): Promise<string> => (await page.getByRole("status").last().textContent()) ?? "";

/** All that is drawn, as text that changes with it. */
const drawn = (page: Page): Promise<string[]> =>
  page
    .locator(".drawn > figure")
    .evaluateAll((figures) => figures.map((figure) => figure.querySelector("canvas")?.toDataURL() ?? figure.innerHTML));

/** Presses a key on a slider and waits until the page has drawn what follows from it. */
async function press(page: Page, label: string, key: string): Promise<void> {
  const before = await page.locator(".so-far").innerHTML();
  await slider(page, label).press(key);
  await page.waitForFunction((text) => document.querySelector(".so-far")?.innerHTML !== text, before);
}

async function solve(page: Page, { moves }: Listed): Promise<void> {
  for (const [label, keys] of Object.entries(moves))
    for (const [key, most] of Object.entries(keys))
      for (let i = 0; i < most; i += 1) {
        if ((await verdict(page)).includes("Solved")) return;
        await press(page, label, key);
      }
}

describe.each(NAMES)("%s", (name) => {
  const lesson = LESSONS[name];

  test("opens by its link, with a question that is open, and pictures that follow its sliders", async () => {
    const { page, errors } = await studio.open(link(name), READY);
    const title = await page.getByRole("heading", { level: 2 }).textContent();
    expect(title).toBe(`${NAMES.indexOf(name) + 1}. ${lesson.title}`);
    const words = ((await page.locator(".claim").textContent()) ?? "").trim().split(/\s+/).length;
    expect(words).toBeGreaterThanOrEqual(60);
    expect(words).toBeLessThanOrEqual(120);
    expect((await verdict(page)).trim()).toBe("Not solved yet.");
    expect(await page.locator(".answer p").isVisible()).toBe(false);
    expect(await page.getByText(/NaN|…/).count()).toBe(0);
    for (const [label, keys] of Object.entries(lesson.moves)) {
      const before = await drawn(page);
      expect(before.length).toBe(2);
      await press(page, label, Object.keys(keys)[0]);
      await expect.poll(async () => (await drawn(page)).join() !== before.join(), { timeout: 10_000 }).toBe(true);
    }
    expect(errors).toEqual([]);
  });

  test("its question is solved by its sliders, and the page says so", async () => {
    const { page, errors } = await studio.open(link(name), READY);
    await solve(page, lesson);
    await expect.poll(() => verdict(page)).toContain("Solved");
    expect(await page.locator(".answer p").isVisible()).toBe(true);
    expect(errors).toEqual([]);
  });

  test.each([
    ["light", 1280],
    ["dark", 360],
  ] as const)("axe finds no violation and nothing sticks out (%s, %i px)", async (colorScheme, width) => {
    await studio.renew({ viewport: { width, height: 800 }, colorScheme });
    const { page } = await studio.open(link(name), READY);
    expect(await page.evaluate(() => document.documentElement.scrollWidth)).toBeLessThanOrEqual(width);
    expect(await violations(page)).toEqual([]);
  });
});

/** Launch and flight of a strike of this test's own, with the usual parameters but for `friction`. */
function computed(club: string, model: string, delivery: Values, friction?: number): Values {
  const chosen = { club, ball: "modern", model, parameters: "", hand: "right" } as const;
  const strike = strikeOf(core.description, equipment, chosen, delivery);
  const names = core.description.models.find((each) => each.name === model)?.parameters.map((each) => each.name) ?? [];
  const parameters = strike.parameters.map((value, i) => (names[i] === "friction" ? (friction ?? value) : value));
  const launch = core.launches(model, strike.inputs, parameters, 1).outputs;
  const values = Object.fromEntries(core.description.outputs.map((each, i) => [each.name, launch[i][0]]));
  const flight = core.flights(flightInputs(core, strike, values), 1).outputs;
  return {
    ...values,
    ...Object.fromEntries(core.description.flight_outputs.map((each, i) => [each.name, flight[i][0]])),
  };
}

describe("the numbers", () => {
  const driver = { speed: 100 * MPH, attack: 0, loft: 13 * DEGREE };
  const iron = { speed: 88 * MPH, attack: -8 * DEGREE, loft: 18 * DEGREE };
  const wedge = { speed: 60 * MPH, attack: -5 * DEGREE, loft: 50 * DEGREE };
  /** Lesson, its sliders, quantities, and the same computed here. */
  const cases: [name: string, sliders: string, quantities: string[], value: () => Values][] = [
    ["spin", "&spin_friction=0.2", ["backspin"], () => computed("driver", "rings", driver, 0.2)],
    [
      "curve",
      "&curve_path=4deg&curve_face=1deg",
      ["side", "spin_axis"],
      () => computed("driver", "response", { ...driver, path: 4 * DEGREE, face: DEGREE }),
    ],
    [
      "gear",
      "&gear_bulge=400mm&gear_toe=12mm",
      ["side", "spin_axis", "azimuth"],
      () => computed("driver", "response", { ...driver, bulge: 0.4, toe: 0.012 }),
    ],
    [
      "height",
      "&height_high=5mm",
      ["launch", "backspin", "carry", "ball_speed"],
      () => computed("driver", "response", { ...driver, high: 0.005 }),
    ],
    [
      "descent",
      "&descent_attack=-8deg&descent_loft=18deg",
      ["backspin", "launch"],
      () => computed("7-iron", "response", iron),
    ],
    ["wet", "&wet_friction=0.2", ["launch", "backspin"], () => computed("sand-wedge", "response", wedge, 0.2)],
    [
      "rules",
      "&rules_time=240us&rules_inertia=5000g%20cm2",
      ["carry", "ball_speed"],
      () => computed("driver", "response", { ...driver, toe: 0.02, characteristic_time: 240e-6, iyy: 5e-4 }),
    ],
    [
      "monitors",
      "&monitors_closure=2000deg/s&monitors_high=0mm&monitors_temperature=25degC",
      ["carry"],
      () =>
        computed("driver", "response", {
          speed: 105 * MPH,
          attack: -DEGREE,
          loft: 13 * DEGREE,
          closure: 2000 * DEGREE,
        }),
    ],
  ];

  test.each(cases)("of %s are those of the core (%s)", async (name, sliders, quantities, value) => {
    const { page } = await studio.open(link(name, sliders), READY);
    const expected = value();
    const shown = await page
      .locator(".lesson data")
      .evaluateAll((all) => all.map((each) => Number(each.getAttribute("value"))));
    for (const quantity of quantities) {
      const nearest = Math.min(...shown.map((each) => Math.abs(each - expected[quantity])));
      // The last bits of angles that were given in degrees.
      expect(nearest, `${quantity} ${expected[quantity]}`).toBeLessThan(
        1e-9 * Math.max(1, Math.abs(expected[quantity])),
      );
    }
  });
});

describe("from lesson to lesson", () => {
  test("by the keyboard: list, next and previous; each begins anew, and the link follows", async () => {
    const { page, errors } = await studio.open(link("curve", "&curve_path=5deg"), READY);
    const heading = page.getByRole("heading", { level: 2 });
    await page.getByRole("button", { name: "Next lesson" }).press("Enter");
    await expect.poll(() => heading.textContent()).toContain(LESSONS.gear.title);
    expect(await page.evaluate(() => document.activeElement?.id)).toBe("lesson");
    await page.waitForURL(/lesson=gear/);
    expect(page.url()).not.toContain("curve_path");
    await page.getByRole("button", { name: "Previous lesson" }).press("Space");
    await expect.poll(() => heading.textContent()).toContain(LESSONS.curve.title);
    await page.getByRole("button", { name: LESSONS.monitors.title }).press("Enter");
    await expect.poll(() => heading.textContent()).toContain(LESSONS.monitors.title);
    expect(await page.getByRole("button", { name: "Next lesson" }).isDisabled()).toBe(true);
    const current = page.locator(".lessons [aria-current]");
    expect(await current.allTextContents()).toEqual([expect.stringContaining(LESSONS.monitors.title)]);
    await page.keyboard.press("Control+z");
    await expect.poll(() => heading.textContent()).toContain(LESSONS.curve.title);
    expect(errors).toEqual([]);
  });

  test("a slider is in the link, and undo takes it back", async () => {
    const { page } = await studio.open(link("curve"), READY);
    await press(page, "Club path", "PageUp");
    await page.waitForURL(/curve_path=2deg/);
    await page.keyboard.press("Control+z");
    await page.waitForFunction(() => !location.hash.includes("curve_path"));
    expect(await slider(page, "Club path").inputValue()).toBe("0");
  });

  test("a lesson's strike goes to the Shot scene, and undo comes back", async () => {
    const { page, errors } = await studio.open(link("height", "&height_high=5mm&hand=left"), READY);
    const carry = computed("driver", "response", { speed: 100 * MPH, attack: 0, loft: 13 * DEGREE, high: 0.005 }).carry;
    await page.getByRole("button", { name: "Take this strike to the Shot scene" }).click();
    const shown = page.locator('td[data-quantity="carry"]');
    await expect.poll(async () => Number(await shown.getAttribute("data-value"))).toBeCloseTo(carry, 9);
    await page.waitForURL(/club=driver.*&high=5mm/);
    expect(page.url()).not.toContain("height_high");
    await page.keyboard.press("Control+z");
    await page.getByRole("heading", { name: new RegExp(LESSONS.height.title) }).waitFor();
    expect(errors).toEqual([]);
  });

  test("a slider that is typed beyond what can be computed says so, and nothing else", async () => {
    const { page, errors } = await studio.open(link("gear"), READY);
    const toe = page.getByRole("textbox", { name: "Towards the toe" });
    await toe.fill("90 mm");
    await toe.press("Enter");
    await page.getByText("This strike cannot be computed").waitFor();
    await page.keyboard.press("Control+z");
    await page.locator(READY).first().waitFor({ state: "attached" });
    expect(errors).toEqual([]);
  });
});
