/** What of the scene stands in the link: which part of it is shown, and whether mishits are. */

import type { Settings } from "../../state/settings";

export const PARTS = ["shots", "report", "golfer", "fitting", "studies", "live"] as const;
export type Part = (typeof PARTS)[number];

export const sessionsSettings = {
  part: { kind: "choice", options: PARTS, usual: "shots" },
  mishits: { kind: "choice", options: ["shown", "hidden"], usual: "shown" },
} satisfies Settings;
