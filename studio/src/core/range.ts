/** What the range computes: the clubs of a bag, the shots of a golfer, and the air that they fly through. */

import type { LoadedCore } from "clubface-core";
import type { Distribution, HoleEntry } from "../equipment/equipment";
import { computeShot, conditionsOf, flightInputs } from "./compute";
import type { CoreArray, Dispersion, Shot, Strike, Values } from "./types";

export interface BagShot extends Shot {
  club: string;
}

/** A shot of each club. */
export const computeBag = (core: LoadedCore, bag: { club: string; strike: Strike }[]): BagShot[] =>
  bag.map(({ club, strike }) => ({ ...computeShot(core, strike), club }));

export interface GolferShots {
  strike: Strike;
  golfer: Distribution;
  count: number;
  seed: number;
  /** How many of the first landings are returned. */
  landings: number;
  percentiles: number[];
  ellipses: number[];
  hole: HoleEntry & { length: number };
}

/** Where the shots of a golfer go; `landings` are their places ahead and to the right, by turns [m]. */
export function computeDispersion(
  core: LoadedCore,
  { strike, count, landings, ...rest }: GolferShots,
): Dispersion & { landings: CoreArray } {
  const { model, inputs, parameters } = strike;
  // As JSON an infinite radius and the launch, which each shot has of its own, are null.
  const setup = { model, inputs, parameters, flight: flightInputs(core, strike, {}), ...rest };
  const { text, arrays } = core.dispersion(setup, count, landings);
  return { ...text, landings: arrays.landings };
}

/** Pressure and density of the air that conditions of a flight mean, in SI. */
export function computeAir(core: LoadedCore, conditions: Values): Values {
  const given = conditionsOf(core, conditions);
  const [temperature, pressure, humidity] = ["temperature", "pressure", "humidity"].map(
    (name) => given[name] ?? core.description.flight_inputs.find((each) => each.name === name)?.default ?? Number.NaN,
  );
  return { temperature, pressure, humidity, air_density: core.airDensity(temperature, pressure, humidity) };
}
