import { execFileSync } from "node:child_process";
import { mkdirSync, readFileSync, writeFileSync } from "node:fs";
import { join } from "node:path";
import { fileURLToPath } from "node:url";
import type { Page } from "playwright-core";
import { afterAll, beforeAll, describe, expect, test } from "vitest";
import { PYTHON } from "./command-line";
import { Monitor, newFolder, removeFolder, Served } from "./served";
import { drop, Site, siValueOf, TestBrowser, violations } from "./site";

const SESSION = fileURLToPath(new URL("session.csv", import.meta.url));
const LIVE = ["--live", "live.jsonl", "--open-connect", "0", "--opengolfsim", "0", "--flight-relay", "0"];
const SCENE = "#scene=sessions&club=driver&speed=105mph&units=golf";
const MPH = 0.44704;
/** A study of four drives. */
const STUDY = `
[impact]
club = "driver"
model = "standard"
held = { speed = "105 mph" }
outputs = ["ball_speed", "carry"]
[sweep]
loft = { from = "8 deg", to = "14 deg", count = 4 }
`;
/** What a browser says of an answer that is no success, which a test asks for. */
const REFUSED = /status of 422/;

const browser = new TestBrowser();
let folder: string;
let served: Served;

beforeAll(async () => {
  folder = newFolder();
  mkdirSync(join(folder, "studies"));
  writeFileSync(join(folder, "studies", "lofts.toml"), STUDY);
  execFileSync(PYTHON, ["-m", "clubface", "study", "run", "lofts.toml", "--workers", "1"], {
    cwd: join(folder, "studies"),
  });
  served = await Served.start(folder, ...LIVE, "--studies", "studies");
});
afterAll(async () => {
  await served?.kill();
  removeFolder(folder);
});

const part = (page: Page, name: string): Promise<void> =>
  page.getByRole("navigation", { name: "Parts of your shots" }).getByRole("button", { name }).click();

/** Opens the scene with a file. */
async function withFile(file: string | { name: string; content: string | Buffer }, address = served.address) {
  const opened = await browser.open(address + SCENE, ".drop");
  const input = opened.page.locator('input[type="file"]');
  if (typeof file === "string") await input.setInputFiles(file);
  else await input.setInputFiles({ name: file.name, mimeType: "text/csv", buffer: Buffer.from(file.content) });
  return opened;
}

const drawing = (page: Page): Promise<string> => page.locator(".shots-range svg").last().innerHTML();
const count = (page: Page): Promise<string | null> => page.locator(".filters output").textContent();

describe("a file", () => {
  test("its shots lie on the range and stand in the table, as the file has them", async () => {
    const { page, errors } = await withFile(SESSION);
    await page.locator(".shots td[data-quantity]").first().waitFor();
    const [head, first] = readFileSync(SESSION, "utf8").split("\n");
    const column = head.split(",").indexOf("ball_speed_mph");
    expect(await siValueOf(page, "ball_speed")).toBeCloseTo(Number(first.split(",")[column]) * MPH, 9);
    expect(await page.locator(".shots tbody tr").count()).toBe(51);
    expect(await page.locator(".shots-range svg").last().getAttribute("aria-label")).toMatch(
      /^51 shots from above: they land after [\d.]+ yd to [\d.]+ yd, from [\d.]+ yd left to [\d.]+ yd right\.$/,
    );
    expect(await page.locator(".shots-range path.flight-path").count()).toBe(102);
    // The carry was measured; the height was not.
    expect(await page.locator('td[data-quantity="carry"]').first().getAttribute("class")).toBeNull();
    expect(await page.locator('td[data-quantity="apex"]').first().getAttribute("class")).toBe("computed");
    expect(errors).toEqual([]);
  });

  test("a club alone, mishits left out and a marked shot change the picture; the units change the numbers", async () => {
    const { page, errors } = await withFile(SESSION);
    await page.locator(".shots td[data-quantity]").first().waitFor();
    const all = await drawing(page);
    await page.locator('select[name="club-of-file"]').selectOption("7-iron");
    expect(await count(page)).toBe("20 of 51 shots");
    const irons = await drawing(page);
    expect(irons).not.toBe(all);
    await page.locator('select[name="club-of-file"]').selectOption("");
    await page.locator('select[name="mishits"]').selectOption("hidden");
    expect(await count(page)).toBe("47 of 51 shots");
    await page.waitForURL(/mishits=hidden/);
    const usual = await drawing(page);
    await page.locator(".shots tbody button").first().press("Enter");
    expect(await page.locator(".shots tbody button").first().getAttribute("aria-pressed")).toBe("true");
    expect(await drawing(page)).not.toBe(usual);
    expect(await page.locator(".shots-range path.marked").count()).toBe(2);
    const yards = await page.locator(".shots thead").textContent();
    await page.locator('select[name="units"]').selectOption("metric");
    expect(await page.locator(".shots thead").textContent()).not.toBe(yards);
    await page.keyboard.press("Control+z");
    expect(await page.locator(".shots thead").textContent()).toBe(yards);
    expect(errors).toEqual([]);
  });

  test("the report is there without any script, and the golfer with his figures", async () => {
    const { page, errors } = await withFile(SESSION);
    await page.locator(".shots td[data-quantity]").first().waitFor();
    await part(page, "Report");
    const frame = page.locator("iframe.report");
    await frame.waitFor();
    expect(await frame.getAttribute("sandbox")).toBe("allow-downloads");
    await page.frameLocator("iframe.report").getByRole("heading", { name: "Your shots, and what they say" }).waitFor();
    // It has the theme that was chosen for the page, whatever that of the system.
    const ink = (): Promise<string> =>
      page
        .frameLocator("iframe.report")
        .locator("body")
        .evaluate((body) => getComputedStyle(body).color);
    const light = await ink();
    await page.locator('select[name="theme"]').selectOption("dark");
    await expect.poll(ink).not.toBe(light);
    await part(page, "Golfer");
    await page.getByRole("row", { name: /club speed/ }).waitFor();
    expect(await page.locator('select[name="golfer-club"]').inputValue()).toBe("driver");
    const driver = await page.getByRole("row", { name: /club speed/ }).textContent();
    expect(driver).toMatch(/9\d\.\d mph/);
    // Its sentences are in the units of the page, and golfers of the package have their titles.
    const sentences = page.locator("section[aria-labelledby=golfer] :is(p, li)");
    await expect.poll(async () => (await sentences.allTextContents()).join()).toMatch(/\d mph/);
    expect((await sentences.allTextContents()).join()).not.toMatch(/bogey-driver|\d deg\b/);
    await page.locator('select[name="units"]').selectOption("metric");
    await expect.poll(async () => (await sentences.allTextContents()).join()).toMatch(/\d m\/s/);
    expect((await sentences.allTextContents()).join()).not.toMatch(/\d mph/);
    await page.locator('select[name="units"]').selectOption("golf");
    await page.locator('select[name="golfer-club"]').selectOption("7-iron");
    await page.getByText("my golfer, 7-iron").waitFor();
    expect(await page.getByRole("row", { name: /club speed/ }).textContent()).not.toBe(driver);
    const [download] = await Promise.all([
      page.waitForEvent("download"),
      page.getByRole("link", { name: "Save the golfer" }).click(),
    ]);
    expect(readFileSync(await download.path(), "utf8")).toContain('club = "7-iron"');
    expect(errors).toEqual([]);
  });

  test.each([
    ["empty", "", "empty"],
    ["binary", Buffer.from([0, 1, 2, 3, 0, 255, 254, 0]), "session.csv"],
    ["a web page", "<html><script>alert(1)</script></html>", "session.csv"],
    ["another table", "name,price\nball,3\n", "session.csv"],
  ])("one that is %s is refused with a sentence", async (_, content, words) => {
    const { page, errors } = await withFile({ name: "session.csv", content });
    const alert = page.locator('.drop [role="alert"]');
    await alert.waitFor();
    expect(await alert.textContent()).toContain(words);
    expect(errors.filter((each) => !REFUSED.test(each))).toEqual([]);
    // A good file is read after a bad one.
    await page.locator('input[type="file"]').setInputFiles(SESSION);
    await page.locator(".shots td[data-quantity]").first().waitFor();
    expect(await alert.count()).toBe(0);
  });

  test("units that it lacks are given on the page", async () => {
    const { page } = await withFile({ name: "bare.csv", content: "Ball Speed,Launch Angle\n147,12\n146,11\n" });
    await page.locator('.drop [role="alert"]').getByText("unit").waitFor();
    await page.locator('select[name="read-speed"]').selectOption("mph");
    await page.locator('select[name="read-angle"]').selectOption("deg");
    await page.getByRole("button", { name: "Read it again" }).click();
    await page.locator(".shots td[data-quantity]").first().waitFor();
    expect(await siValueOf(page, "ball_speed")).toBeCloseTo(147 * MPH, 9);
  });

  test("one that is dropped on the page is read", async () => {
    const { page, errors } = await browser.open(served.address + SCENE, ".drop");
    await drop(page, ".drop", "dropped.csv", readFileSync(SESSION, "utf8"));
    await page.getByText("dropped.csv (clubface): 31 driver, 20 7-iron").first().waitFor();
    expect(errors).toEqual([]);
  });
});

describe("a fitting", () => {
  test("shows how far it is, and what to do", async () => {
    const { page, errors } = await withFile(SESSION);
    await page.locator(".shots td[data-quantity]").first().waitFor();
    await part(page, "Fitting");
    await page.locator('select[name="loft-range"]').selectOption("");
    await page.getByRole("button", { name: "Start the fitting" }).click();
    await page.getByText("The fitting is done.").waitFor();
    expect(await page.locator(".advice").textContent()).toMatch(/^(Keep|Change)/);
    expect(await page.getByRole("region", { name: "All combinations" }).locator("tbody tr").count()).toBe(2);
    expect(errors).toEqual([]);
  });

  test("is cancelled while it runs", async () => {
    const { page, errors } = await withFile(SESSION);
    await page.locator(".shots td[data-quantity]").first().waitFor();
    await part(page, "Fitting");
    for (const ball of ["conforming", "reference", "of Roh and Lee"])
      await page.getByLabel(ball, { exact: true }).check();
    await page.locator("summary", { hasText: "Other heads" }).click();
    for (const head of ["3-wood", "5-wood", "hybrid"]) await page.getByLabel(head, { exact: true }).check();
    await page.getByRole("button", { name: "Start the fitting" }).click();
    const bar = page.getByRole("progressbar");
    await bar.waitFor();
    await page.waitForFunction(() => document.querySelector("progress")?.max === 20);
    await page.getByRole("button", { name: "Cancel" }).click();
    await page.getByText(/The fitting was cancelled: \d+ of 20 combinations\./).waitFor();
    expect(await bar.count()).toBe(0);
    expect(errors).toEqual([]);
  });
});

test("a study of the folder that was named is there with its summary", async () => {
  const { page, errors } = await browser.open(`${served.address}${SCENE}&part=studies`, ".studies button");
  expect(await page.locator(".studies li").textContent()).toMatch(/lofts\s+4 tasks, complete/);
  await page.locator(".studies button").click();
  await page.frameLocator("iframe.report").getByText("4 tasks").first().waitFor();
  expect(errors).toEqual([]);
});

describe("live shots", () => {
  const whole = (speed: number) => ({
    BallData: { Speed: speed, VLA: 12, HLA: 1, TotalSpin: 2800, SpinAxis: 4, CarryDistance: 230 },
  });

  test("every tab shows them, the newest large, measured and computed apart", async () => {
    const tabs = [];
    for (let i = 0; i < 2; i += 1) tabs.push(await browser.open(`${served.address}${SCENE}&part=live`, ".newest"));
    const monitor = await Monitor.connect(served.ports["open-connect"]);
    const before = await tabs[0].page.locator(".shots-range svg").count();
    expect(await monitor.send(whole(150))).toBe(200);
    for (const { page } of tabs) {
      await page.getByRole("heading", { name: /^Shot 1, a / }).waitFor();
      expect(await page.locator('[data-large="ball_speed"]').textContent()).toContain("150.0");
      expect(await page.locator('[data-large="ball_speed"] .origin').textContent()).toBe("measured");
      expect(await page.locator('[data-large="carry"] .origin').textContent()).toBe("measured");
      expect(await page.locator('[data-large="apex"] .origin').textContent()).toBe("computed");
    }
    expect(await tabs[0].page.locator(".shots-range svg").count()).toBeGreaterThan(before);
    const picture = await drawing(tabs[0].page);
    await tabs[1].page.locator('select[name="live-club"]').selectOption("7-iron");
    await tabs[0].page.waitForFunction(
      () => document.querySelector<HTMLSelectElement>('select[name="live-club"]')?.value === "7-iron",
    );
    expect(await monitor.send({ ClubData: { Speed: 85, AngleOfAttack: -4, Loft: 26, Path: 1 } })).toBe(200);
    for (const { page, errors } of tabs) {
      await page.getByRole("heading", { name: /^Shot 2, a / }).waitFor();
      expect(await page.locator('[data-large="ball_speed"] .origin').textContent()).toBe("computed");
      expect(await page.locator('[data-large="speed"] .origin').textContent()).toBe("measured");
      expect(await page.locator(".shots tbody tr").first().textContent()).toContain("7-iron");
      expect(errors).toEqual([]);
    }
    expect(await drawing(tabs[0].page)).not.toBe(picture);
    monitor.close();
  });

  test("none is lost when the server is killed", async () => {
    const own = newFolder();
    let server = await Served.start(own, ...LIVE);
    const { page } = await browser.open(`${server.address}${SCENE}&part=live`, ".newest");
    const monitor = await Monitor.connect(server.ports["open-connect"]);
    for (const speed of [140, 141, 142]) await monitor.send(whole(speed));
    await page.getByRole("heading", { name: /^Shot 3/ }).waitFor();
    await server.kill();
    await page.getByText("The server has ended or cannot be reached. No shot is lost").waitFor();
    server = await Served.start(own, ...LIVE);
    const again = await browser.open(`${server.address}${SCENE}&part=live`, ".newest");
    await again.page.getByRole("heading", { name: /^Shot 3/ }).waitFor();
    expect(await again.page.locator(".shots tbody tr").count()).toBe(3);
    expect(await again.page.locator('[data-large="ball_speed"]').textContent()).toContain("142.0");
    expect(again.errors).toEqual([]);
    await server.kill();
    removeFolder(own);
  });
});

describe("the page", () => {
  test("everything is reached by the keyboard", async () => {
    const { page, errors } = await withFile(SESSION);
    await page.locator(".shots td[data-quantity]").first().waitFor();
    await page.locator(".skip").focus();
    const reached = new Set<string>();
    for (let i = 0; i < 40 && !reached.has("shot"); i += 1) {
      await page.keyboard.press("Tab");
      const name = await page.evaluate(() => {
        const element = document.activeElement as HTMLElement;
        if (element.closest(".shots tbody")) return "shot";
        return element.closest(".parts") ? (element.textContent ?? "").trim() : (element.getAttribute("name") ?? "");
      });
      reached.add(name);
      if (name === "Report") {
        await page.keyboard.press("Enter");
        await page.waitForURL(/part=report/);
        await page.keyboard.press("Control+z");
        await page.locator(".shots td[data-quantity]").first().waitFor();
      }
    }
    for (const name of [
      "session",
      "Shots",
      "Report",
      "Golfer",
      "Fitting",
      "Studies",
      "club-of-file",
      "mishits",
      "shot",
    ])
      expect(reached).toContain(name);
    expect(errors).toEqual([]);
  });

  test.each([
    [1280, "light"],
    [360, "dark"],
  ] as const)("axe finds nothing wrong in any part at %i px, %s", async (width, colorScheme) => {
    await browser.renew({ viewport: { width, height: 800 }, colorScheme });
    const { page, errors } = await withFile(SESSION);
    await page.locator(".shots td[data-quantity]").first().waitFor();
    for (const [name, ready] of [
      ["Shots", ".shots"],
      ["Golfer", ".advice"],
      ["Fitting", "button.main"],
      ["Studies", "#studies"],
      ["Live", ".newest"],
    ]) {
      await part(page, name);
      await page.locator(ready).first().waitFor();
      expect(await violations(page), name).toEqual([]);
      expect(await page.evaluate(() => document.documentElement.scrollWidth), name).toBeLessThanOrEqual(width);
    }
    expect(errors).toEqual([]);
  });

  test("a static site says how the scene is had, and asks nothing", async () => {
    const site = await Site.start();
    const { page, errors } = await browser.open(site.address + SCENE, ".sessions");
    await page.getByText("clubface studio --open").waitFor();
    expect(await page.locator(".drop").count()).toBe(0);
    expect(errors).toEqual([]);
    await site.stop();
  });

  test("without the word of its address nothing is answered", async () => {
    const { origin } = new URL(served.address);
    const page = await browser.context.newPage();
    const answer = await page.goto(`${origin}/api/`);
    expect(answer?.status()).toBe(403);
    expect(await page.textContent("body")).toContain("open the whole address that clubface studio printed");
  });
});
