import { existsSync, readFileSync } from "node:fs";
import { fileURLToPath } from "node:url";
import { load } from "clubface-core";
import type { Download, Page } from "playwright-core";
import { describe, expect, test } from "vitest";
import { Comparison, elements, linkOf } from "../golden";
import { pictureOf, slide, TestStudio, violations } from "./site";

const path = (relative: string): string => fileURLToPath(new URL(relative, import.meta.url));
const DRIVE =
  "#scene=elements&club=driver&speed=105mph&attack=2deg&loft=13deg&toe=8mm&high=4mm&against=club&follow=contact&units=golf";
/** A case that is there at once. */
const COARSE = `${DRIVE}&mesh=coarse`;
/** What a case may take on a machine that others share [ms]. */
const PATIENCE = 110e3;
const FIRST_SHAPE = ".elements:not([data-cases='0'])";
const DONE = ".status[data-case-name='first'][data-status='done']";

const studio = new TestStudio({}, PATIENCE);

/** Values of the first column of a table by the names of their quantities. */
const valuesOf = (page: Page, table: string): Promise<Record<string, number>> =>
  page.locator(`[role="region"][aria-label^="${table}"] tbody tr`).evaluateAll((rows) =>
    Object.fromEntries(
      rows
        .map((row) => row.querySelector<HTMLElement>("td[data-value]")?.dataset ?? {})
        .filter(({ quantity }) => quantity)
        .map(({ quantity, value }) => [quantity, Number(value)]),
    ),
  );

async function allValues(page: Page): Promise<Record<string, number>> {
  const tables = ["Launch and flight", "After the throw", "Contact", "Computation"];
  return Object.assign({}, ...(await Promise.all(tables.map((table) => valuesOf(page, table)))));
}

/** The bytes of a file that a button saves. */
async function saved(page: Page, button: string): Promise<{ name: string; bytes: Buffer }> {
  const [download] = (await Promise.all([
    page.waitForEvent("download"),
    page.getByRole("button", { name: button }).click(),
  ])) as [Download, unknown];
  return { name: download.suggestedFilename(), bytes: readFileSync(await download.path()) };
}

const moment = async (page: Page): Promise<string> => (await page.locator(".player output b").textContent()) ?? "";

/** Memory that the processes of pages have written [MB], where the system says it. */
async function pageMemory(): Promise<number | null> {
  const session = await studio.browser.newBrowserCDPSession();
  const { processInfo } = (await session.send("SystemInfo.getProcessInfo")) as {
    processInfo: { type: string; id: number }[];
  };
  const sizes = processInfo
    .filter(({ type, id }) => type === "renderer" && existsSync(`/proc/${id}/status`))
    .map(({ id }) => Number(/RssAnon:\s+(\d+)/.exec(readFileSync(`/proc/${id}/status`, "utf8"))?.[1] ?? 0) / 1e3);
  return sizes.length ? Math.max(...sizes) : null;
}

describe("the numbers", () => {
  test.each([
    ["reference case", elements[0]],
    ["drive", elements[1]],
  ] as const)("of the %s are those of the package, and of the same core to the bit", async (name, golden) => {
    const { page, errors } = await studio.open(linkOf(golden, { scene: "elements", units: "golf" }), DONE);
    const here = await allValues(page);
    const core = await load(readFileSync(path("../../generated/clubface-fem.wasm")));
    const there = core.simulate(golden.setup).text as unknown as Record<string, number>;
    const comparison = new Comparison();
    for (const [quantity, value] of Object.entries(here)) {
      comparison.add(golden, quantity, value, golden.numbers[quantity]);
      if (quantity in golden.numbers && typeof there[quantity] === "number")
        expect(value, quantity).toBe(there[quantity]);
    }
    console.log(`${name}: ${comparison.count} values compared with those of the package`);
    expect(comparison.wrong).toEqual([]);
    expect(comparison.count).toBeGreaterThanOrEqual(15);
    expect(errors).toEqual([]);
  });

  test("come in time: a coarse mesh at once, a drive within seconds, in a tab of less than 300 MB", async () => {
    const started = Date.now();
    const { page } = await studio.open(DRIVE, FIRST_SHAPE);
    const first = Date.now() - started;
    await page.locator(DONE).waitFor();
    const { wall } = await valuesOf(page, "Computation");
    const status = (await page.locator(DONE).textContent()) ?? "";
    await page.locator("select[name='second']").selectOption("on");
    await page.locator(".status[data-case-name='second'][data-status='done']").waitFor();
    const memory = await pageMemory();
    console.log(
      `finite elements: first picture after ${first} ms from the opening of the page; drive on a rigid head: ` +
        `${wall.toFixed(2)} s for the steps (asked: 3 s), ${status.trim()} Memory with two cases: ${memory?.toFixed(0) ?? "?"} MB`,
    );
    // A machine that others share may take several times as long; what was asked for is printed.
    expect(wall).toBeLessThan(60);
    if (memory !== null) expect(memory).toBeLessThan(300);
  });

  test("change with the input once the slider rests, and stand next to those of the chosen model", async () => {
    const { page, errors } = await studio.open(COARSE, DONE);
    const before = await valuesOf(page, "Launch and flight");
    for (let i = 0; i < 5; i += 1) await slide(page, "Dynamic loft");
    await page.waitForFunction(
      (backspin) =>
        Number(
          document.querySelector<HTMLElement>('[aria-label^="Launch"] td[data-quantity="backspin"]')?.dataset.value,
        ) > backspin,
      before.backspin,
    );
    await page.locator(DONE).waitFor();
    const cells = page.locator('[aria-label^="Launch"] td[data-quantity="ball_speed"]');
    const speeds = await cells.evaluateAll((all) => all.map((cell) => Number((cell as HTMLElement).dataset.value)));
    expect(speeds).toHaveLength(2);
    // A rigid-body model was fitted to the finer mesh: some per cent of a coarse one.
    expect(Math.abs(speeds[1] / speeds[0] - 1)).toBeLessThan(0.03);
    expect(errors).toEqual([]);
  });
});

describe("the pictures", () => {
  test("follow the moment, the cut and the colour", async () => {
    const { page, errors } = await studio.open(`${COARSE}&impact_moment=100us`, DONE);
    const canvases = [
      "[data-stage='elements-first'] canvas",
      "[data-patch='first-normal']",
      "[data-patch='first-tangential']",
    ];
    const pictures = (): Promise<string[]> => Promise.all(canvases.map((canvas) => pictureOf(page, canvas)));
    await page.locator(canvases[0]).waitFor();
    await page.waitForTimeout(500);
    expect(await moment(page)).toMatch(/^(9\d|10\d) /);
    const before = await pictures();
    await page.getByRole("slider", { name: "Moment" }).press("PageUp");
    await page.waitForTimeout(300);
    const after = await pictures();
    after.forEach((picture, i) => {
      expect(picture, canvases[i]).not.toBe(before[i]);
    });
    await page.waitForURL(/impact_moment=(1[1-9]|[2-9]\d)\d/);
    await page.locator("select[name='cut']").selectOption("whole");
    await page.waitForTimeout(300);
    const whole = await pictureOf(page, canvases[0]);
    expect(whole).not.toBe(after[0]);
    await page.locator("select[name='colour']").selectOption("pieces");
    await page.waitForTimeout(300);
    expect(await pictureOf(page, canvases[0])).not.toBe(whole);
    expect(errors).toEqual([]);
  });

  test("show shear of both signs while the force along the face turns, and none after the ball has left", async () => {
    const { page } = await studio.open(`${COARSE}&impact_moment=200us`, DONE);
    const label = (name: string): Promise<string | null> =>
      page.locator(`[data-patch="first-${name}"]`).getAttribute("aria-label");
    const [, least, greatest] = /from (-?[\d.]+) MPa to (-?[\d.]+) MPa/.exec((await label("tangential")) ?? "") ?? [];
    expect(Number(least)).toBeLessThan(0);
    expect(Number(greatest)).toBeGreaterThan(0);
    expect(await label("normal")).toMatch(/Pressure .* from 0|Pressure .* from [1-9]/);
    await page.getByRole("slider", { name: "Moment" }).press("End");
    await page.waitForTimeout(200);
    expect(await label("normal")).toContain("does not touch");
  });

  test("are played and paused by the keyboard, and few with reduced motion", async () => {
    const { page } = await studio.open(`${COARSE}&impact_moment=0us`, DONE);
    const play = page.getByRole("button", { name: "Play" });
    await play.focus();
    await page.keyboard.press("Enter");
    await page.waitForTimeout(600);
    await page.getByRole("button", { name: "Pause" }).press("Enter");
    const paused = await moment(page);
    expect(paused).not.toMatch(/^0 /);
    await page.waitForTimeout(300);
    expect(await moment(page)).toBe(paused);
    await page.emulateMedia({ reducedMotion: "reduce" });
    await page.getByRole("slider", { name: "Moment" }).press("Home");
    const shapes = page.evaluate(
      () =>
        new Promise<number>((resolve) => {
          const seen = new Set<string>();
          const look = (): void => {
            seen.add(document.querySelector(".player output b")?.textContent ?? "");
            if (document.querySelector("[data-playing]") || seen.size < 2) requestAnimationFrame(look);
            else resolve(seen.size);
          };
          look();
        }),
    );
    await page.getByRole("button", { name: "Play" }).click();
    // Of some fifty shapes.
    expect(await shapes).toBeLessThanOrEqual(10);
  });

  test("are saved as an image and as a video", async () => {
    const { page, errors } = await studio.open(COARSE, DONE);
    await page.locator("[data-stage='elements-first'] canvas").waitFor();
    const picture = await saved(page, "Picture (PNG)");
    expect(picture.name).toBe("impact.png");
    expect(picture.bytes.subarray(1, 4).toString()).toBe("PNG");
    expect(picture.bytes.readUInt32BE(16)).toBe(800);
    expect(picture.bytes.length).toBeGreaterThan(30e3);
    const video = await saved(page, "Video (WebM)");
    expect(video.name).toBe("impact.webm");
    // EBML, in which every WebM begins.
    expect(video.bytes.readUInt32BE(0)).toBe(0x1a45dfa3);
    expect(video.bytes.length).toBeGreaterThan(30e3);
    await page.getByRole("button", { name: "Video (WebM)" }).waitFor();
    expect(errors).toEqual([]);
  });
});

describe("a second case", () => {
  test("stands next to the first, with lines of its own in the charts", async () => {
    const { page, errors } = await studio.open(`${COARSE}&second=on&second_loft=20deg`, DONE);
    await page.locator(".status[data-case-name='second'][data-status='done']").waitFor();
    await page.locator("[data-stage='elements-second'] canvas").waitFor();
    expect(await page.locator("[data-patch^='second-']").count()).toBe(2);
    const lost = await page
      .locator("[data-stage] canvas")
      .evaluateAll((all) => all.map((canvas) => (canvas as HTMLCanvasElement).getContext("webgl2")?.isContextLost()));
    expect(lost).toEqual([false, false]);
    const label = await page.locator("[data-chart='elements-spin']").getAttribute("aria-label");
    const [first, second] = [...(label ?? "").matchAll(/to (\d+) rpm/g)].map(([, number]) => Number(number));
    expect(second).toBeGreaterThan(1.2 * first);
    const before = await pictureOf(page, "[data-patch='second-tangential']");
    const friction = page.getByRole("textbox", { name: "Friction, second" });
    await friction.fill("0.1");
    await friction.press("Enter");
    await page.locator(".status[data-case-name='second'][data-status='going']").waitFor();
    await page.locator(".status[data-case-name='second'][data-status='done']").waitFor();
    await page.waitForTimeout(300);
    expect(await pictureOf(page, "[data-patch='second-tangential']")).not.toBe(before);
    await page.waitForURL(/second_friction=0\.1/);
    expect(errors).toEqual([]);
  });
});

describe("what goes wrong", () => {
  test("a computation is stopped, keeps the coarse mesh, and goes on when asked", async () => {
    const { page, errors } = await studio.open(DRIVE, FIRST_SHAPE);
    await page.getByRole("button", { name: "Stop" }).click();
    await page.locator(".status[data-status='stopped'][data-mesh='coarse']").waitFor();
    await page.waitForTimeout(500);
    expect(await page.locator(".status").getAttribute("data-status")).toBe("stopped");
    await page.getByRole("button", { name: "Compute" }).click();
    await page.locator(`${DONE}[data-mesh='fine']`).waitFor();
    expect(errors).toEqual([]);
  });

  test("says why: a ball without pieces, values out of their limits, a strike off the face", async () => {
    const { page, errors } = await studio.open(`${COARSE}&ball=published`, ".status[data-status='impossible']");
    await page.getByRole("alert").getByText("The layers of the ball of the published models").waitFor();
    await page.getByRole("button", { name: "modern", exact: true }).click();
    await page.locator(DONE).waitFor();
    const friction = page.getByRole("textbox", { name: "Friction", exact: true });
    await friction.fill("-1");
    await friction.press("Enter");
    await page.getByRole("alert").getByText("friction -1.000; it must be from 0.000 to 10.000").waitFor();
    await page.getByRole("button", { name: "Undo" }).click();
    await page.locator(DONE).waitFor();
    expect(errors).toEqual([]);
    const off = await studio.open(COARSE.replace("toe=8mm", "toe=90mm"), ".status[data-status='failed']");
    await off.page
      .getByRole("alert")
      .getByText(/This case cannot be computed: toe/)
      .waitFor();
    const wall = await studio.open(`${COARSE}&against=wall`, DONE);
    await wall.page.getByText("wall is unknown; there are club, plane, paper").waitFor();
  });
});

describe("for everyone", () => {
  test("axe finds nothing, with one case or two, in both themes", async () => {
    for (const link of [COARSE, `${COARSE}&second=on&second_speed=90mph&theme=dark`]) {
      const { page } = await studio.open(link, DONE);
      await page.locator("[data-stage='elements-first'] canvas").waitFor();
      expect(await violations(page)).toEqual([]);
      await page.close();
    }
  });

  test("a narrow page does not scroll sideways", async () => {
    await studio.renew({ viewport: { width: 360, height: 740 } });
    const { page } = await studio.open(`${COARSE}&second=on`, DONE);
    const width = await page.evaluate(() => document.documentElement.scrollWidth);
    expect(width).toBeLessThanOrEqual(360);
  });

  test("a published case is a press, and every step is undone", async () => {
    const { page } = await studio.open(COARSE, DONE);
    await page.locator('[data-case="paper"]').click();
    await page.locator(DONE).waitFor();
    await page.waitForURL(/against=paper/);
    const { reversal_time } = await valuesOf(page, "Contact");
    // Roh and Lee: 320 us; the coarse mesh is stiffer.
    expect(reversal_time).toBeGreaterThan(250e-6);
    expect(reversal_time).toBeLessThan(350e-6);
    await page.getByRole("button", { name: "Undo" }).click();
    await page.waitForURL(/against=club/);
  });
});
