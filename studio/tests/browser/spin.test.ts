/** The shape of the shot and the turning ball. */

import { expect, test } from "vitest";
import { siValueOf, TestStudio } from "./site";

const studio = new TestStudio();

test("a shot has the name that the command line gives it, for both hands", async () => {
  // clubface shot driver --speed 105mph --attack 2deg --loft 13deg --face ... --path ... [--hand left]
  for (const [delivery, name] of [
    ["face=1deg&path=4deg&toe=8mm&high=4mm", "push hook"],
    ["face=-1deg&path=-6deg", "slice"],
    ["face=1deg&path=6deg&hand=left", "slice"],
    ["face=0deg&path=0.5deg", "draw"],
  ]) {
    const { page, errors } = await studio.open(`#club=driver&speed=105mph&attack=2deg&loft=13deg&${delivery}`);
    expect(await page.locator(".headline .shape").textContent()).toBe(name);
    expect(await page.locator(".flight svg").last().getAttribute("aria-label")).toContain(`from above, a ${name}:`);
    expect(errors).toEqual([]);
    await page.close();
  }
});

test("the axis of the drawn ball is tilted as far as the spin axis, and the lift with it", async () => {
  for (const face of ["-3deg", "4deg"]) {
    const { page } = await studio.open(`#club=driver&speed=105mph&loft=13deg&face=${face}`);
    const tilt = await siValueOf(page, "spin_axis");
    const [x1, y1, x2, y2] = await page
      .locator(".spin line.spin-axis")
      .evaluate((line) => ["x1", "y1", "x2", "y2"].map((name) => Number(line.getAttribute(name))));
    expect(Math.atan2(y2 - y1, x2 - x1)).toBeCloseTo(tilt, 9);
    const lift = await page.locator(".spin line.lift").evaluate((line) => Number(line.getAttribute("x2")));
    expect(Math.sign(lift)).toBe(Math.sign(tilt));
    const words = (await page.locator(".spin svg").getAttribute("aria-label")) ?? "";
    expect(words).toMatch(tilt < 0 ? /spin axis [\d.]+° left/ : /spin axis [\d.]+° right/);
    await page.close();
  }
});
