/** What can be chosen on the range, beyond wind, air and ground, which hold for every scene. */

import { type Context, choiceSetting } from "../../context";
import type { Settings } from "../../state/settings";

/** What flies, with the words for it. */
export const FLYING = [
  ["shot", "This shot"],
  ["clubs", "Clubs of a bag"],
  ["golfer", "A golfer's shots"],
] as const;

export const VIEWS = [
  ["behind", "From behind"],
  ["side", "From the side"],
  ["above", "From above"],
] as const;
export type View = (typeof VIEWS)[number][0];

const USUAL_BAG = [
  "driver",
  "3-wood",
  "hybrid",
  "4-iron",
  "5-iron",
  "6-iron",
  "7-iron",
  "8-iron",
  "9-iron",
  "pitching-wedge",
  "gap-wedge",
  "sand-wedge",
];

export const flightSettings: Settings = {
  flying: { kind: "choice", options: FLYING.map(([name]) => name), usual: "shot" },
  /** Where it is not given, see `viewOf`. */
  range_view: { kind: "choice", options: VIEWS.map(([name]) => name), usual: "behind" },
  bag: { kind: "several", options: ({ clubs }) => Object.keys(clubs), usual: USUAL_BAG.join(",") },
  golfer: { kind: "choice", options: ({ golfers }) => Object.keys(golfers), usual: "handicap-10-driver" },
  hole: { kind: "amount", quantity: "total", usual: { value: 400, unit: "yd" } },
};

/** Where what flies is seen best. */
const USUAL_VIEWS: Record<string, View> = { shot: "behind", clubs: "side", golfer: "above" };

/** From where the range is seen: as chosen, or as what flies there is seen best. */
export function viewOf(context: Context): View {
  const given = context.state.settings.range_view;
  if (given !== undefined) return choiceSetting(context, "range_view") as View;
  return USUAL_VIEWS[choiceSetting(context, "flying")];
}
