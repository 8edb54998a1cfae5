/** What is drawn over time of the contact models. */

import type { CoreArray, Description, History } from "../../core/types";
import { modelName } from "../../equipment/names";
import type { Chart } from "../../parts/chart";

interface Drawn {
  name: string;
  title: string;
  /** The quantity that gives unit and digits. */
  quantity: string;
  /** Its values in SI at each moment. */
  values(arrays: Record<string, CoreArray>): ArrayLike<number>;
}

const plain =
  (name: string) =>
  (arrays: Record<string, CoreArray>): ArrayLike<number> =>
    arrays[name].values;

/** The same with the other sign. */
const opposite =
  (name: string) =>
  (arrays: Record<string, CoreArray>): ArrayLike<number> =>
    arrays[name].values.map((value) => -value);

/** One component of vectors. */
const component =
  (name: string, axis: number) =>
  (arrays: Record<string, CoreArray>): ArrayLike<number> => {
    const { values, shape } = arrays[name];
    return Float64Array.from({ length: shape[0] }, (_, i) => values[i * shape[1] + axis]);
  };

const HISTORIES: Drawn[] = [
  { name: "normal", title: "Normal force", quantity: "normal_force", values: plain("normal_force") },
  // As the finite elements have it: down the face, where it makes backspin.
  { name: "friction", title: "Friction along the face", quantity: "tangential", values: opposite("force_y") },
  { name: "sliding", title: "Slip up the face", quantity: "sliding_y", values: plain("sliding_y") },
  { name: "spin", title: "Backspin", quantity: "ball_spin", values: component("ball_spin", 2) },
];

/** Charts that were made of the same histories, so that they are drawn once. */
let made: { histories: History[]; charts: Chart[] } | null = null;

export function historyCharts(description: Pick<Description, "models">, histories: History[]): Chart[] {
  if (made?.histories !== histories)
    made = {
      histories,
      charts: HISTORIES.map(({ name, title, quantity, values }) => ({
        name,
        title,
        x: { label: "time", quantity: "contact_time" },
        y: { label: title, quantity },
        lines: histories.map(({ model, arrays }) => ({
          label: modelName({ description }, model),
          x: arrays.time.values,
          y: values(arrays),
        })),
      })),
    };
  return made.charts;
}
