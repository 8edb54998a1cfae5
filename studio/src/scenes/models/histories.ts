/** What is drawn over time of the contact models. */

import type { CoreArray } from "../../core/types";

export interface HistoryChart {
  name: string;
  title: string;
  /** The quantity that gives unit and digits. */
  quantity: string;
  /** Its values in SI at each moment. */
  values(arrays: Record<string, CoreArray>): number[];
}

const plain =
  (name: string) =>
  (arrays: Record<string, CoreArray>): number[] =>
    Array.from(arrays[name].values);

/** One component of vectors. */
const component =
  (name: string, axis: number) =>
  (arrays: Record<string, CoreArray>): number[] => {
    const { values, shape } = arrays[name];
    return Array.from({ length: shape[0] }, (_, i) => values[i * shape[1] + axis]);
  };

export const HISTORIES: HistoryChart[] = [
  { name: "normal", title: "Normal force", quantity: "normal_force", values: plain("normal_force") },
  { name: "friction", title: "Friction up the face", quantity: "force_y", values: plain("force_y") },
  { name: "sliding", title: "Slip up the face", quantity: "sliding_y", values: plain("sliding_y") },
  { name: "spin", title: "Backspin", quantity: "ball_spin", values: component("ball_spin", 2) },
];
