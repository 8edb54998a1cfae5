/** What is computed of a golfer: the scatter about the delivery of the sliders, with the strike of the state. */

import { type Context, choiceSetting, delivered, settingSi, strike } from "../../context";
import type { GolferShots } from "../../core/range";
import type { Distribution } from "../../equipment/equipment";
import { changed, type State } from "../../state/state";

/** Shots that are computed, and of these the ones that are drawn. */
export const COUNT = 4096;
export const DRAWN = 1000;
export const PERCENTILES = [0.05, 0.25, 0.5, 0.75, 0.95];
const ELLIPSES = [0.5, 0.9];

/** How the golfer's shots differ, about the delivery of the sliders. */
function spreadOf(context: Context): Distribution {
  const own = context.equipment.golfers[choiceSetting(context, "golfer")][context.state.hand];
  return { ...own, mean: own.variables.map((name) => delivered(context, name)) };
}

export const golferShots = (context: Context): GolferShots => ({
  strike: strike(context),
  golfer: spreadOf(context),
  count: COUNT,
  seed: 0,
  landings: DRAWN,
  percentiles: PERCENTILES,
  ellipses: ELLIPSES,
  hole: { ...context.equipment.hole, length: Math.max(settingSi(context, "hole"), 1) },
});

/** The state in which a golfer plays the own club with the own mean delivery. */
export function withGolfer(
  { state, equipment, formatter }: Pick<Context, "state" | "equipment" | "formatter">,
  name: string,
): State {
  const { club, [state.hand]: own } = equipment.golfers[name];
  const amounts = own.variables.map((variable, i) => {
    const { unit } = formatter.reading(variable, state.system);
    // As it was written: conversion leaves nothing behind the twelfth digit.
    return [variable, { value: Number(formatter.units.fromSi(own.mean[i], unit).toPrecision(12)), unit }];
  });
  const struck = changed(state, { kind: "club", club }, equipment);
  const { range_view, ...others } = state.settings;
  // The shots open from above; a view that was chosen of them stays.
  const seen: State["settings"] = state.settings.flying === "golfer" && range_view !== undefined ? { range_view } : {};
  const settings = { ...others, ...seen, golfer: name, flying: "golfer" };
  return { ...struck, delivery: Object.fromEntries(amounts), settings };
}
