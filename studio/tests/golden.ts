/** The golden shots of the package, which Rust, Python, the command line and the pages must compute alike. */

import { readFileSync } from "node:fs";

export interface GoldenShot {
  /** Club, model, ball, hand and delivery by the keys of a link. */
  link: Record<string, string>;
  /** In SI by the names of the core's inputs. */
  delivery: Record<string, number>;
  /** Places of the inputs that belong to no delivery, and of the parameters. */
  equipment: number;
  parameters: number;
  /** Every number of launch and flight in SI. */
  numbers: Record<string, number>;
}

interface GoldenShots {
  /** Null is infinite. */
  equipment: Record<string, number | null>[];
  parameters: number[][];
  shots: GoldenShot[];
}

export const golden = JSON.parse(
  readFileSync(new URL("../../tests/golden/shots.json", import.meta.url), "utf8"),
) as GoldenShots;

export const linkOf = ({ link }: GoldenShot): string =>
  `#${Object.entries(link)
    .map(([key, value]) => `${key}=${value}`)
    .join("&")}`;
