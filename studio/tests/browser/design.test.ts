import { mkdtempSync, readFileSync, rmSync, writeFileSync } from "node:fs";
import { tmpdir } from "node:os";
import { join } from "node:path";
import { fileURLToPath } from "node:url";
import type { Page } from "playwright-core";
import { describe, expect, test } from "vitest";
import { isSame } from "../golden";
import { printedBy } from "./command-line";
import { drop, goTo, type Opened, otherValue, siValueOf, slide, TestStudio, textOf, violations } from "./site";

const FIRST = "#scene=design&club=driver&speed=105mph&attack=2deg&loft=12deg&toe=8mm&high=-4mm&units=golf";
const READY = '.design td[data-quantity="carry"]';

const studio = new TestStudio({ viewport: { width: 1440, height: 900 } });

/** The scene with its chart. */
async function opened(link = ""): Promise<Opened> {
  const result = await studio.open(FIRST + link, READY);
  await result.page.locator("[data-here]").waitFor();
  return result;
}

const drawing = (page: Page, selector: string): Promise<string> => page.locator(selector).first().innerHTML();
const attribute = async (page: Page, selector: string, name: string): Promise<string | null> =>
  page.locator(selector).first().getAttribute(name);
const here = async (page: Page): Promise<number> => Number(await attribute(page, "[data-here]", "data-here"));

const go = (page: Page, link: string): Promise<void> => goTo(page, FIRST + link);

describe("a changed club", () => {
  test("changes numbers, head, chart and link by a slider, and goes back", async () => {
    const { page, errors } = await opened();
    const before = await siValueOf(page, "carry");
    const own = await page.locator('[data-own="carry"]').getAttribute("data-value");
    expect(Number(own)).toBe(before);
    const pictures = [".head-views svg", ".head-views figure:nth-child(3) svg", ".optimum svg"];
    const drawn = await Promise.all(pictures.map((each) => drawing(page, each)));
    await slide(page, "CG below the face centre", "PageUp");
    const after = await otherValue(page, "carry", before);
    expect(await page.locator('[data-own="carry"]').getAttribute("data-value")).toBe(own);
    await page.waitForURL(/cg_y=[\d.]+mm/);
    for (const [i, selector] of pictures.entries()) await expect.poll(() => drawing(page, selector)).not.toBe(drawn[i]);
    expect(await textOf(page, '[data-difference="carry"]')).toMatch(/^[+-]\d+\.\d yd$/);
    await page.getByRole("button", { name: "Back to the club" }).click();
    expect(await otherValue(page, "carry", after)).toBe(before);
    await page.waitForURL((address) => !address.hash.includes("cg_y"));
    await page.keyboard.press("Control+z");
    expect(await otherValue(page, "carry", before)).toBe(after);
    expect(errors).toEqual([]);
  });

  test("is that of the link in another tab, and another club has its own numbers", async () => {
    const { page } = await opened("&cg_x=45mm&iyy=5800g%20cm2&heavier=same&club_mass=210g");
    const carry = await siValueOf(page, "carry");
    const other = await opened("&cg_x=45mm&iyy=5800g%20cm2&heavier=same&club_mass=210g");
    expect(await siValueOf(other.page, "carry")).toBe(carry);
    expect(carry).not.toBe(Number(await attribute(page, '[data-own="carry"]', "data-value")));
    await page.locator("summary", { hasText: "Change club" }).click();
    await page.locator('select[name="club"]').selectOption("3-wood");
    await otherValue(page, "carry", carry);
    await page.waitForURL(/club=3-wood/);
    expect(page.url()).not.toMatch(/cg_x|iyy|club_mass/);
    expect(page.url()).toContain("heavier=same");
    await page.keyboard.press("Control+z");
    await page.waitForURL(/club=driver.*cg_x=45mm/);
  });

  test("that no body can be is refused by the core, with a message", async () => {
    const { page } = await opened();
    await go(page, "&ixx=100g%20cm2");
    await page.getByText("This club cannot be computed.").waitFor();
  });

  test("does by a step what its derivative says", async () => {
    const { page } = await opened();
    await page.locator('.chips button[data-name="cg_y"][data-carry]').waitFor();
    const first = await siValueOf(page, "carry");
    for (const [name, unit] of [
      ["cg_y", "mm"],
      ["iyy", "g%20cm2"],
      ["static_loft", "deg"],
      ["club_mass", "g"],
    ] as const) {
      const own = { cg_y: 4.34, iyy: 5679, static_loft: 9.8, club_mass: 204 }[name];
      const step = { cg_y: 1, iyy: 100, static_loft: 1, club_mass: 5 }[name];
      await go(page, "");
      // The derivatives come with the numbers of the same club.
      await expect.poll(() => siValueOf(page, "carry")).toBe(first);
      const expected = Number(await attribute(page, `.chips button[data-name="${name}"]`, "data-carry"));
      const carries: number[] = [];
      for (const side of [-1, 1]) {
        const before = await siValueOf(page, "carry");
        await go(page, `&${name}=${own + side * 0.05 * step}${unit}`);
        carries.push(await otherValue(page, "carry", before));
      }
      // Central differences over a tenth of a step: what they leave out is of the third order.
      expect((carries[1] - carries[0]) / 0.1).toBeCloseTo(expected, 3);
      await go(page, "");
    }
  });
});

describe("a club in use", () => {
  const SHOT = 'td[data-quantity="carry"]';

  test("strikes the shots of the other scenes, by its link too, until the club's own numbers are taken or it is undone", async () => {
    const { page, errors } = await opened("&cg_y=8mm&static_loft=11deg&club_mass=210g");
    const [own, designed] = [
      Number(await attribute(page, '[data-own="carry"]', "data-value")),
      await siValueOf(page, "carry"),
    ];
    expect(Math.abs(designed - own)).toBeGreaterThan(1);
    await page.getByRole("button", { name: "Use this club" }).press("Enter");
    // In its own scene it is compared with the original as before.
    expect(await siValueOf(page, "carry")).toBe(designed);
    expect(Number(await attribute(page, '[data-own="carry"]', "data-value"))).toBe(own);
    await page.getByRole("button", { name: "Shot", exact: true }).click();
    await page.locator(".flight svg").first().waitFor();
    expect(await siValueOf(page, "carry")).toBe(designed);
    const line = page.getByRole("complementary", { name: "Designed club" });
    expect(await line.textContent()).toMatch(/driver as designed.*8\.0 mm.*210/s);
    await page.waitForURL(/cg_y=8mm.*head=designed/);
    const other = await studio.open(page.url(), SHOT);
    expect(await siValueOf(other.page, "carry")).toBe(designed);
    await line.getByRole("button", { name: "The club's own numbers" }).click();
    expect(await otherValue(page, "carry", designed)).toBe(own);
    await page.keyboard.press("Control+z");
    expect(await otherValue(page, "carry", own)).toBe(designed);
    await page.locator('select[name="club"]').selectOption("3-wood");
    await page.waitForURL(/club=3-wood/);
    expect(page.url()).not.toMatch(/head=|cg_y=/);
    expect(errors).toEqual([]);
  });

  test("has its place in the bag, where the other clubs keep their numbers", async () => {
    const link = "#scene=flight&flying=clubs&bag=driver,7-iron&club=driver&speed=105mph&units=golf&cg_y=8mm";
    const carries = async (more: string): Promise<(string | null)[]> => {
      const { page } = await studio.open(link + more, ".gaps td");
      const cells = ["driver", "7-iron"].map((club) => `.gaps tr[data-club="${club}"] [data-quantity=carry]`);
      return Promise.all(cells.map((each) => attribute(page, each, "data-value")));
    };
    const [own, used] = [await carries(""), await carries("&head=designed")];
    expect(used[0]).not.toBe(own[0]);
    expect(used[1]).toBe(own[1]);
  });
});

describe("limits", () => {
  test("a value beyond a rule is marked, and says which rule, with its source", async () => {
    const { page } = await opened("&iyy=6100g%20cm2&characteristic_time=258us");
    const broken = page.locator('tr[data-conforms="false"]');
    expect(await broken.evaluateAll((rows) => rows.map((row) => (row as HTMLElement).dataset.rule))).toEqual([
      "moment_of_inertia",
      "characteristic_time",
    ]);
    expect(await broken.first().textContent()).toMatch(/6100 g cm².*5900 g cm² \+ 100 g cm².*does not conform/s);
    const words = await textOf(page, '.field[data-name="iyy"] small');
    expect(words).toMatch(/^Beyond the rules: moment of inertia, vertical axis at most 6000 g cm². USGA \(2006\)/);
    expect(await attribute(page, ".verdict", "data-conforms")).toBe("false");
    expect(await page.locator('.field[data-name="iyy"] .band.rules').getAttribute("aria-label")).toMatch(
      /up to 6000 g cm² with the tolerance, 5900 g cm² without/,
    );
    await go(page, "&iyy=6000g%20cm2&characteristic_time=257us");
    await expect.poll(() => attribute(page, ".verdict", "data-conforms")).toBe("true");
    expect(await textOf(page, 'tr[data-rule="moment_of_inertia"]')).toContain("within the tolerance");
  });

  test("irons have no limit of inertia, and steep ones none of the spring", async () => {
    const { page } = await opened();
    const rules = (): Promise<(string | undefined)[]> =>
      page.locator("tr[data-rule]").evaluateAll((rows) => rows.map((row) => (row as HTMLElement).dataset.rule));
    await go(page, "&club=7-iron");
    await expect.poll(rules).toEqual(["characteristic_time"]);
    await go(page, "&club=7-iron&static_loft=36deg");
    await expect.poll(rules).toEqual([]);
  });

  test("the space of the head has its rules: 460 cm3, 5 inches, no longer than wide", async () => {
    const { page } = await opened("&volume=475cm3&heel_to_toe=110mm&sole_to_crown=72mm");
    await expect
      .poll(() =>
        page
          .locator('tr[data-conforms="false"]')
          .evaluateAll((rows) => rows.map((row) => (row as HTMLElement).dataset.rule)),
      )
      .toEqual(["volume", "sole_to_crown", "face_to_back"]);
  });

  test("the ends of what can be built are such: just within it can, just beyond it cannot, with the reason", async () => {
    const { page } = await opened();
    const built = (): Promise<string | null> => attribute(page, ".verdict", "data-built");
    await expect.poll(built).toBe("true");
    for (const [name, unit, digit] of [
      ["cg_x", "mm", 0.1],
      ["iyy", "g cm²", 1],
      ["club_mass", "g", 0.1],
    ] as const) {
      await go(page, "");
      await expect.poll(built).toBe("true");
      await expect.poll(() => page.getByRole("button", { name: "Back to the club" }).isDisabled()).toBe(true);
      const words = await page.locator(`.field[data-name="${name}"] .band.built`).getAttribute("aria-label");
      const [, from, to] = /from ([\d.]+) .*? to ([\d.]+) /.exec(words ?? "") ?? [];
      // Ends are rounded to the last digit that is shown. A heavier head can always be built.
      const beyond = [Number(from) - digit, ...(name === "club_mass" ? [] : [Number(to) + digit])];
      for (const value of [Number(from) + digit, Number(to) - digit]) {
        await go(page, `&${name}=${value}${unit}`);
        await expect.poll(() => page.url()).toContain(`${name}=`);
        await page.waitForTimeout(300);
        expect(await built(), `${name}=${value}`).toBe("true");
      }
      for (const value of beyond) {
        await go(page, `&${name}=${value}${unit}`);
        await expect.poll(built, { message: `${name}=${value}` }).toBe("false");
      }
    }
    await go(page, "&cg_x=60mm");
    await page.locator(".verdict").getByText("It cannot be built").waitFor();
    expect(await textOf(page, ".verdict")).toMatch(/moments of the discretionary mass|does not fit into the box/);
  });
});

describe("the optimum chart", () => {
  test("a press goes to the best club, which is better than here and allowed", async () => {
    const { page, errors } = await opened("&across=cg_x&upwards=iyy&best=ball_speed");
    const before = await here(page);
    const best = Number(await attribute(page, "[data-best]", "data-best"));
    expect(best).toBeGreaterThan(before);
    await page.getByRole("button", { name: "Go there" }).click();
    // The place is rounded to a thousandth of what is shown.
    await expect.poll(() => here(page)).toBeCloseTo(best, 4);
    expect(await siValueOf(page, "ball_speed")).toBe(await here(page));
    expect(await attribute(page, ".verdict", "data-conforms")).toBe("true");
    expect(errors).toEqual([]);
  });

  test("another golfer, axis or aim is another picture; areas are drawn", async () => {
    const { page, errors } = await opened("&across=cg_x&upwards=iyy");
    expect(await attribute(page, '[data-area="not-built"]', "d")).toMatch(/^M/);
    expect(await page.locator("rect.not-allowed").count()).toBe(1);
    let before = await drawing(page, ".optimum svg");
    for (const [select, option] of [
      ["upwards", "static_loft"],
      ["best", "total"],
      ["struck_by", "handicap-10-driver"],
      ["best", "spread"],
    ]) {
      await page.locator(`select[name="${select}"]`).selectOption(option);
      await expect.poll(() => drawing(page, ".optimum svg"), { timeout: 30_000 }).not.toBe(before);
      await page.waitForTimeout(500);
      before = await drawing(page, ".optimum svg");
    }
    await page.locator('td[data-quantity="side-spread"]').waitFor();
    expect(await textOf(page, "[data-here]")).toContain("spread to the side");
    await page.waitForURL(/struck_by=handicap-10-driver.*best=spread|best=spread.*struck_by=handicap-10-driver/);
    expect(errors).toEqual([]);
  });

  test("a click and the arrow keys move the club", async () => {
    const { page } = await opened();
    const before = await siValueOf(page, "carry");
    await page.locator(".optimum svg").scrollIntoViewIfNeeded();
    const box = await page.locator(".optimum svg").boundingBox();
    if (!box) throw new Error("the chart is not drawn");
    await page.mouse.click(box.x + box.width * 0.4, box.y + box.height * 0.3);
    const clicked = await otherValue(page, "carry", before);
    await page.waitForURL(/cg_x=[\d.]+mm&cg_y=/);
    await page.locator(".optimum").press("ArrowUp");
    await otherValue(page, "carry", clicked);
    await page.keyboard.press("Control+z");
    await page.keyboard.press("Control+z");
    expect(await otherValue(page, "carry", clicked)).toBe(before);
  });

  test("the averages are those of more shots, to what sampling leaves", async () => {
    const { page } = await opened("&struck_by=handicap-10-driver&best=carry");
    await page.locator('td[data-quantity="side-spread"]').waitFor();
    const table = page.locator("table", { hasText: "handicap of 10" });
    const carry = Number(await table.locator('td[data-quantity="carry"]').getAttribute("data-value"));
    // 256 shots of a low-discrepancy sequence, compared with 4096: the mean carry to 0.5 m.
    await expect.poll(async () => Math.abs((await here(page)) - carry)).toBeLessThan(0.5);
  });
});

/** Designs whose numbers are compared with those of the command line: every kind of head, face and parameters. */
const DESIGNS = [
  "&cg_x=45mm&cg_y=2.5mm&iyy=5900g%20cm2&bulge=350mm&static_loft=10.6deg&club_mass=198g",
  "&club=3-wood&model=standard&parameters=penner&characteristic_time=240us&roll=300mm&ball=published&path=-2deg",
  "&club=driver&model=volumetric&hand=left&cg_z=4mm&ixy=-600g%20cm2&face_width=110mm&closure=1500deg/s",
  "&club=7-iron&model=slip&speed=84mph&cg_x=6mm&cg_y=3.3mm&izz=600g%20cm2&static_loft=29deg&heavier=same&club_mass=270g",
  "&club=ping-g430-max-10k-driver&model=standard&iyy=6000g%20cm2&ixx=3100g%20cm2&characteristic_time=0us",
];

describe("the file of a club", () => {
  test("has the numbers of the page in the command line", async () => {
    const folder = mkdtempSync(join(tmpdir(), "clubface-design-"));
    try {
      const { page, errors } = await opened();
      const shown: Record<string, number>[] = [];
      const commands: string[] = [];
      for (const [i, design] of DESIGNS.entries()) {
        const before = await siValueOf(page, "carry");
        await go(
          page,
          design.includes("speed=")
            ? design.replace(/&speed=(\w+)/, "") + (/&speed=\w+/.exec(design)?.[0] ?? "")
            : design,
        );
        await otherValue(page, "carry", before);
        const [download] = await Promise.all([
          page.waitForEvent("download"),
          page.getByRole("button", { name: /^Save .*\.toml$/ }).click(),
        ]);
        const file = `${i}-${download.suggestedFilename()}`;
        await download.saveAs(join(folder, file));
        const typed = await textOf(page, "[data-command]");
        commands.push(typed.replace(download.suggestedFilename(), file));
        const cells = page.locator("table", { hasText: "The same strike" }).locator("td[data-quantity]");
        shown.push(
          Object.fromEntries(
            await cells.evaluateAll((all) =>
              all.map((cell) => [(cell as HTMLElement).dataset.quantity, Number((cell as HTMLElement).dataset.value)]),
            ),
          ),
        );
      }
      writeFileSync(join(folder, "commands.json"), JSON.stringify(commands));
      const expected = printedBy<Record<string, number>[]>("typed_commands.py", join(folder, "commands.json"));
      const wrong = expected.flatMap((row, i) =>
        Object.entries(shown[i])
          .filter(([name, value]) => !isSame(name, value, row[name]))
          .map(([name, value]) => `${commands[i]}: ${name} ${value}, by the command line ${row[name]}`),
      );
      expect(expected).toHaveLength(DESIGNS.length);
      for (const row of shown) expect(Object.keys(row).length).toBeGreaterThan(8);
      console.log(
        `${shown.flatMap(Object.keys).length} numbers of ${shown.length} designs compared with the command line`,
      );
      expect(wrong).toEqual([]);
      expect(errors).toEqual([]);
    } finally {
      rmSync(folder, { recursive: true });
    }
  });

  const text = readFileSync(
    fileURLToPath(new URL("../../../python/clubface/data/clubs/average-driver-2020.toml", import.meta.url)),
    "utf8",
  );

  test("is opened by dropping it: a club of the package, and one that was changed", async () => {
    const { page, errors } = await opened("&cg_x=45mm");
    const before = await siValueOf(page, "carry");
    await drop(page, ".design", "average-driver-2020.toml", text);
    await page.waitForURL(/club=average-driver-2020/);
    expect(page.url()).not.toContain("cg_x");
    const carry = await otherValue(page, "carry", before);
    await drop(page, ".design", "mine.toml", text.replace('"31.5885 mm"', '"35 mm"'));
    await page.waitForURL(/cg_x=35mm/);
    await otherValue(page, "carry", carry);
    await page.locator('input[type="file"]').setInputFiles({
      name: "typed.toml",
      mimeType: "application/toml",
      buffer: Buffer.from(text.replace('"31.5885 mm"', '"36 mm"')),
    });
    await page.waitForURL(/cg_x=36mm/);
    expect(errors).toEqual([]);
  });

  test("says what is wrong with one that is damaged, and keeps the club", async () => {
    const { page, errors } = await opened();
    const before = await siValueOf(page, "carry");
    const alert = page.locator('.club-file [role="alert"]');
    await drop(page, ".design", "torn.toml", text.slice(0, 500));
    await alert.getByText("torn.toml:").waitFor();
    await drop(page, ".design", "heavy.toml", text.replace('"195.5 g"', '"195.5 mm"'));
    await alert.getByText('heavy.toml: mass is "195.5 mm": mm does not fit').waitFor();
    await drop(page, ".design", "photo.toml", "\u0000PNG");
    await alert.getByText("photo.toml: line 1").waitFor();
    expect(await siValueOf(page, "carry")).toBe(before);
    expect(errors).toEqual([]);
  });
});

describe("the page", () => {
  test("is reached and changed by the keyboard alone", async () => {
    const { page } = await opened();
    const before = await siValueOf(page, "carry");
    const reached: string[] = [];
    for (let i = 0; i < 120; i += 1) {
      await page.keyboard.press("Tab");
      const name = await page.evaluate(() => {
        const { activeElement: at } = document;
        return (
          at?.getAttribute("aria-label") ??
          at?.closest("label")?.querySelector("span")?.textContent ??
          at?.textContent ??
          ""
        );
      });
      reached.push(name.trim());
      if (name.startsWith("Place of the club on the chart")) break;
      if (name.startsWith("Spring of the face, slider")) await page.keyboard.press("PageUp");
    }
    for (const name of [
      "CG behind the face, slider",
      "Inertia, vertical, slider",
      "Save driver-changed.toml",
      "Objective",
    ])
      expect(reached).toContain(name);
    const sprung = await otherValue(page, "carry", before);
    await page.keyboard.press("Shift+ArrowUp");
    await otherValue(page, "carry", sprung);
  });

  test.each([360, 3840])("fits a screen of %d pixels", async (width) => {
    await studio.renew({ viewport: { width, height: 900 } });
    const { page, errors } = await opened("&cg_x=45mm&iyy=6100g%20cm2&struck_by=bogey-driver");
    await page.locator('td[data-quantity="side-spread"]').waitFor();
    expect(await page.evaluate(() => document.documentElement.scrollWidth)).toBeLessThanOrEqual(width);
    expect(errors).toEqual([]);
  });

  test.each(["light", "dark"] as const)("axe finds no violation (%s)", async (colorScheme) => {
    await studio.renew({ colorScheme });
    const { page } = await opened("&cg_x=45mm&iyy=6100g%20cm2&struck_by=bogey-driver");
    await page.locator('td[data-quantity="side-spread"]').waitFor();
    expect(await violations(page)).toEqual([]);
  });

  test("prints its numbers without what can only be pressed", async () => {
    const { page } = await opened("&theme=dark");
    await page.emulateMedia({ media: "print" });
    expect(await page.locator(READY).first().isVisible()).toBe(true);
    expect(await page.locator(".optimum svg").isVisible()).toBe(true);
    expect(await page.locator(".presets").isVisible()).toBe(false);
  });
});
