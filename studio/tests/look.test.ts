import type { Browser } from "playwright-core";
import { afterAll, beforeAll, expect, test } from "vitest";
import { open, Site, startBrowser } from "./browser/site";
const SHOT = "#club=driver&speed=105mph&attack=2deg&path=4deg&loft=13deg&face=1deg&toe=8mm&high=4mm&units=golf";
const s = (x: string) => SHOT.replace("#", `#${x}&`);
const S: Record<string, [string, string]> = {
  shot: [SHOT, "[data-quantity]"],
  models: [s("scene=models"), ".models td"],
  flight: [s("scene=flight&wind=12mph&wind_from=60deg"), "[data-stage=range] canvas"],
  map: [s("scene=map&map=carry"), "[data-loss=carry]"],
  "learn-gear": [s("scene=learn&lesson=gear"), ".answer data"],
  "learn-monitors": [s("scene=learn&lesson=monitors"), ".answer data"],
  sessions: ["#scene=sessions&units=golf", "main"],
  "flight-clubs": [s("scene=flight&wind=12mph&wind_from=60deg&flying=clubs"), "[data-stage=range] canvas"],
  "flight-golfer": [s("scene=flight&wind=12mph&wind_from=60deg&flying=golfer"), "[data-stage=range] canvas"],
  elements: [s("scene=elements&impact_moment=260us"), ".status[data-status='done'][data-mesh='fine']"],
};
const V: [number, number, "light" | "dark"][] = [[1440, 900, "light"], [390, 844, "dark"], [3840, 2160, "light"]];
let site: Site; let browser: Browser;
beforeAll(async () => { [site, browser] = [await Site.start(), await startBrowser()]; });
afterAll(async () => { await browser?.close(); await site?.stop(); });
test("look", async () => {
  const jobs = V.flatMap((v) => Object.entries(S).map((e) => [v, e] as const));
  const work = async () => {
    for (let j = jobs.shift(); j; j = jobs.shift()) {
      const [[width, height, theme], [name, [link, ready]]] = j;
      const t = Date.now();
      const context = await browser.newContext({ viewport: { width, height }, colorScheme: theme, locale: "en-US" });
      context.setDefaultTimeout(150e3);
      try {
        const { page, errors } = await open(context, site.address + link, "main").catch((e) => { throw e; });
        let late = "";
        await page.locator(ready).first().waitFor({ state: "attached", timeout: 120e3 }).catch(() => { late = "NOT READY"; });
        await page.waitForFunction(() => !document.querySelector("[aria-busy=true]"), null, { timeout: 40e3 }).catch(() => { late += " busy"; });
        await page.waitForTimeout(4000);
        const wide = await page.evaluate(() => [document.documentElement.scrollWidth, innerWidth]);
        await page.screenshot({ path: `/work/h/look2/${name}-${width}-${theme}.png`, fullPage: width < 3000 });
        console.log(name, width, late, Date.now() - t, wide.join("/"), errors.join("|").slice(0, 300));
      } catch (e) { console.log("FAILED", name, width, String(e).slice(0, 200)); }
      await context.close();
    }
  };
  await Promise.all([work(), work()]);
  expect(1).toBe(1);
}, 1100e3);
