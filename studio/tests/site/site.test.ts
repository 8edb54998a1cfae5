/** The whole site as `make site` leaves it, opened from its files. */

import { existsSync } from "node:fs";
import { join } from "node:path";
import { fileURLToPath, pathToFileURL } from "node:url";
import type { Frame, Page } from "playwright-core";
import { beforeAll, describe, expect, test } from "vitest";
import { filesUnder } from "../../build/offline";
import { TestBrowser, violations } from "../browser/site";

const SITE = process.env.SITE ?? fileURLToPath(new URL("../../../out/site", import.meta.url));
const address = (name: string, rest = ""): string => pathToFileURL(join(SITE, name)).href + rest;
/** Where a page may load from, if it needs neither server nor network. */
const LOCAL = /^(file|data|blob):/;
/** What a browser says of the modules that it does not load from files, before one script takes their place. */
const MODULES = /studio\/assets\/|net::ERR_FAILED/;

const browser = new TestBrowser({ viewport: { width: 390, height: 844 } });

beforeAll(() => {
  if (!existsSync(join(SITE, "index.html"))) throw new Error(`${SITE} is not there: run make site`);
});

/** What a page loads from elsewhere while it is open. */
function watchLoads(page: Page): string[] {
  const elsewhere: string[] = [];
  page.on("request", (request) => {
    if (!LOCAL.test(request.url())) elsewhere.push(request.url());
  });
  return elsewhere;
}

async function liveFrame(page: Page): Promise<Frame> {
  const handle = await page.locator(".live-shot iframe").elementHandle();
  const frame = await handle?.contentFrame();
  if (!frame) throw new Error("the front page has no live picture");
  await frame.locator(".flight svg").first().waitFor();
  return frame;
}

const numberOf = async (frame: Frame, label: string): Promise<number> =>
  Number(await frame.locator(".numbers div", { hasText: label }).locator("b").textContent());

describe("every page", () => {
  const names = existsSync(SITE)
    ? filesUnder(SITE).filter((name) => name.endsWith(".html") && !name.startsWith("studio/"))
    : [];

  test.each([390, 1440])("is whole without a network and no wider than a screen of %i pixels", async (width) => {
    expect(names.length).toBeGreaterThan(50);
    await browser.renew({ viewport: { width, height: 844 } });
    const page = await browser.context.newPage();
    const elsewhere = watchLoads(page);
    const wrong: string[] = [];
    page.on("pageerror", (error) => wrong.push(String(error)));
    page.on("console", (message) => {
      if (message.type() === "error") wrong.push(message.text());
    });
    for (const name of names) {
      const before = wrong.length;
      await page.goto(address(name));
      const over = await page.evaluate(() => document.documentElement.scrollWidth - innerWidth);
      const broken = await page.evaluate(() =>
        Array.from(document.images, (image) => (image.complete && !image.naturalWidth ? image.src : "")).filter(
          Boolean,
        ),
      );
      if (over > 0) wrong.push(`${over} pixels too wide`);
      wrong.push(...broken.map((source) => `no picture ${source}`));
      for (let i = before; i < wrong.length; i += 1) wrong[i] = `${name}: ${wrong[i]}`;
    }
    expect(wrong).toEqual([]);
    expect(elsewhere).toEqual([]);
  });
});

describe("the front page", () => {
  test.each([390, 1440])("has a picture that computes, as high as it needs, at %i pixels", async (width) => {
    await browser.renew({ viewport: { width, height: 844 } });
    const { page, errors } = await browser.open(address("index.html"), ".live-shot");
    const frame = await liveFrame(page);
    const carry = await numberOf(frame, "carry");
    await frame.getByRole("slider", { name: "Club speed, slider" }).press("PageUp");
    await expect.poll(() => numberOf(frame, "carry")).toBeGreaterThan(carry);
    const loft = await numberOf(frame, "launch angle");
    await frame.locator(".face svg").click({ position: { x: 60, y: 20 } });
    await expect.poll(() => numberOf(frame, "launch angle")).not.toBe(loft);
    await expect
      .poll(() => frame.evaluate(() => document.documentElement.scrollHeight - innerHeight))
      .toBeLessThanOrEqual(0);
    expect(errors).toEqual([]);
  });

  test.each(["light", "dark"] as const)("has a picture in which axe finds no violation, %s", async (colorScheme) => {
    await browser.renew({ colorScheme });
    const { page } = await browser.open(address("studio/live.html"), ".flight svg");
    expect(await violations(page)).toEqual([]);
  });

  test("shows the numbers of the studio, which opens from its file with the same shot", async () => {
    const { page } = await browser.open(address("index.html"), ".live-shot");
    const carry = await numberOf(await liveFrame(page), "carry");
    const link = await page.locator(".live-shot figcaption a").getAttribute("href");
    expect(link).toMatch(/^studio\/index\.html#/);
    const opened = await browser.open(new URL(link ?? "", address("index.html")).href, 'td[data-quantity="carry"]');
    const shown = await opened.page.locator(".headline div", { hasText: "carry" }).locator("b").textContent();
    expect(Number(shown)).toBe(carry);
    expect(opened.errors.filter((text) => !MODULES.test(text))).toEqual([]);
  });
});

test("the studio computes finite elements from its file, in a worker", async () => {
  const { page } = await browser.open(address("studio/index.html", "#scene=elements&mesh=coarse"), ".elements");
  await page.getByText(/elements, \d+ steps in/).waitFor();
});

test("the search finds pages from files", async () => {
  const { page, errors } = await browser.open(address("search.html", "?q=gear+effect"), "#search-results li a");
  await page.getByText(/found \d+ pages/).waitFor();
  const first = page.locator("#search-results li a").first();
  expect(await first.textContent()).toMatch(/gear effect/i);
  await first.click();
  await page.getByRole("heading", { level: 1, name: /gear effect/i }).waitFor();
  expect(errors).toEqual([]);
});
