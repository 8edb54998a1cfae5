/** Colours that stand for values, from low to high or to both sides of zero, and for series. */

export type Colour = readonly [red: number, green: number, blue: number];

/** From a share of the range, 0 to 1, to a colour. */
export type Palette = (share: number) => Colour;

export interface ColourScale {
  /** Ends of the scale in SI. */
  least: number;
  most: number;
  at(value: number): Colour;
  /** The same as a CSS gradient from left to right. */
  gradient: string;
}

const rgb = (text: string): Colour => {
  const part = (place: number): number => Number.parseInt(text.slice(2 * place, 2 * place + 2), 16);
  return [part(0), part(1), part(2)];
};

/** The colours on straight lines between stops at even distances; shares beyond the ends have those of the ends. */
export function paletteOf(stops: readonly string[]): Palette {
  const colours = stops.map(rgb);
  return (share) => {
    const at = Math.max(0, Math.min(1, share || 0)) * (colours.length - 1);
    const before = Math.min(colours.length - 2, Math.floor(at));
    const [from, to] = [colours[before], colours[before + 1]];
    const mix = (part: 0 | 1 | 2): number => from[part] + (at - before) * (to[part] - from[part]);
    return [mix(0), mix(1), mix(2)];
  };
}

export const cssColour = ([red, green, blue]: Colour): string =>
  `rgb(${Math.round(red)} ${Math.round(green)} ${Math.round(blue)})`;

const VIRIDIS = ["440154", "482878", "3e4989", "31688e", "26828e", "1f9e89", "35b779", "6ece58", "b5de2b", "fde725"];
/**
 * Viridis, of S. van der Walt and N. Smith (2015): even steps in brightness, which can be distinguished without colours
 * and without seeing red or green.
 */
export const viridis = paletteOf(VIRIDIS);

/** From one side of zero to the other, pale in the middle. */
const BOTH_SIDES = ["053061", "2166ac", "4393c3", "92c5de", "f5f5f2", "fdc88c", "e68232", "b3500a", "6e2800"];

function scaleOf(stops: readonly string[], least: number, most: number): ColourScale {
  const palette = paletteOf(stops);
  return {
    least,
    most,
    at: (value) => palette(most > least ? (value - least) / (most - least) : 0),
    gradient: `linear-gradient(to right, ${stops.map((each) => `#${each}`).join(", ")})`,
  };
}

/** From 0 to a value. */
export const rising = (most: number): ColourScale => scaleOf(VIRIDIS, 0, most);

/** From minus a value to the value, zero in the middle. */
export const bothSides = (most: number): ColourScale => scaleOf(BOTH_SIDES, -most, most);

/** How many colours of series the page has, `--series-1` and those after it. */
const SERIES = 7;

/** How a series is drawn. */
export interface SeriesLook {
  /** The number of its colour. */
  number: number;
  /** Whether its lines are dashed and its marks hollow. */
  isDashed: boolean;
}

/** The look of a series by its place among the series: solid in all colours, then dashed; after twice seven again. */
export const seriesLook = (place: number): SeriesLook => ({
  number: (place % SERIES) + 1,
  isDashed: Math.floor(place / SERIES) % 2 === 1,
});

/** A short line in the look of a series, as a style. */
export const seriesLine = ({ number, isDashed }: SeriesLook): string =>
  `border-top: 3px ${isDashed ? "dashed" : "solid"} var(--series-${number})`;

/** Steps of round numbers within a power of ten. */
const ROUND = [1, 1.2, 1.5, 2, 2.5, 3, 4, 5, 6, 8, 10];

/** The least round number that is not below a value. */
export function roundUp(value: number): number {
  if (!(value > 0)) return 1;
  const power = 10 ** Math.floor(Math.log10(value));
  return (ROUND.find((each) => each * power >= value * (1 - 1e-9)) ?? 10) * power;
}
