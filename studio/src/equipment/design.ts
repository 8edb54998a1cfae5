/** A club with other numbers than its own, struck as before: by one strike, or by a golfer. */

import type { Strike, Values } from "../core/types";
import type { Distribution, SetEntry } from "./equipment";

/** What belongs to a strike with a club that changes. */
export interface Setup {
  strike: Strike;
  /** Whose shots are averaged; null for the strike alone. */
  golfer: Distribution | null;
  /** Names of the inputs, in their order. */
  names: string[];
  /** Whether the parameters include a face, and its characteristic time where it is known. */
  face: Pick<SetEntry, "includes_face" | "characteristic_time">;
  /** Clubhead speed is proportional to the mass of the head to minus this power. */
  speedExponent: number;
}

/**
 * The same strike with other numbers of the club [SI]. A degree more loft of the club is a degree more at impact; a heavier
 * head is swung slower; a face that the parameters include is not counted twice.
 */
export function withClub(setup: Setup, values: Values): Setup {
  const { names, face, speedExponent } = setup;
  const place = (name: string): number => names.indexOf(name);
  const before = setup.strike.inputs;
  const inputs = [...before];
  for (const [name, value] of Object.entries(values)) inputs[place(name)] = value;
  const loft = inputs[place("static_loft")] - before[place("static_loft")];
  const slower = (before[place("club_mass")] / inputs[place("club_mass")]) ** speedExponent;
  inputs[place("loft")] += loft;
  inputs[place("speed")] *= slower;
  if (face.includes_face) {
    const time = place("characteristic_time");
    inputs[time] = inputs[time] || (face.characteristic_time ?? 0);
    inputs[place("included_time")] = face.characteristic_time ?? inputs[time];
  }
  return {
    ...setup,
    strike: { ...setup.strike, inputs },
    golfer: setup.golfer && delivering(setup.golfer, loft, slower),
  };
}

/** The golfer with more loft, and all speeds times a factor. */
function delivering(golfer: Distribution, loft: number, factor: number): Distribution {
  const scale = golfer.variables.map((name) => (name === "speed" ? factor : 1));
  const more = golfer.variables.map((name) => (name === "loft" ? loft : 0));
  return {
    ...golfer,
    mean: golfer.mean.map((each, i) => each * scale[i] + more[i]),
    covariance: golfer.covariance.map((row, i) => row.map((each, j) => each * scale[i] * scale[j])),
  };
}

/** What an input of the club does to an output, with all that changes with it, from derivatives by single inputs. */
export function slopeOf(setup: Setup, slopes: Values, name: string): number {
  const own = slopes[name] ?? Number.NaN;
  if (name === "static_loft") return own + slopes.loft;
  if (name !== "club_mass") return own;
  const value = (input: string): number => setup.strike.inputs[setup.names.indexOf(input)];
  return own - (setup.speedExponent * value("speed") * slopes.speed) / value("club_mass");
}
