/** Numbers with their units, by the table of units that the core describes. */

import type { Description, Unit } from "../core/types";

/** A number as a person gave it. */
export interface Amount {
  value: number;
  unit: string;
}

/** One spelling of `kg m2`, `kg m^2`, `kg·m²` and `kg*m^2`. */
const plain = (spelling: string): string =>
  spelling
    .replace(/²/g, "2")
    .replace(/³/g, "3")
    .replace(/[\^*·⋅\s]/g, "");

const NUMBER = /^\s*([+-−]?(?:\d+[.,]?\d*|[.,]\d+)(?:[eE][+-]?\d+)?)\s*(.*?)\s*$/;

export class Units {
  private readonly bySpelling = new Map<string, Unit>();
  private readonly bySymbol = new Map<string, Unit>();
  private readonly printed = new Map<string, string>();

  constructor(private readonly description: Pick<Description, "units">) {
    for (const unit of description.units) {
      this.bySymbol.set(unit.symbol, unit);
      for (const spelling of [unit.symbol, ...unit.spellings]) this.bySpelling.set(plain(spelling), unit);
    }
  }

  unit(symbol: string): Unit {
    const unit = this.bySymbol.get(symbol) ?? this.bySpelling.get(plain(symbol));
    if (!unit) throw new Error(`${symbol}: no such unit`);
    return unit;
  }

  /** The symbols of the units that fit another. */
  symbolsLike(symbol: string): string[] {
    const { dimension } = this.unit(symbol);
    return this.description.units.filter((unit) => unit.dimension === dimension).map((unit) => unit.symbol);
  }

  toSi({ value, unit }: Amount): number {
    const { numerator, denominator, offset } = this.unit(unit);
    return (value * numerator) / denominator + offset;
  }

  fromSi(value: number, symbol: string): number {
    const { numerator, denominator, offset } = this.unit(symbol);
    return ((value - offset) * denominator) / numerator;
  }

  /** A difference, to which the zero of a scale does not matter. */
  differenceFromSi(value: number, symbol: string): number {
    const { numerator, denominator } = this.unit(symbol);
    return (value * denominator) / numerator;
  }

  /** The amount that a text says; without a unit it is in `usual`. An error says what is wanted. */
  parse(text: string, usual: string): Amount {
    const wanted = `a number in ${this.symbolsLike(usual)
      .map((symbol) => this.symbol(symbol))
      .join(", ")}`;
    const [, digits, spelling] = NUMBER.exec(text) ?? [];
    const value = Number((digits ?? "").replace(",", ".").replace("−", "-"));
    if (!digits || !Number.isFinite(value)) throw new Error(`give ${wanted}`);
    if (!spelling) return { value, unit: usual };
    const unit = this.bySpelling.get(plain(spelling));
    if (unit?.dimension !== this.unit(usual).dimension) throw new Error(`${spelling} does not fit: give ${wanted}`);
    return { value, unit: unit.symbol };
  }

  /** A unit as people write it: ° for deg, µs for us, cm² for cm2, nothing for 1. */
  symbol(symbol: string): string {
    if (symbol === "1") return "";
    const known = this.printed.get(symbol);
    if (known !== undefined) return known;
    const spelling = this.unit(symbol).spellings.find((each) => /[°µ]/.test(each)) ?? symbol;
    const printed = spelling.replace(/(?<=[a-z])[23]/g, (power) => (power === "2" ? "²" : "³"));
    this.printed.set(symbol, printed);
    return printed;
  }
}
