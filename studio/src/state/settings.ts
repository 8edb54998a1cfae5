/** What can be chosen in a scene beyond club, ball, model and delivery: it stands in the link and is undone like them. */

import type { Equipment } from "../equipment/equipment";
import type { Amount } from "../quantities/units";

/** An amount, or one of several words. */
export type SettingValue = Amount | string;

export type Setting =
  | { kind: "amount"; quantity: string; usual: Amount }
  /** A number of the club in the place of its own, to which another club goes back; usual is no number, in a unit that fits. */
  | { kind: "of-club"; quantity: string; usual: Amount }
  | {
      kind: "choice";
      options: readonly string[] | ((equipment: Equipment) => readonly string[]);
      usual: string;
      /** Whether another club goes back to what is usual. */
      isOfClub?: boolean;
    }
  /** Several of the options, in their order, with commas between them. */
  | { kind: "several"; options: readonly string[] | ((equipment: Equipment) => readonly string[]); usual: string };

/** Settings by their names, which are their keys in the link: of all scenes together no two are alike. */
export type Settings = Record<string, Setting>;

export function optionsOf(setting: Setting, equipment: Equipment): readonly string[] {
  if (setting.kind === "amount" || setting.kind === "of-club") return [];
  return typeof setting.options === "function" ? setting.options(equipment) : setting.options;
}

/** The words of a setting of several. */
export const wordsOf = (value: string): string[] => value.split(",").filter(Boolean);

/** Settings without those of a club. */
export const withoutClub = (values: Record<string, SettingValue>, settings: Settings): Record<string, SettingValue> =>
  Object.fromEntries(Object.entries(values).filter(([name]) => !isOfClub(settings[name])));

const isOfClub = (setting: Setting | undefined): boolean =>
  setting?.kind === "of-club" || (setting?.kind === "choice" && setting.isOfClub === true);
