import type { Page } from "playwright-core";
import { expect, test } from "vitest";
import { equipment } from "../described";
import { TestStudio } from "./site";

const studio = new TestStudio({ viewport: { width: 360, height: 740 } });

/** Waits until nothing of the scene is computed or loaded any more. */
const settled = (page: Page): Promise<unknown> =>
  page.waitForFunction(() => !document.querySelector("main [aria-busy='true'], main progress"), null, {
    timeout: 60_000,
  });

/** Canvases of the scene that are blank. */
const blank = (page: Page): Promise<number> =>
  page.locator("main canvas").evaluateAll(
    (all) =>
      (all as HTMLCanvasElement[]).filter((canvas) => {
        const { width, height } = canvas;
        const empty = Object.assign(document.createElement("canvas"), { width, height });
        return canvas.checkVisibility() && canvas.toDataURL() === empty.toDataURL();
      }).length,
  );

/** Keys of clubs and balls that stand where their names should, in lists and in texts. */
async function keysShown(page: Page): Promise<string[]> {
  const text = (await page.locator("main").textContent()) ?? "";
  const entries = [...Object.entries(equipment.clubs), ...Object.entries(equipment.balls)];
  const keys = entries.filter(([key, { label }]) => key.includes("-") && key !== label).map(([key]) => key);
  return keys.filter((key) => text.includes(key));
}

test("every scene opens from the head of the page, draws, fits a narrow screen, and its link opens it again", async () => {
  const { page, errors } = await studio.open("#club=driver&speed=105mph&units=golf");
  const titles = await page.locator("header nav button").allInnerTexts();
  expect(titles.length).toBeGreaterThan(5);
  let address = page.url();
  for (const title of titles) {
    await page.getByRole("button", { name: title, exact: true }).click();
    await page.locator("main h2, main h1").first().waitFor();
    await settled(page);
    await expect.poll(() => blank(page), { timeout: 20_000, message: title }).toBe(0);
    expect(await page.evaluate(() => document.documentElement.scrollWidth), title).toBeLessThanOrEqual(360);
    expect(await keysShown(page), title).toEqual([]);
    // The address is written a moment after the click.
    if (title !== titles[0]) await expect.poll(() => page.url()).not.toBe(address);
    address = page.url();
    const again = await studio.open(address, "main h2, main h1");
    expect((await again.page.locator("header nav button[aria-current]").textContent())?.trim()).toBe(title);
    expect(again.errors).toEqual([]);
    await again.page.close();
  }
  expect(errors).toEqual([]);
});
