/** The explanation of every number: equations that give it, what makes it, and how sure it is. */

import type { Page } from "playwright-core";
import { describe, expect, test } from "vitest";
import { description, equipment } from "../described";
import { slide, TestStudio, violations } from "./site";

const FIRST = "#club=driver&speed=105mph&attack=2deg&path=4deg&loft=13deg&face=1deg&toe=8mm&high=4mm&units=golf";
const { explained, equations, certainty } = equipment.numbers;

const studio = new TestStudio();

interface Seen {
  name: string;
  link: string;
  /** What the table says of the number [SI], and what its equations give. */
  value: number;
  computed: number[];
  text: string;
}

/** Goes to links within the page, one after another, and returns what each explains. */
function explanations(page: Page, links: { name: string; link: string }[]): Promise<Seen[]> {
  const labels = Object.fromEntries(description.quantities.map(({ name, label }) => [name, label]));
  return page.evaluate(
    async ([all, labelOf]) => {
      const result: Seen[] = [];
      for (const { name, link } of all) {
        location.hash = `${link}&number=${name}`;
        const begun = performance.now();
        const isThere = (): boolean =>
          document.querySelector("#explained")?.textContent?.startsWith(`${labelOf[name]}:`) === true &&
          document.querySelector<HTMLSelectElement>('select[name="model"]')?.value ===
            (/model=([a-z]+)/.exec(link)?.[1] ?? "response");
        while (!isThere()) {
          if (performance.now() - begun > 20_000) throw new Error(`${link}, ${name}: not explained`);
          await new Promise((resolve) => setTimeout(resolve, 0));
        }
        const number = (selector: string, attribute: string): number[] =>
          [...document.querySelectorAll(selector)].map((each) => Number(each.getAttribute(attribute)));
        result.push({
          name,
          link,
          value: number(`td[data-quantity="${name}"]`, "data-value")[0],
          computed: number("math[data-computed]", "data-computed"),
          text: document.querySelector(".explanation")?.textContent ?? "",
        });
      }
      return result;
    },
    [links, labels] as const,
  );
}

describe("a number", () => {
  test("has equations that give it, with the values of the shot in them", async () => {
    const { page, errors } = await studio.open(FIRST);
    const links = ["response", "standard"].flatMap((model) =>
      Object.keys(equations).map((name) => ({ name, link: `${FIRST}&model=${model}` })),
    );
    for (const { name, link, value, computed } of await explanations(page, links)) {
      expect(computed.length, `${link}, ${name}`).toBe(equations[name].length);
      // The page shows fewer digits than it computes with; here all of them count, but for the last bits.
      for (const each of computed)
        expect(Math.abs(each - value)).toBeLessThanOrEqual(1e-9 * Math.max(1, Math.abs(value)));
    }
    const [{ text }] = await explanations(page, [{ name: "ball_speed", link: `${FIRST}&model=standard` }]);
    // The coefficient of restitution that the model has for this club, and the mass of the ball.
    const [set] = equipment.choices["standard"]["driver"]["modern"][""];
    const [cor] = equipment.sets[set].values;
    expect(text.replace(/\s/g, "")).toContain(`(1+${cor.toFixed(3)})`);
    expect(text).toContain("45.60");
    expect(errors).toEqual([]);
  });

  test("leaves out the momentum that a model does not keep", async () => {
    const { page } = await studio.open(`${FIRST}&model=adjusted&number=velocity_x`);
    await page.locator("#explained").waitFor();
    expect(await page.locator("math[data-computed]").count()).toBe(1);
  });

  test("is made of contributions that add up to it", async () => {
    const { page } = await studio.open(`${FIRST}&number=carry`);
    for (const [name, unit] of [
      ["carry", 0.9144],
      ["azimuth", Math.PI / 180],
      ["total_spin", Math.PI / 30],
    ] as const) {
      const [{ value }] = await explanations(page, [{ name, link: FIRST }]);
      await page.locator(".contributions .sum").waitFor();
      const numbers = (await page.locator(".contributions td").allTextContents()).map((text) =>
        Number(text.replace("−", "-").replace(/[^-+\d.]/g, "")),
      );
      const sum = numbers.slice(0, -1).reduce((total, each) => total + each, 0);
      const shown = value / unit;
      const digits = name === "total_spin" ? 0 : 1;
      expect(numbers.length).toBeGreaterThan(4);
      // Each of them is rounded.
      expect(Math.abs(sum - shown)).toBeLessThanOrEqual(0.5 * 10 ** -digits * (numbers.length + 1));
      expect(await page.getByText("what the integration leaves").count()).toBe(0);
    }
  });

  test("says how far the model is from published figures, or that none stands behind it", async () => {
    const { page } = await studio.open(`${FIRST}&number=ball_speed`);
    const rows = certainty.models["response"]["driver"]["ball_speed"].map((place) => certainty.rows[place]);
    const drives = rows.find(({ title }) => title.startsWith("Drives by handicap"));
    if (!drives) throw new Error("no drives by handicap");
    await page
      .locator(".comparisons li")
      .getByText(`± ${(100 * drives.size).toFixed(1)}%`, { exact: true })
      .first()
      .waitFor();
    expect(await page.locator(".comparisons").textContent()).toContain(`against ${drives.figures} published figures`);
    const [measured, unmeasured] = await explanations(page, [
      { name: "backspin", link: `${FIRST}&model=standard` },
      { name: "landing_spin", link: FIRST },
    ]);
    expect(measured.text).toContain("against 550 measured shots");
    expect(unmeasured.text).toContain("No measurement stands behind this number");
  });

  test("is explained for every output by models of each kind, in words and numbers throughout", async () => {
    const { page, errors } = await studio.open(`${FIRST}&number=carry`);
    const links = ["response", "jorgensen", "volumetric"].flatMap((model) =>
      explained.filter((name) => name !== "outside_fit").map((name) => ({ name, link: `${FIRST}&model=${model}` })),
    );
    for (const { text } of await explanations(page, links)) expect(text).not.toMatch(/undefined|NaN|null|Infinity/);
    expect(errors).toEqual([]);
  });

  test("opens by a press in the headline and in the table, follows a slider, and closes by Escape", async () => {
    const { page, errors } = await studio.open(FIRST);
    await page.locator(".headline").getByRole("button", { name: "carry" }).press("Enter");
    await page.getByRole("dialog", { name: /^carry: [\d.]+ yd/ }).waitFor();
    const before = await page.locator("#explained").textContent();
    await slide(page, "Club speed", "PageUp");
    await expect.poll(() => page.locator("#explained").textContent()).not.toBe(before);
    await page.waitForURL(/number=carry/);
    await page.locator('[data-explains="spin_axis"] button').press("Enter");
    await page.getByRole("dialog", { name: /^spin axis/ }).waitFor();
    expect(await page.evaluate(() => document.activeElement?.className)).toBe("explanation");
    await page.keyboard.press("Escape");
    expect(await page.getByRole("dialog").count()).toBe(0);
    expect(await page.evaluate(() => document.activeElement?.parentElement?.dataset.explains)).toBe("spin_axis");
    expect(errors).toEqual([]);
  });

  test.each(["light", "dark"] as const)("has no violation for axe when it is explained (%s)", async (colorScheme) => {
    await studio.renew({ colorScheme });
    for (const name of ["ball_speed", "carry"]) {
      const { page } = await studio.open(`${FIRST}&number=${name}`);
      await page.locator("#explained").waitFor();
      expect(await violations(page)).toEqual([]);
      await page.close();
    }
  });
});
