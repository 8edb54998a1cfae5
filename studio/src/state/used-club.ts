/** Whether shots are struck with the club as it was designed: a setting that holds for all scenes, and its numbers. */

import type { Description, Values } from "../core/types";
import type { Units } from "../quantities/units";
import type { Settings } from "./settings";
import type { State } from "./state";

/** The key in the link, and its word for the designed club. */
export const HEAD = "head";
export const DESIGNED = "designed";

export const USED_CLUB: Settings = {
  [HEAD]: { kind: "choice", options: ["own", DESIGNED], usual: "own", isOfClub: true },
};

interface Known {
  state: Pick<State, "settings">;
  settings: Settings;
  description: Pick<Description, "inputs">;
  formatter: { units: Units };
}

/** Numbers of the club that are given in the place of its own, where shots are struck with them [SI]. */
export function usedNumbers({ state, settings, description, formatter }: Known): Values {
  if (state.settings[HEAD] !== DESIGNED) return {};
  const given = Object.entries(state.settings).flatMap(([name, value]) => {
    const isNumber = settings[name]?.kind === "of-club" && description.inputs.some((input) => input.name === name);
    return isNumber && typeof value === "object" ? [[name, formatter.units.toSi(value)] as const] : [];
  });
  return Object.fromEntries(given);
}
