/**
 * Pictures of every scene in both themes: whole pages at four widths to look at, and the first screen of two for the
 * documentation. `SCREENSHOTS=folder npm run screenshots`.
 */

import { mkdirSync } from "node:fs";
import { join } from "node:path";
import { describe, test } from "vitest";
import { TestStudio } from "../browser/site";

const FOLDER = process.env.SCREENSHOTS ?? "screenshots";
const SHOT = "#club=driver&speed=105mph&attack=2deg&path=4deg&loft=13deg&face=1deg&toe=8mm&high=4mm&units=golf";
/** Each scene by its link, and by what it shows when it is whole. */
const SCENES: Record<string, [link: string, ready: string]> = {
  shot: [SHOT, "[data-quantity]"],
  elements: [
    SHOT.replace("#", "#scene=elements&impact_moment=260us&"),
    ".status[data-status='done'][data-mesh='fine']",
  ],
  flight: [SHOT.replace("#", "#scene=flight&wind=12mph&wind_from=60deg&"), "[data-stage=range] canvas"],
  map: [SHOT.replace("#", "#scene=map&map=carry&"), "[data-loss=carry]"],
  design: [
    SHOT.replace("#", "#scene=design&cg_x=45mm&upwards=iyy&struck_by=handicap-10-driver&"),
    ".optimum path.contour",
  ],
  models: [SHOT.replace("#", "#scene=models&"), ".models td"],
  learn: [SHOT.replace("#", "#scene=learn&lesson=gear&"), ".answer data"],
};
const SIZES = { 360: 740, 390: 844, 1440: 900, 3840: 2160 };
/** Widths whose first screen stands in the documentation, with the ending of its name. */
const DOCUMENTED: Record<number, string> = { 390: "-narrow", 1440: "" };

const studio = new TestStudio({}, 100e3);
mkdirSync(join(FOLDER, "docs"), { recursive: true });

describe.each(Object.entries(SCENES))("%s", (name, [link, ready]) => {
  for (const [width, height] of Object.entries(SIZES).map((size) => size.map(Number)))
    for (const theme of ["light", "dark"] as const)
      test(`${width} px, ${theme}`, { timeout: 120_000 }, async () => {
        await studio.renew({ viewport: { width, height }, colorScheme: theme });
        const { page } = await studio.open(link, ready);
        await page.waitForTimeout(500);
        await page.screenshot({ path: join(FOLDER, `${name}-${width}-${theme}.png`), fullPage: true });
        if (width in DOCUMENTED) {
          const file = `studio-${name}${theme === "dark" ? "-dark" : ""}${DOCUMENTED[width]}.png`;
          await page.screenshot({ path: join(FOLDER, "docs", file) });
        }
      });
});
