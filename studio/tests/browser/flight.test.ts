import type { Page } from "playwright-core";
import { describe, expect, test } from "vitest";
import { equipment } from "../described";
import { Comparison, dispersions, flights, linkOf } from "../golden";
import {
  goTo,
  type Opened,
  otherValue,
  pictureOf,
  quantitiesOf,
  siValueOf,
  slide,
  TestStudio,
  violations,
} from "./site";

const FIRST = "#scene=flight&club=driver&speed=105mph&attack=2deg&loft=13deg&units=golf";
const CANVAS = '[data-stage="range"] canvas';
const studio = new TestStudio();

/** Waits until a picture is another than before, and returns it. */
async function otherPicture(page: Page, before: string, selector = CANVAS): Promise<string> {
  await page.waitForFunction(
    ([name, picture]) => document.querySelector<HTMLCanvasElement>(name)?.toDataURL() !== picture,
    [selector, before],
  );
  return pictureOf(page, selector);
}

/** The picture once it stays as it is. */
async function stillPicture(page: Page, selector = CANVAS): Promise<string> {
  let before = "";
  for (;;) {
    const now = await pictureOf(page, selector);
    if (now === before) return now;
    before = now;
    await page.waitForTimeout(300);
  }
}

/** In the page: how many other pictures a canvas shows until it shows the first one again. */
async function picturesUntilBack([selector, first]: [string, string]): Promise<number> {
  const seen = new Set<string>();
  const end = performance.now() + 60_000;
  while (performance.now() < end) {
    await new Promise((resolve) => setTimeout(resolve, 60));
    const now = document.querySelector<HTMLCanvasElement>(selector)?.toDataURL() ?? "";
    if (now === first && seen.size) return seen.size;
    if (now !== first) seen.add(now);
  }
  throw new Error("the picture does not come back");
}

const openRange = async (link: string): Promise<Opened> => {
  const opened = await studio.open(link, CANVAS);
  await opened.page.locator("[data-air=density]").getByText("kg/m³").waitFor();
  return opened;
};

describe("the range", () => {
  test("wind changes numbers, picture, words and the link, and holds in the other scenes", async () => {
    const { page, errors } = await openRange(FIRST);
    const before = await stillPicture(page);
    const [carry, side] = [await siValueOf(page, "carry"), await siValueOf(page, "side")];
    await page.getByRole("textbox", { name: "Wind speed" }).fill("20 mph");
    await page.keyboard.press("Enter");
    const against = await otherValue(page, "carry", carry);
    expect(against).toBeLessThan(carry - 10);
    const headwind = await otherPicture(page, before);
    await page.getByRole("textbox", { name: "Wind from" }).fill("90");
    await page.keyboard.press("Enter");
    expect(await otherValue(page, "side", side)).toBeLessThan(side - 10);
    await otherPicture(page, headwind);
    await page.waitForURL(/wind=20mph&wind_from=90deg/);
    await page.getByRole("complementary").getByText("wind 20.0 mph from the right").waitFor();
    const blown = await siValueOf(page, "side");
    await page.getByRole("button", { name: "Shot", exact: true }).click();
    await page.locator(".flight svg").first().waitFor();
    expect(await siValueOf(page, "side")).toBe(blown);
    await page.getByRole("button", { name: "Usual conditions" }).click();
    expect(await otherValue(page, "side", blown)).toBe(side);
    expect(errors).toEqual([]);
  });

  test("altitude thins the air, a given pressure takes its place, and the ground stops the ball", async () => {
    const { page, errors } = await openRange(FIRST);
    const pressure = page.locator("[data-air=pressure]");
    const [carry, total] = [await siValueOf(page, "carry"), await siValueOf(page, "total")];
    await page.getByRole("textbox", { name: "Altitude" }).fill("1600 m");
    await page.keyboard.press("Enter");
    const high = await otherValue(page, "carry", carry);
    expect(high).toBeGreaterThan(carry * 1.02);
    await pressure.getByText("835.2 hPa").waitFor();
    await page.getByText("A measured pressure").click();
    await page.getByRole("textbox", { name: "Air pressure" }).fill("1040");
    await page.keyboard.press("Enter");
    expect(await otherValue(page, "carry", high)).toBeLessThan(carry);
    await page.getByText("does not count, since the pressure is given").waitFor();
    await page.getByRole("combobox", { name: "Ground" }).selectOption("soft green");
    expect(await otherValue(page, "total", total)).toBeLessThan(total);
    expect(errors).toEqual([]);
  });

  test("is seen from three sides, by keys too; each view undone", async () => {
    const { page, errors } = await openRange(FIRST);
    const behind = await stillPicture(page);
    await page.getByRole("button", { name: "From the side" }).press("Enter");
    const side = await otherPicture(page, behind);
    await page.getByRole("button", { name: "From above" }).press("Enter");
    await page.waitForURL(/range_view=above/);
    const above = await stillPicture(page);
    expect(above === side).toBe(false);
    await page.locator(CANVAS).press("ArrowLeft");
    const turned = await otherPicture(page, above);
    await page.locator(CANVAS).press("+");
    await otherPicture(page, turned);
    await page.getByRole("button", { name: "From above" }).press("Enter");
    await page.waitForTimeout(500);
    expect((await stillPicture(page)) === above).toBe(true);
    await page.getByRole("button", { name: "Undo" }).click();
    await page.getByRole("button", { name: "Undo" }).click();
    await page.waitForTimeout(500);
    expect((await stillPicture(page)) === behind).toBe(true);
    expect(errors).toEqual([]);
  });

  test("a number of the flight says where it comes from, by keys", async () => {
    const { page, errors } = await openRange(`${FIRST}&wind=10mph`);
    await page.locator("[data-explains=landing_angle] button").press("Enter");
    await page.getByRole("dialog").getByText("How certain it is").waitFor();
    expect(await violations(page)).toEqual([]);
    await page.keyboard.press("Escape");
    await page.getByRole("dialog").waitFor({ state: "detached" });
    expect(errors).toEqual([]);
  });

  test("plays the flight and comes back; with reduced motion in stills", async () => {
    for (const reducedMotion of ["no-preference", "reduce"] as const) {
      const { page, errors } = await openRange(FIRST);
      await page.emulateMedia({ reducedMotion });
      const before = await stillPicture(page);
      await page.getByRole("button", { name: "Play" }).press("Enter");
      const shown = await page.evaluate(picturesUntilBack, [CANVAS, before] as [string, string]);
      console.log(`${shown} pictures of a flight, motion: ${reducedMotion}`);
      // Start, apex, landing and rest; and a picture that may be taken between two of them.
      if (reducedMotion === "reduce") expect(shown).toBeLessThanOrEqual(5);
      else expect(shown).toBeGreaterThan(5);
      expect(errors).toEqual([]);
      await page.close();
    }
  });
});

describe("the clubs of a bag", () => {
  test("stand in a table with their gaps, and follow speed and choice", async () => {
    const { page, errors } = await openRange(FIRST);
    const before = await stillPicture(page);
    await page.getByRole("button", { name: "Clubs of a bag" }).click();
    await page.locator(".gaps tr[data-club=driver]").waitFor();
    const clubs = await otherPicture(page, before);
    const read = (): Promise<{ club: string; carry: number; gap: number }[]> =>
      page.locator(".gaps tbody tr").evaluateAll((rows) =>
        rows.map((row) => {
          const value = (name: string): number =>
            Number((row.querySelector(`[data-quantity=${name}]`) as HTMLElement).dataset.value);
          return { club: (row as HTMLElement).dataset.club ?? "", carry: value("carry"), gap: value("gap") };
        }),
      );
    const rows = await read();
    expect(rows).toHaveLength(12);
    rows.slice(1).forEach(({ carry }, i) => {
      expect(rows[i].gap).toBeCloseTo(rows[i].carry - carry, 9);
      expect(carry).toBeLessThanOrEqual(rows[i].carry);
    });
    await page.getByText("Choose the clubs").click();
    await page.getByRole("checkbox", { name: "4-iron" }).press("Space");
    await page.locator(".gaps tr[data-club='4-iron']").waitFor({ state: "detached" });
    await otherPicture(page, clubs);
    await page.waitForURL(/bag=driver,3-wood,hybrid,5-iron/);
    await page.getByRole("textbox", { name: "Club speed" }).fill("90 mph");
    await page.keyboard.press("Enter");
    await page.waitForFunction(
      (carry) => document.querySelector<HTMLElement>(".gaps [data-quantity=carry]")?.dataset.value !== carry,
      String(rows[0].carry),
    );
    expect((await read())[0].carry).toBeLessThan(rows[0].carry - 10);
    expect(errors).toEqual([]);
  });

  test("the driver flies as in a shot of the tour's attack angle and dynamic loft", async () => {
    const { page } = await openRange("#scene=flight&flying=clubs&club=driver&speed=115mph&units=golf");
    await page.locator(".gaps tr[data-club=driver]").waitFor();
    const carry = await page.locator(".gaps tr[data-club=driver] [data-quantity=carry]").getAttribute("data-value");
    const delivery = (["attack", "loft"] as const).map(
      (name) => `${name}=${equipment.clubs["driver"].typical[name].join("")}`,
    );
    const shot = await openRange(`#scene=flight&club=driver&speed=115mph&${delivery.join("&")}&units=golf`);
    expect(await siValueOf(shot.page, "carry")).toBe(Number(carry));
  });
});

describe("a golfer's shots", () => {
  test("follow the sliders and the golfer, with table, ellipses and strokes", async () => {
    const { page, errors } = await openRange(FIRST);
    const before = await stillPicture(page);
    await page.getByRole("button", { name: "A golfer's shots" }).click();
    await page.locator(".spreads td").first().waitFor();
    await page.getByText("The mean delivery is this golfer's own.").waitFor();
    // They open from above; the shot is then seen from behind again.
    expect(await page.locator("[aria-label=Seen] [aria-pressed=true]").textContent()).toContain("From above");
    await page.getByRole("button", { name: "This shot" }).click();
    expect(await page.locator("[aria-label=Seen] [aria-pressed=true]").textContent()).toContain("From behind");
    await page.getByRole("button", { name: "A golfer's shots" }).click();
    await page.locator(".spreads td").first().waitFor();
    const first = await otherPicture(page, before);
    const value = (): Promise<number> =>
      page
        .locator("[data-spread=carry][data-part=mean]")
        .evaluate((cell) => Number((cell as HTMLElement).dataset.value));
    const changes = (from: number): Promise<unknown> =>
      page.waitForFunction(
        (last) =>
          document.querySelector<HTMLElement>("[data-spread=carry][data-part=mean]")?.dataset.value !== String(last),
        from,
      );
    const carry = await value();
    await slide(page, "Club speed", "PageDown");
    await changes(carry);
    expect(await value()).toBeLessThan(carry);
    await page.getByText("scatter about the delivery").waitFor();
    await otherPicture(page, first);
    const slower = await value();
    await page.getByRole("button", { name: "The golfer's own delivery" }).click();
    await changes(slower);
    expect(await value()).toBe(carry);
    const strokes = page.locator("[data-strokes]");
    const shorter = await strokes.getAttribute("data-strokes");
    await page.getByRole("textbox", { name: "Length of the hole" }).fill("300 yd");
    await page.keyboard.press("Enter");
    await page.waitForFunction(
      (last) => document.querySelector<HTMLElement>("[data-strokes]")?.dataset.strokes !== last,
      shorter,
    );
    expect(Number(await strokes.getAttribute("data-strokes"))).toBeLessThan(Number(shorter));
    expect(errors).toEqual([]);
  });
});

describe("the numbers", () => {
  test("of twenty flights are those of the package", async () => {
    const { page, errors } = await openRange(FIRST);
    const comparison = new Comparison();
    for (const flight of flights.cases) {
      const before = await siValueOf(page, "total");
      await goTo(page, linkOf(flight, { scene: "flight", units: "golf" }));
      await otherValue(page, "total", before);
      for (const [name, value] of await quantitiesOf(page)) comparison.add(flight, name, value, flight.numbers[name]);
    }
    console.log(`${comparison.count} numbers of ${flights.cases.length} flights compared with those of the package`);
    expect(comparison.wrong).toEqual([]);
    expect(flights.cases).toHaveLength(20);
    expect(comparison.count).toBeGreaterThanOrEqual(5 * flights.cases.length);
    expect(errors).toEqual([]);
  });

  test("of three golfers are those of the package, and come live", async () => {
    const comparison = new Comparison();
    for (const each of dispersions) {
      const { golfer } = each.link;
      const { page, errors } = await openRange(
        linkOf(each, { golfer: "", scene: "flight", club: "driver", units: "golf" }),
      );
      await page.getByRole("button", { name: "A golfer's shots" }).click();
      await page.getByRole("combobox", { name: "Golfer" }).selectOption(golfer);
      await page.waitForURL(new RegExp(`golfer=${golfer}`));
      await page
        .waitForFunction(
          (strokes) =>
            Math.abs(Number(document.querySelector<HTMLElement>("[data-strokes]")?.dataset.strokes) - strokes) < 1e-9,
          each.numbers.strokes,
          { timeout: 20_000 },
        )
        .catch(() => comparison.wrong.push(`${golfer}: other strokes than ${each.numbers.strokes}`));
      const cells = await page.locator("[data-spread]").evaluateAll((all) =>
        all.map((cell) => {
          const { spread, part, value } = (cell as HTMLElement).dataset;
          return [`${spread} ${part}`, Number(value)] as const;
        }),
      );
      for (const [name, value] of cells) comparison.add(each, name, value, each.numbers[name]);
      expect(errors).toEqual([]);
    }
    console.log(`${comparison.count} numbers of ${dispersions.length} golfers compared with those of the package`);
    expect(comparison.wrong).toEqual([]);
    expect(comparison.count).toBe(3 * 9 * 7);
  });

  test("of 4096 shots come live; the time is printed, since machines differ", async () => {
    const { page } = await openRange(`${FIRST}&flying=golfer`);
    await page.locator(".spreads td").first().waitFor();
    const times: number[] = [];
    for (let i = 0; i < 8; i += 1) {
      const before = await page.locator("[data-spread=carry][data-part=mean]").getAttribute("data-value");
      await slide(page, "Club speed", i % 2 ? "ArrowLeft" : "ArrowRight");
      await page.waitForFunction(
        (last) => document.querySelector<HTMLElement>("[data-spread=carry][data-part=mean]")?.dataset.value !== last,
        before,
      );
      times.push(Number(await page.locator(".spreads").getAttribute("data-milliseconds")));
    }
    const all = times.map((time) => time.toFixed(0)).join(", ");
    console.log(`4096 shots of a golfer: at best ${Math.min(...times).toFixed(0)} ms (${all})`);
    expect(Math.min(...times)).toBeGreaterThan(0);
  });
});

describe("everyone", () => {
  test("axe finds nothing wrong, with a shot, a bag and a golfer, light and dark", async () => {
    for (const flying of ["shot", "clubs", "golfer"])
      for (const theme of ["light", "dark"]) {
        const { page } = await openRange(`${FIRST}&flying=${flying}&wind=10mph&theme=${theme}`);
        await page.locator(".results table").first().waitFor();
        expect(await violations(page)).toEqual([]);
        await page.close();
      }
  });

  test("a narrow screen has all without sideways scrolling", async () => {
    await studio.renew({ viewport: { width: 360, height: 740 } });
    for (const flying of ["shot", "clubs", "golfer"]) {
      const { page, errors } = await openRange(`${FIRST}&flying=${flying}&wind=10mph`);
      await page.locator(".results table").first().waitFor();
      const wide = await page.evaluate(() => document.documentElement.scrollWidth);
      expect(wide).toBeLessThanOrEqual(360);
      expect(errors).toEqual([]);
      await page.close();
    }
  });
});
