/** What the package computes for the same inputs, and which numbers of the page count as the same. */

import { execFileSync } from "node:child_process";
import { fileURLToPath } from "node:url";

export const PYTHON = process.env.PYTHON ?? "python3";

/** What a script of this folder prints as JSON. */
export function printedBy<T>(script: string, ...inputs: string[]): T {
  const path = fileURLToPath(new URL(script, import.meta.url));
  const text = execFileSync(PYTHON, [path, ...inputs], { encoding: "utf8", stdio: ["ignore", "pipe", "inherit"] });
  return JSON.parse(text) as T;
}

/**
 * Relative difference of a number on the page from that of the command line: the last bits of logarithms and powers, which
 * there come from the machine's own library.
 */
export const SAME = 1e-12;
/** What is a difference of large numbers is compared on their scale [SI]. */
export const SCALES: Record<string, number> = {
  side: 100,
  total_side: 100,
  curve: 100,
  azimuth: 1,
  sidespin: 100,
  spin_axis: 1,
};

export const isSame = (name: string, shown: number, expected: number, scales = SCALES): boolean =>
  Math.abs(shown - expected) <= SAME * Math.max(Math.abs(expected), scales[name] ?? 0);
