/** Pictures of the scenes that `clubface studio` alone has: a file on the range, its golfer, a fitting, live shots. */

import { mkdirSync } from "node:fs";
import { join } from "node:path";
import { fileURLToPath } from "node:url";
import type { Page } from "playwright-core";
import { afterAll, beforeAll, describe, test } from "vitest";
import { Monitor, newFolder, removeFolder, Served } from "../browser/served";
import { TestBrowser } from "../browser/site";

const FOLDER = process.env.SCREENSHOTS ?? "screenshots";
const SESSION = fileURLToPath(new URL("../browser/session.csv", import.meta.url));
const SIZES = { 360: 740, 390: 844, 1440: 900, 3840: 2160 };
const DOCUMENTED: Record<number, string> = { 390: "-narrow", 1440: "" };
/** Speeds of live balls [mph], launch angles and directions [deg]; the last shot has club data alone. */
const BALLS = [
  [148, 12, -2],
  [151, 14, 1],
  [144, 10, 3],
  [150, 13, 0],
  [146, 15, -3],
];
const CLUB = { Speed: 101, AngleOfAttack: 1, Loft: 13, Path: 2, FaceToTarget: 1 };

/** Each picture by what leads to it, once a file has been read. */
const PICTURES: Record<string, (page: Page) => Promise<void>> = {
  sessions: async (page) => page.locator(".shots-range path.flight-path").first().waitFor(),
  golfer: async (page) => {
    await page.getByRole("button", { name: "Golfer" }).click();
    await page.locator(".advice").waitFor();
  },
  fitting: async (page) => {
    await page.getByRole("button", { name: "Fitting" }).click();
    await page.getByRole("button", { name: "Start the fitting" }).click();
    await page.getByText("The fitting is done").waitFor();
  },
  live: async (page) => {
    await page.getByRole("button", { name: /^Live/ }).click();
    await page.locator(".large").waitFor();
  },
};
/** Those of the documentation. */
const SHOWN = ["sessions", "live"];

let folder: string;
let served: Served;
const browser = new TestBrowser();
beforeAll(async () => {
  mkdirSync(join(FOLDER, "docs"), { recursive: true });
  folder = newFolder();
  const live = ["--live", "live.jsonl", "--open-connect", "0", "--opengolfsim", "0", "--flight-relay", "0"];
  served = await Served.start(folder, ...live);
  const monitor = await Monitor.connect(served.ports["open-connect"]);
  for (const [Speed, VLA, HLA] of BALLS)
    await monitor.send({
      BallData: { Speed, VLA, HLA, TotalSpin: 2800, SpinAxis: -2 * HLA },
      ClubData: { Speed: 101 },
    });
  await monitor.send({ ClubData: CLUB });
  monitor.close();
});
afterAll(async () => {
  await served?.kill();
  removeFolder(folder);
});

describe.each(Object.entries(PICTURES))("%s", (name, lead) => {
  for (const [width, height] of Object.entries(SIZES).map((size) => size.map(Number)))
    for (const theme of ["light", "dark"] as const)
      test(`${width} px, ${theme}`, { timeout: 240_000 }, async () => {
        await browser.renew({ viewport: { width, height }, colorScheme: theme });
        const { page } = await browser.open(`${served.address}#scene=sessions&units=golf`, ".drop");
        await page.locator('input[type="file"]').setInputFiles(SESSION);
        await page.locator(".shots td").first().waitFor();
        await lead(page);
        await page.waitForTimeout(1000);
        await page.screenshot({ path: join(FOLDER, `${name}-${width}-${theme}.png`), fullPage: true });
        if (width in DOCUMENTED && SHOWN.includes(name)) {
          const file = `studio-${name}${theme === "dark" ? "-dark" : ""}${DOCUMENTED[width]}.png`;
          await page.screenshot({ path: join(FOLDER, "docs", file) });
        }
      });
});
