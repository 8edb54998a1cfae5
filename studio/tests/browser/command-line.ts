/** What the package computes for what a page says. */

import { execFileSync } from "node:child_process";
import { fileURLToPath } from "node:url";

export const PYTHON = process.env.PYTHON ?? "python3";

/** What a script of this folder prints as JSON. */
export function printedBy<T>(script: string, ...inputs: string[]): T {
  const path = fileURLToPath(new URL(script, import.meta.url));
  const text = execFileSync(PYTHON, [path, ...inputs], { encoding: "utf8", stdio: ["ignore", "pipe", "inherit"] });
  return JSON.parse(text) as T;
}
