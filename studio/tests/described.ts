/** The description of the core and the equipment, as `data.py` wrote them. */

import { readFileSync } from "node:fs";
import type { Description } from "../src/core/types";
import type { Equipment } from "../src/equipment/equipment";

const read = (name: string): unknown =>
  JSON.parse(readFileSync(new URL(`../generated/${name}.json`, import.meta.url), "utf8"));

export const description = read("description") as Description;
export const equipment = read("equipment") as Equipment;
