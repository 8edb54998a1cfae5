/** The golden numbers of the package, which Rust, Python, the command line and the pages must compute alike. */

import { readFileSync } from "node:fs";
import type { ElementsCase } from "../src/core/elements";
import type { Values } from "../src/core/types";

export interface GoldenCase {
  /** The state of the page by the keys of a link, but for the scene. */
  link: Record<string, string>;
}

export interface GoldenShot extends GoldenCase {
  model: string;
  /** In SI by the names of the core's inputs. */
  delivery: Values;
  /** Places of the inputs that belong to no delivery, and of the parameters. */
  equipment: number;
  parameters: number;
  /** Every number of launch and flight in SI. */
  numbers: Values;
}

interface GoldenShots {
  /** Null is infinite. */
  equipment: Record<string, number | null>[];
  parameters: number[][];
  cases: GoldenShot[];
}

export interface GoldenMap extends GoldenCase {
  /** Of the points along a side the first, and every so many after it, are kept. */
  step: number;
  /** Their places [m], and values [SI] by height and place towards the toe; null off the face. */
  toe: number[];
  high: number[];
  values: (number | null)[][];
  /** Of each club what the core takes, and the numbers of its face. */
  faces: { setup: object; numbers: Values }[];
}

export interface GoldenDispersion extends GoldenCase {
  count: number;
  setup: { percentiles: number[] };
  numbers: Values;
}

export interface GoldenElements extends GoldenCase {
  setup: ElementsCase["described"];
  numbers: Values;
}

const stored = (name: string): unknown =>
  JSON.parse(readFileSync(new URL(`../../tests/golden/${name}.json`, import.meta.url), "utf8"));

export const shots = stored("shots") as GoldenShots;
export const flights = stored("flights") as GoldenShots;
export const { cases: maps } = stored("maps") as { cases: GoldenMap[] };
export const { cases: dispersions } = stored("dispersions") as { cases: GoldenDispersion[] };
export const { cases: elements } = stored("elements") as { cases: GoldenElements[] };
const tolerance = stored("tolerance") as { relative: number; scales: Values };

/** Whether a number is the one stored; its name begins with the quantity that it is of. */
export function isSame(name: string, value: number, expected: number): boolean {
  const scale = tolerance.scales[name.split(" ")[0]] ?? 0;
  return Math.abs(value - expected) <= tolerance.relative * Math.max(Math.abs(expected), scale);
}

/** The link of a case, with some entries more or, where they are empty, less. */
export const linkOf = ({ link }: GoldenCase, more: Record<string, string> = {}): string =>
  `#${Object.entries({ ...link, ...more })
    .filter(([, value]) => value)
    .map(([key, value]) => `${key}=${encodeURIComponent(value)}`)
    .join("&")}`;

/** Compares numbers with those stored, and says which are not the same. */
export class Comparison {
  count = 0;
  readonly wrong: string[] = [];

  /** Compares a number that is stored, if it is. */
  add(source: GoldenCase, name: string, value: number, expected: number | null | undefined): void {
    if (expected == null) return;
    this.count += 1;
    if (!isSame(name, value, expected)) this.wrong.push(`${linkOf(source)}: ${name} is ${value}, not ${expected}`);
  }

  /** Compares all numbers that are stored. */
  addAll(source: GoldenCase, values: Values, expected: Values): void {
    for (const [name, value] of Object.entries(expected)) this.add(source, name, values[name], value);
  }
}
