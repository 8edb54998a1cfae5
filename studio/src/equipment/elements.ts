/** What `data.py` writes for the finite elements: meshed balls, heads that deform, how to run, published cases. */

import type { Values } from "../core/types";

export const MESHES = ["coarse", "fine"] as const;
export type MeshName = (typeof MESHES)[number];

export interface MeshedBall {
  friction: number;
  /** Names of its pieces, from the core on. */
  pieces: string[];
  /** The ball as the core takes it, and its mass, radius and inertia as inputs of a strike. */
  meshes: Record<MeshName, { values: object; columns: Values; elements: number }>;
}

export interface MeshedHead {
  label: string;
  values: object;
  columns: Record<string, number | null>;
  elements: number;
}

export interface PublishedCase {
  label: string;
  ball: string;
  against: string;
  friction: number;
  /** Amounts as text. */
  delivery: Record<string, string>;
}

export const RUNS = ["contact", "millisecond"] as const;
export type RunName = (typeof RUNS)[number];

export interface ElementsData {
  balls: Record<string, MeshedBall>;
  heads: Record<string, MeshedHead>;
  runs: Record<RunName, Record<string, number | string | boolean | null>>;
  safeties: (number | null)[];
  /** What friction, and speed and angle of a thrown ball may be, in SI. */
  limits: Record<"friction" | "thrown_speed" | "thrown_angle", [least: number, most: number]>;
  cases: Record<string, PublishedCase>;
}
