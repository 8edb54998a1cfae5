/** What can be chosen of an impact by finite elements, of its picture, and of the second case. */

import { MESHES, RUNS } from "../../equipment/elements";
import type { Equipment } from "../../equipment/equipment";
import type { Settings } from "../../state/settings";

/** A rigid head of the club, a rigid plane, or one of the heads that deform, by its name. */
export const facesOf = ({ elements }: Equipment): string[] => ["club", "plane", ...Object.keys(elements.heads)];
const ballsOf = ({ elements }: Equipment): string[] => Object.keys(elements.balls);

export const CUTS = ["half", "whole"] as const;
export const COLOURS = ["displacement", "speed", "pieces"] as const;
/** What the second case may have of its own; the rest is that of the first. */
export const SECOND_SAME = "same";

export const elementsSettings: Settings = {
  against: { kind: "choice", options: facesOf, usual: "club" },
  friction: { kind: "amount", quantity: "friction", usual: { value: 0.35, unit: "1" } },
  follow: { kind: "choice", options: RUNS, usual: "contact" },
  mesh: { kind: "choice", options: MESHES, usual: "fine" },
  impact_moment: { kind: "amount", quantity: "contact_time", usual: { value: 0, unit: "us" } },
  cut: { kind: "choice", options: CUTS, usual: "half" },
  colour: { kind: "choice", options: COLOURS, usual: "displacement" },
  second: { kind: "choice", options: ["off", "on"], usual: "off" },
  second_ball: {
    kind: "choice",
    options: (equipment) => [SECOND_SAME, ...ballsOf(equipment)],
    usual: SECOND_SAME,
  },
  second_against: {
    kind: "choice",
    options: (equipment) => [SECOND_SAME, ...facesOf(equipment)],
    usual: SECOND_SAME,
  },
  second_speed: { kind: "amount", quantity: "speed", usual: { value: 0, unit: "m/s" } },
  second_loft: { kind: "amount", quantity: "loft", usual: { value: 0, unit: "deg" } },
  second_friction: { kind: "amount", quantity: "friction", usual: { value: 0.35, unit: "1" } },
};
