/** Colours that stand for values, from low to high or to both sides of zero, and for series. */

export type Rgb = readonly [red: number, green: number, blue: number];

export interface ColourScale {
  /** Ends of the scale in SI. */
  least: number;
  most: number;
  at(value: number): Rgb;
  /** The same as a CSS gradient from left to right. */
  gradient: string;
}

/** Colours of equal steps in brightness, which can be distinguished without seeing red or green (viridis). */
const RISING: Rgb[] = [
  [68, 1, 84],
  [71, 44, 122],
  [59, 81, 139],
  [44, 113, 142],
  [33, 144, 141],
  [39, 173, 129],
  [92, 200, 99],
  [170, 220, 50],
  [253, 231, 37],
];
/** From one side of zero to the other, pale in the middle. */
const BOTH_SIDES: Rgb[] = [
  [5, 48, 97],
  [33, 102, 172],
  [67, 147, 195],
  [146, 197, 222],
  [245, 245, 242],
  [253, 200, 140],
  [230, 130, 50],
  [179, 80, 10],
  [110, 40, 0],
];

function scaleOf(stops: Rgb[], least: number, most: number): ColourScale {
  const steps = stops.length - 1;
  return {
    least,
    most,
    at(value) {
      const share = most > least ? (value - least) / (most - least) : 0;
      const place = Math.max(0, Math.min(1, Number.isFinite(share) ? share : 0)) * steps;
      const before = Math.min(steps - 1, Math.floor(place));
      const rest = place - before;
      const mix = (channel: 0 | 1 | 2): number =>
        stops[before][channel] * (1 - rest) + stops[before + 1][channel] * rest;
      return [mix(0), mix(1), mix(2)];
    },
    gradient: `linear-gradient(to right, ${stops.map((each) => `rgb(${each.join(" ")})`).join(", ")})`,
  };
}

/** From 0 to a value. */
export const rising = (most: number): ColourScale => scaleOf(RISING, 0, most);

/** From minus a value to the value, zero in the middle. */
export const bothSides = (most: number): ColourScale => scaleOf(BOTH_SIDES, -most, most);

/** How many colours of series the page has, `--series-1` and those after it. */
const SERIES = 6;

/** The number of a series' colour, by its place among the series; after the last colour they begin again. */
export const seriesNumber = (place: number): number => (place % SERIES) + 1;

/** Steps of round numbers within a power of ten. */
const ROUND = [1, 1.2, 1.5, 2, 2.5, 3, 4, 5, 6, 8, 10];

/** The least round number that is not below a value. */
export function roundUp(value: number): number {
  if (!(value > 0)) return 1;
  const power = 10 ** Math.floor(Math.log10(value));
  return (ROUND.find((each) => each * power >= value * (1 - 1e-9)) ?? 10) * power;
}
