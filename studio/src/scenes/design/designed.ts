/** The club as it was changed: its numbers, its space, the rules for it, and the strikes with it and with its original. */

import { type Context, choiceSetting, ownStrike, setupOf } from "../../context";
import { MASS_PROPERTIES } from "../../core/design";
import type { Space, Values } from "../../core/types";
import { type Setup, withClub } from "../../equipment/design";
import type { ClubEntry } from "../../equipment/equipment";
import type { Amount } from "../../quantities/units";
import { CG, PRODUCTS, SPACE, STRIKE, VARIABLES, type Variable } from "./settings";

export const clubOf = ({ equipment, state }: Context): ClubEntry => equipment.clubs[state.club];

/** What was given in the place of the club's own number. */
export function given({ state }: Context, name: string): Amount | undefined {
  const value = state.settings[name];
  return typeof value === "object" ? value : undefined;
}

/** The club's own number [SI]; NaN where it is not known. */
export function ownValue(context: Context, name: string): number {
  const { columns, space } = clubOf(context);
  if (name in columns) return columns[name] ?? Infinity;
  const { size, volume, free_mass } = space;
  const [face_to_back, sole_to_crown, heel_to_toe] = size;
  const sizes: Values = { face_to_back, sole_to_crown, heel_to_toe, volume: volume ?? Number.NaN, free_mass };
  return sizes[name] ?? Number.NaN;
}

/** The number as it is designed [SI]. */
export function designedValue(context: Context, name: string): number {
  const amount = given(context, name);
  return amount ? context.formatter.units.toSi(amount) : ownValue(context, name);
}

/** Names of what differs from the club's own. */
export const changedNames = (context: Context): string[] =>
  [...VARIABLES, ...SPACE].map(({ name }) => name).filter((name) => given(context, name) !== undefined);

/** The numbers of the club that differ from its own [SI]. */
export const changedValues = (context: Context): Values =>
  Object.fromEntries(
    VARIABLES.filter(({ name }) => given(context, name)).map(({ name }) => [name, designedValue(context, name)]),
  );

/** What is left of a number that must be above 0 at the lower end of its slider, as a part of the club's own. */
const LEAST_SHARE = 0.2;

/** Ends of the slider of a number [SI]. */
export function reachOf(context: Context, { name, reach, ends, unit }: Variable): [number, number] {
  const { units } = context.formatter;
  const own = ownValue(context, name);
  if (!Number.isFinite(own)) {
    const [least, most] = (ends ?? ["0", "0"]).map((text) => units.toSi(units.parse(text, unit)));
    return [least, most];
  }
  const half = typeof reach === "number" ? reach * Math.abs(own) : units.toSi(units.parse(reach, unit));
  const isSigned = [...CG, ...PRODUCTS].some((each) => each.name === name);
  return [isSigned ? own - half : Math.max(own - half, LEAST_SHARE * own), own + half];
}

/** The strike with the club's own numbers, and with those that are designed. */
export function setups(context: Context): { own: Setup; designed: Setup } {
  const { equipment, state } = context;
  const golfer = choiceSetting(context, "struck_by");
  const hand = state.hand === "left" ? "left" : "right";
  const own: Setup = {
    ...setupOf(context, ownStrike(context)),
    golfer: golfer === STRIKE ? null : equipment.golfers[golfer][hand],
  };
  return { own, designed: withClub(own, changedValues(context)) };
}

/** The space of the head as the core takes it: from its front backwards, and about its middle. */
export function spaceOf(context: Context): Space {
  const { space } = clubOf(context);
  const size = ["face_to_back", "sole_to_crown", "heel_to_toe"].map((name) => designedValue(context, name));
  const front = space.centre[0] + space.size[0] / 2;
  return {
    shape: space.shape,
    centre: [front - size[0] / 2, space.centre[1], space.centre[2]],
    size,
    head: MASS_PROPERTIES.map((name) => ownValue(context, name)),
    free: designedValue(context, "free_mass"),
  };
}

/** A rule, the value that it limits, and what it says of it. */
export interface Verdict {
  name: string;
  title: string;
  of: string;
  source: string;
  /** The limit, and the limit with its tolerance [SI]. */
  most: number;
  limit: number;
  value: number;
  /** null where the value is not known. */
  conforms: boolean | null;
}

/** What a measurement may miss beyond all tolerances, as a part of it. */
const ROUNDING = 1e-9;

/** All rules that hold for the club as it is designed. */
export function verdicts(context: Context): Verdict[] {
  const { rules } = context.equipment;
  const loft = designedValue(context, "static_loft");
  return clubOf(context)
    .rules.map((name) => ({ name, ...rules[name] }))
    .filter(({ steepest }) => steepest === null || loft <= steepest)
    .map(({ name, title, of, source, most_of, tolerance, ...rule }) => {
      const most = most_of ? designedValue(context, most_of) : rule.most;
      const limit = most + tolerance;
      const value = designedValue(context, of);
      const isKnown = Number.isFinite(value) && !(of === "characteristic_time" && value === 0);
      return {
        name,
        title,
        of,
        source,
        most,
        limit,
        value,
        conforms: isKnown ? value <= limit * (1 + ROUNDING) : null,
      };
    });
}
