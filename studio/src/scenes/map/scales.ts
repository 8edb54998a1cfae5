/** From values to colours: round levels, the ends of the range, and their words. */

import type { Context } from "../../context";
import { ticks } from "../../parts/axes";
import { join } from "../../quantities/formatter";
import type { Place } from "./field";
import type { Shown } from "./mapped";

/** About as many. */
const LEVELS = 14;

export interface ValueScale {
  unit: string;
  digits: number;
  /** Ends of the range in the unit in which people read the quantity; about 0 where it has two sides. */
  ends: [number, number];
  /** Round numbers within it. */
  levels: number[];
  fromSi(value: number): number;
  /** From a value in the unit to a share of the range. */
  share(value: number): number;
}

export function valueScale(
  { formatter, state }: Context,
  { name, range, isDiverging, isDifference }: Shown,
): ValueScale {
  const { unit, digits } = formatter.reading(name, state.system);
  const fromSi = (value: number): number => formatter.units.differenceFromSi(value, unit);
  const [least, most] = range.map(fromSi);
  const size = Math.max(Math.abs(least), Math.abs(most), Number.MIN_VALUE);
  const ends: [number, number] = isDiverging ? [-size, size] : [least, most];
  const span = ends[1] - ends[0] || 1;
  const levels = ticks(ends, LEVELS).filter((level) => level > ends[0] && level < ends[1]);
  return {
    unit,
    digits: isDifference ? digits + 1 : digits,
    ends,
    levels,
    fromSi,
    share: (value) => (value - ends[0]) / span,
  };
}

/** The share of the range that the middle of a value's band has. */
export function bandShare(scale: ValueScale, levels: readonly number[], value: number): number {
  const above = levels.findIndex((level) => level > value);
  const place = above < 0 ? levels.length : above;
  return scale.share(((levels[place - 1] ?? scale.ends[0]) + (levels[place] ?? scale.ends[1])) / 2);
}

/** Decimals that distinguish round numbers. */
export function levelDigits(levels: readonly number[]): number {
  const steps = levels.slice(1).map((level, i) => level - levels[i]);
  return Math.max(0, ...steps.map((step) => -Math.floor(Math.log10(Math.abs(step) * 1.000001))));
}

/** A value with its unit and, where the sign has one, its word. */
export function valueInWords(context: Context, shown: Shown, si: number): string {
  const { formatter, state } = context;
  if (Number.isNaN(si)) return "no shot";
  if (!shown.isDifference) return formatter.text(shown.name, si, state.system);
  const { unit, digits, fromSi } = valueScale(context, shown);
  const value = fromSi(si);
  return join(`${value > 0 ? "+" : ""}${formatter.format(value, digits)}`, formatter.units.symbol(unit));
}

/** What the map shows, and its unit. */
export function titleOf({ formatter, state, equipment }: Context, name: string, clubs: string[]): string {
  const { unit } = formatter.reading(name, state.system);
  const symbol = formatter.units.symbol(unit);
  const names = clubs.map((club) => equipment.clubs[club].label).join(" less ");
  return `${formatter.quantity(name).label}${symbol ? `, ${symbol}` : ""}: ${names}`;
}

/** A point of the face. */
export function placeInWords({ formatter, state }: Context, [toe, high]: Place): string {
  return `${formatter.text("toe", toe, state.system)}, ${formatter.text("high", high, state.system)}`;
}
