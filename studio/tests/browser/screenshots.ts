/** Pictures of every scene at four widths in both themes: `SCREENSHOTS=folder npm run screenshots`. */

import { mkdirSync } from "node:fs";
import { join } from "node:path";
import type { Browser } from "playwright-core";
import { afterAll, beforeAll, test } from "vitest";
import { open, Site, startBrowser } from "./site";

const FOLDER = process.env.SCREENSHOTS ?? "screenshots";
const SHOT = "#club=driver&speed=105mph&attack=2deg&path=-3deg&loft=13deg&face=1deg&toe=8mm&high=4mm&units=golf";
const SCENES = { shot: SHOT, models: `${SHOT.replace("#", "#scene=models&")}` };

let site: Site;
let browser: Browser;
beforeAll(async () => {
  mkdirSync(FOLDER, { recursive: true });
  [site, browser] = [await Site.start(), await startBrowser()];
});
afterAll(async () => {
  await browser?.close();
  await site?.stop();
});

for (const [name, link] of Object.entries(SCENES))
  for (const width of [360, 390, 1440, 3840])
    for (const theme of ["light", "dark"] as const)
      test(`${name}, ${width} px, ${theme}`, { timeout: 120_000 }, async () => {
        const height = width < 500 ? 844 : Math.round((width * 9) / 16);
        const context = await browser.newContext({ viewport: { width, height }, colorScheme: theme, locale: "en-US" });
        const { page } = await open(context, site.address + link);
        await page.waitForTimeout(500);
        await page.screenshot({ path: join(FOLDER, `${name}-${width}-${theme}.png`), fullPage: true });
        await context.close();
      });
