/** Values as people read them: digits and units from the core, the form of numbers from the browser. */

import type { Description, Quantity } from "../core/types";
import { type Amount, Units } from "./units";

export const SYSTEMS = ["golf", "metric"] as const;
export type System = (typeof SYSTEMS)[number];

export interface Shown {
  number: string;
  unit: string;
  /** The word for the sign, such as "left"; "" where there is none. */
  side: string;
}

export class Formatter {
  readonly units: Units;
  private readonly quantities: Map<string, Quantity>;
  private readonly formats = new Map<number, Intl.NumberFormat>();

  constructor(
    description: Description,
    private readonly language: string,
    /** Quantities that the core does not know. */
    further: Quantity[] = [],
  ) {
    this.units = new Units(description);
    this.quantities = new Map([...description.quantities, ...further].map((each) => [each.name, each]));
  }

  /** Whether the core describes a quantity; the package has some of its own. */
  knows(name: string): boolean {
    return this.quantities.has(name);
  }

  quantity(name: string): Quantity {
    const result = this.quantities.get(name);
    if (!result) throw new Error(`${name}: no such quantity`);
    return result;
  }

  reading(name: string, system: System): { unit: string; digits: number } {
    const [unit, digits] = this.quantity(name)[system];
    return { unit, digits };
  }

  format(value: number, digits: number): string {
    let format = this.formats.get(digits);
    if (!format) {
      const options = { minimumFractionDigits: digits, maximumFractionDigits: digits, useGrouping: false } as const;
      format = new Intl.NumberFormat(this.language, { ...options, signDisplay: "negative" });
      this.formats.set(digits, format);
    }
    return format.format(value);
  }

  /** A value in SI; where the quantity has words for its sides, they stand for the sign. */
  show(name: string, si: number, system: System): Shown {
    const { sides, label } = this.quantity(name);
    const { unit, digits } = this.reading(name, system);
    const value = this.units.fromSi(si, unit);
    const number = this.format(sides ? Math.abs(value) : value, digits);
    const side = sideOf(sides, value, digits);
    // "backspin 2183 rpm" needs no word for its sign, "backspin 300 rpm topspin" does.
    return { number, unit: this.units.symbol(unit), side: label === side ? "" : side };
  }

  /** The same in one text: "2.2 yd left". */
  text(name: string, si: number, system: System): string {
    const { number, unit, side } = this.show(name, si, system);
    return join(number, unit, side);
  }

  /**
   * A difference in SI: with a word where the quantity has sides, otherwise with a sign; "0.3° right", "+120 rpm".
   * `finer` is how many digits it has more than a value.
   */
  difference(name: string, si: number, system: System, { hasSides = true, hasUnit = true, finer = 0 } = {}): string {
    const { label, ...quantity } = this.quantity(name);
    const sides = hasSides ? quantity.sides : null;
    const { unit, digits: usual } = this.reading(name, system);
    const digits = usual + finer;
    const value = this.units.differenceFromSi(si, unit);
    const word = sideOf(sides, value, digits);
    const isSigned = !word || sides?.includes(label);
    const sign = isSigned && Number(value.toFixed(digits)) > 0 ? "+" : "";
    const number = sign + this.format(isSigned ? value : Math.abs(value), digits);
    return join(number, hasUnit ? this.units.symbol(unit) : "", isSigned ? "" : word);
  }

  /** An amount in the unit of a system, as a field shows it; unchanged where it was given in that unit. */
  inSystem(name: string, amount: Amount, system: System): number {
    const { unit } = this.reading(name, system);
    return amount.unit === unit ? amount.value : this.units.fromSi(this.units.toSi(amount), unit);
  }
}

/** The word for the sign of a value, "" where there is none or where the value rounds to 0. */
export const sideOf = (sides: readonly [string, string] | null, value: number, digits: number): string =>
  sides && Number(value.toFixed(digits)) !== 0 ? sides[value < 0 ? 0 : 1] : "";

/** What stands between a number and its unit: nothing before a sign of degrees or per cent, else a space. */
export const gap = (unit: string): string => (unit === "" || unit.startsWith("°") || unit === "%" ? "" : " ");

/** Number, unit and word in one text. */
export const join = (number: string, unit: string, side = ""): string =>
  [number + gap(unit) + unit, side].filter(Boolean).join(" ");

/** The heading of a row or column: what stands there, and its unit. */
export const withUnit = (label: string, unit: string): string => (unit ? `${label},\u00a0${unit}` : label);

const GREEK: Record<string, string> = {
  alpha: "α",
  beta: "β",
  delta: "δ",
  epsilon: "ε",
  eta: "η",
  lambda: "λ",
  mu: "μ",
  nu: "ν",
  omega: "ω",
  phi: "φ",
  psi: "ψ",
  rho: "ρ",
  sigma: "σ",
  tau: "τ",
  theta: "θ",
};

/** A symbol as it is printed, and its index: `omega_b` is ω with b below. */
export function printedSymbol(symbol: string): [letter: string, index: string] {
  const [letter, ...index] = symbol.split("_");
  return [GREEK[letter] ?? letter, index.join(" ")];
}
