/** The clubs of a bag, each with the tour's delivery at the speed that goes with the player's driver. */

import { type Context, choiceSetting, strike } from "../../context";
import type { Strike } from "../../core/types";
import type { Amount } from "../../quantities/units";
import { withoutClub, wordsOf } from "../../state/settings";
import { changed } from "../../state/state";

const DRIVER = "driver";

/** The clubs that were chosen, in the order of the equipment. */
export function bagOf(context: Context): string[] {
  const chosen = wordsOf(choiceSetting(context, "bag"));
  return Object.keys(context.equipment.clubs).filter((club) => chosen.includes(club));
}

/** The speed that the player would have with the driver. */
export function driverSpeed({ state, equipment }: Context): Amount {
  const { speed } = changed(state, { kind: "club", club: DRIVER }, equipment).delivery;
  return speed;
}

/** Each club's shot: attack angle and dynamic loft of the tour, its speed scaled to the player's driver; square, centred. */
export function bagStrikes(context: Context): { club: string; strike: Strike }[] {
  const { state, equipment } = context;
  const driving = { ...state, club: DRIVER, delivery: { speed: driverSpeed(context) } };
  return bagOf(context).map((club) => {
    const [value, unit] = equipment.clubs[club].typical.loft;
    const { delivery, ...rest } = changed(driving, { kind: "club", club }, equipment);
    // Numbers that were designed are those of the club of the shot.
    const settings = club === state.club ? state.settings : withoutClub(state.settings, context.settings);
    const struck = { ...rest, settings, delivery: { ...delivery, loft: { value, unit } } };
    return { club, strike: strike({ ...context, state: struck }) };
  });
}
