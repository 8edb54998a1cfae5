/** Head and ball at impact. */

import type { Page } from "playwright-core";
import { describe, expect, test } from "vitest";
import { pictureOf, slide, TestStudio, violations } from "./site";

const FIRST = "#club=driver&speed=105mph&path=4deg&face=1deg&toe=8mm&units=golf";
const CANVAS = ".stage[data-stage=head] canvas";

const studio = new TestStudio();

/** The picture when two looks at it, a few frames apart, agree. */
async function picture(page: Page): Promise<string> {
  await page.locator(CANVAS).waitFor();
  let [before, now] = ["", await pictureOf(page, CANVAS)];
  while (before !== now) {
    await page.waitForTimeout(150);
    [before, now] = [now, await pictureOf(page, CANVAS)];
  }
  return now;
}

const nameOf = async (page: Page): Promise<string> =>
  (await page.locator("[data-stage=head]").getAttribute("aria-label")) ?? "";

describe("head and ball", () => {
  test("are drawn, follow the delivery, and say what they show", async () => {
    const { page, errors } = await studio.open(FIRST);
    const before = await picture(page);
    // An empty canvas of this size has a few thousand characters.
    expect(before.length).toBeGreaterThan(20_000);
    expect(await nameOf(page)).toMatch(
      /driver meets the ball, seen at an angle, at first touch: club path 4\.0° right, .*face angle 1\.0° right, .*launch direction [\d.]+° right/,
    );
    await slide(page, "Face angle", "PageUp");
    await expect.poll(() => nameOf(page)).not.toContain("face angle 1.0° right");
    expect(await picture(page)).not.toBe(before);
    expect(errors).toEqual([]);
  });

  test("are seen from each side, which the link keeps", async () => {
    const { page, errors } = await studio.open(FIRST);
    const pictures = new Set([await picture(page)]);
    for (const [title, view] of [
      ["From above", "above"],
      ["Down the line", "line"],
      ["Face on", "face"],
    ]) {
      await page.getByRole("button", { name: title }).click();
      await page.waitForURL(new RegExp(`head_view=${view}`));
      expect(await nameOf(page)).toContain(title.toLowerCase());
      pictures.add(await picture(page));
    }
    expect(pictures.size).toBe(4);
    expect(errors).toEqual([]);
  });

  test("move from before first touch until the ball has left", async () => {
    const { page } = await studio.open(FIRST);
    const pictures = new Set([await picture(page)]);
    for (const [title, words] of [
      ["Before", "before first touch"],
      ["Separation", "at separation"],
      ["After", "after the ball has left"],
    ]) {
      await page.getByRole("button", { name: title, exact: true }).click();
      await expect.poll(() => nameOf(page)).toContain(words);
      pictures.add(await picture(page));
    }
    expect(pictures.size).toBe(4);
    await page.getByRole("textbox", { name: "Moment" }).fill("-1000 us");
    await page.getByRole("textbox", { name: "Moment" }).press("Enter");
    await page.waitForURL(/moment=-1000us/);
  });

  test("play in slow motion, or from moment to moment where less motion is wanted, as one step of undo", async () => {
    for (const reducedMotion of ["no-preference", "reduce"] as const) {
      await studio.renew({ reducedMotion });
      const { page } = await studio.open(FIRST);
      await picture(page);
      await page.evaluate(() => {
        const seen = new Set<string>();
        Object.assign(globalThis, { seen });
        new MutationObserver(() =>
          seen.add(document.querySelector<HTMLInputElement>("#text-moment")?.dataset.shown ?? ""),
        ).observe(document.body, { subtree: true, attributes: true });
      });
      await page.getByRole("button", { name: "Play" }).click();
      await page.waitForURL(/moment=3000us/, { timeout: 15_000 });
      const steps = await page.evaluate(() => (globalThis as unknown as { seen: Set<string> }).seen.size);
      if (reducedMotion === "reduce") expect(steps).toBeLessThanOrEqual(5);
      else expect(steps).toBeGreaterThan(10);
      await page.getByRole("button", { name: "Undo" }).click();
      await expect.poll(() => nameOf(page)).toContain("at first touch");
    }
  });

  test("of a left-handed club are the mirror image, with the toe on the left from behind", async () => {
    const { page } = await studio.open("#club=7-iron&speed=84mph&units=golf&head_view=line");
    const right = await picture(page);
    await page.locator('select[name="hand"]').selectOption("left");
    await page.waitForURL(/hand=left/);
    const left = await picture(page);
    /** The side of the middle on which the shaft is seen in the top row of the picture: -1 is left. */
    const side = (address: string): Promise<number> =>
      page.evaluate(async (url) => {
        const image = Object.assign(new Image(), { src: url });
        await image.decode();
        const canvas = Object.assign(document.createElement("canvas"), { width: image.width, height: image.height });
        const drawing = canvas.getContext("2d");
        drawing?.drawImage(image, 0, 0);
        const row = drawing?.getImageData(0, 2, image.width, 1).data ?? [];
        const seen = Array.from({ length: image.width }, (_, x) => x).filter((x) => row[4 * x + 3] > 0);
        return Math.sign(seen.reduce((sum, x) => sum + x - image.width / 2, 0));
      }, address);
    expect([await side(right), await side(left)]).toEqual([-1, 1]);
  });

  test.each(["light", "dark"] as const)("have no violation for axe (%s)", async (colorScheme) => {
    await studio.renew({ colorScheme });
    const { page } = await studio.open(FIRST);
    await picture(page);
    expect(await violations(page)).toEqual([]);
  });
});
