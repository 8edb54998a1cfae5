/** Pictures of scenes in both themes: whole pages at four widths to look at, and the first screen of two for the docs. */

import { mkdirSync } from "node:fs";
import { join } from "node:path";
import type { BrowserContextOptions, Page } from "playwright-core";
import { test } from "vitest";

const FOLDER = process.env.SCREENSHOTS ?? "screenshots";
const SIZES = { 360: 740, 390: 844, 1440: 900, 3840: 2160 };
/** Widths whose first screen stands in the documentation, with the ending of its name. */
const DOCUMENTED: Record<number, string> = { 390: "-narrow", 1440: "" };

interface Drawn {
  /** Opens the scene on such a screen and returns its page once it is whole. */
  show: (screen: BrowserContextOptions) => Promise<Page>;
  isDocumented?: boolean;
  /** What one picture may take [ms]. */
  timeout: number;
}

/** Declares the tests that draw a scene. */
export function drawScene(name: string, { show, isDocumented = true, timeout }: Drawn): void {
  mkdirSync(join(FOLDER, "docs"), { recursive: true });
  for (const [width, height] of Object.entries(SIZES).map((size) => size.map(Number)))
    for (const theme of ["light", "dark"] as const)
      test(`${name}, ${width} px, ${theme}`, { timeout }, async () => {
        const page = await show({ viewport: { width, height }, colorScheme: theme });
        await page.screenshot({ path: join(FOLDER, `${name}-${width}-${theme}.png`), fullPage: true });
        if (!isDocumented || !(width in DOCUMENTED)) return;
        const file = `studio-${name}${theme === "dark" ? "-dark" : ""}${DOCUMENTED[width]}.png`;
        await page.screenshot({ path: join(FOLDER, "docs", file) });
      });
}
