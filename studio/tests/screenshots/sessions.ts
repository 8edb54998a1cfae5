/** Pictures of the scenes that `clubface studio` alone has: a file on the range, its golfer, a fitting, live shots. */

import { fileURLToPath } from "node:url";
import type { Page } from "playwright-core";
import { afterAll, beforeAll } from "vitest";
import { Monitor, newFolder, removeFolder, Served } from "../browser/served";
import { TestBrowser } from "../browser/site";
import { drawScene } from "../pictures";

const SESSION = fileURLToPath(new URL("../browser/session.csv", import.meta.url));
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
  report: async (page) => {
    await page.getByRole("button", { name: "Report" }).click();
    await page.frameLocator("iframe.report").getByRole("heading").first().waitFor();
  },
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

for (const [name, lead] of Object.entries(PICTURES))
  drawScene(name, {
    isDocumented: SHOWN.includes(name),
    timeout: 240e3,
    show: async (screen) => {
      await browser.renew(screen);
      const { page } = await browser.open(`${served.address}#scene=sessions&units=golf`, ".drop");
      await page.locator('input[type="file"]').setInputFiles(SESSION);
      await page.locator(".shots td").first().waitFor();
      await lead(page);
      await page.waitForTimeout(1000);
      return page;
    },
  });
