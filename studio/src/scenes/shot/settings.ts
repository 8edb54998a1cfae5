/** What can be chosen in the scene of a shot beyond the shot. */

import type { Settings } from "../../state/settings";

/** Sides from which the head is seen, with their names. */
export const VIEWS: readonly (readonly [view: string, title: string])[] = [
  ["corner", "At an angle"],
  ["above", "From above"],
  ["line", "Down the line"],
  ["face", "Face on"],
];

export const shotSettings: Settings = {
  head_view: { kind: "choice", options: VIEWS.map(([view]) => view), usual: "corner" },
  /** The number that is explained. */
  number: { kind: "choice", options: ({ numbers }) => ["", ...numbers.explained], usual: "" },
  moment: { kind: "amount", quantity: "contact_time", usual: { value: 0, unit: "us" } },
};
