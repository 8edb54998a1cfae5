/** What can be chosen in the map of a face: they stand in the link. */

import type { Settings } from "../../state/settings";

/** What stands for no second club. */
export const NO_CLUB = "none";

export const STYLES = [
  ["bands", "bands"],
  ["smooth", "smooth"],
] as const;

export const mapSettings: Settings = {
  map: { kind: "choice", options: ({ face_map }) => face_map.quantities, usual: "ball_speed" },
  map_minus: { kind: "choice", options: ({ clubs }) => [NO_CLUB, ...Object.keys(clubs)], usual: NO_CLUB },
  map_style: { kind: "choice", options: STYLES.map(([name]) => name), usual: "bands" },
  strikes_toe: { kind: "amount", quantity: "toe", usual: { value: 10, unit: "mm" } },
  strikes_high: { kind: "amount", quantity: "high", usual: { value: 6, unit: "mm" } },
};
