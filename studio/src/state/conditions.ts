/** Wind, air and ground of every flight: settings that hold for all scenes, and the inputs of the core made of them. */

import type { Values } from "../core/types";
import type { Equipment } from "../equipment/equipment";
import type { Units } from "../quantities/units";
import type { Setting, Settings } from "./settings";
import type { State } from "./state";

const amount = (quantity: string, value: number, unit: string): Setting => ({
  kind: "amount",
  quantity,
  usual: { value, unit },
});

export const CONDITIONS = {
  wind: amount("wind_speed", 0, "mph"),
  wind_from: amount("wind_from", 0, "deg"),
  altitude: amount("altitude", 0, "m"),
  temperature: amount("temperature", 25, "degC"),
  humidity: amount("humidity", 50, "%"),
  pressure: amount("pressure", 1013.25, "hPa"),
  ground: { kind: "choice", options: ({ grounds }: Equipment) => Object.keys(grounds), usual: "fairway" },
} satisfies Settings;

export type Condition = keyof typeof CONDITIONS;

/** The conditions that were given. */
export const givenConditions = (state: Pick<State, "settings">): Condition[] =>
  (Object.keys(CONDITIONS) as Condition[]).filter((name) => Object.hasOwn(state.settings, name));

/**
 * Inputs of a flight in SI that are not as usual. An `altitude` stands for the pressure that the core takes there; where a
 * pressure is given, it holds, and the altitude does not count. A direction without a wind is none.
 */
export function flightConditions(
  state: Pick<State, "settings">,
  { grounds }: Pick<Equipment, "grounds">,
  units: Units,
): Values {
  const si = (name: Condition): number => {
    const value = state.settings[name] ?? CONDITIONS[name].usual;
    return typeof value === "string" ? Number.NaN : units.toSi(value);
  };
  const given = givenConditions(state);
  const result: Values = {};
  const ofAir = given.includes("pressure") ? ["pressure"] : ["altitude"];
  for (const name of given) if ([...ofAir, "temperature", "humidity"].includes(name)) result[name] = si(name);
  if (si("wind")) {
    const from = si("wind_from");
    result.wind_x = -si("wind") * Math.cos(from);
    result.wind_z = -si("wind") * Math.sin(from);
  }
  const { ground } = state.settings;
  return typeof ground === "string" ? { ...result, ...grounds[ground] } : result;
}
