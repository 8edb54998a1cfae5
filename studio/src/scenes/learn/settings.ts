/** What the lessons keep in the link: which one is open, and where its sliders stand. */

import type { Setting, Settings } from "../../state/settings";

export const LESSON_NAMES = ["spin", "curve", "gear", "height", "descent", "wet", "rules", "monitors"] as const;
export type LessonName = (typeof LESSON_NAMES)[number];

const amount = (quantity: string, value: number, unit: string): Setting => ({
  kind: "amount",
  quantity,
  usual: { value, unit },
});

/** Sliders begin with the name of their lesson, and stand where its question is still open. */
export const LESSON_SLIDERS: Settings = {
  spin_friction: amount("friction", 0.5, "1"),
  curve_path: amount("path", 0, "deg"),
  curve_face: amount("face", 2, "deg"),
  gear_toe: amount("toe", 15, "mm"),
  gear_bulge: amount("bulge", 1000, "mm"),
  height_high: amount("high", -8, "mm"),
  height_loft: amount("loft", 13, "deg"),
  descent_attack: amount("attack", -2, "deg"),
  descent_loft: amount("loft", 24, "deg"),
  wet_friction: amount("friction", 0.35, "1"),
  wet_loft: amount("loft", 50, "deg"),
  rules_time: amount("characteristic_time", 150, "us"),
  rules_inertia: amount("iyy", 3100, "g cm2"),
  monitors_closure: amount("closure", 2500, "deg/s"),
  monitors_high: amount("high", 8, "mm"),
  monitors_temperature: amount("temperature", 10, "degC"),
};

export const LEARN_SETTINGS: Settings = {
  lesson: { kind: "choice", options: LESSON_NAMES, usual: LESSON_NAMES[0] },
  ...LESSON_SLIDERS,
};
