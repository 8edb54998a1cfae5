/** Colours of values: even steps of lightness, and for what has a middle two hues that everybody can distinguish. */

export type Colour = readonly [red: number, green: number, blue: number];

/** From a share of the range to a colour. */
export type Palette = (share: number) => Colour;

/** Viridis, of S. van der Walt and N. Smith (2015): perceptually even, and legible without colours. */
const EVEN = ["440154", "482878", "3e4989", "31688e", "26828e", "1f9e89", "35b779", "6ece58", "b5de2b", "fde725"];
/** Blue for what is left or less, orange for what is right or more; the middle is that of the theme. */
const LIGHT = ["08408a", "3f7fc4", "9cc0e4", "f3f3ee", "f2bd8c", "d3762a", "8f3b05"];
const DARK = ["9dd2ff", "5b9fdc", "335f88", "23292b", "80562f", "d08a44", "ffc98f"];

const STEPS = 256;

const colourOf = (part: (place: number) => number): Colour => [part(0), part(1), part(2)];

const rgb = (text: string): Colour => colourOf((part) => Number.parseInt(text.slice(2 * part, 2 * part + 2), 16));

function stepsOf(stops: readonly string[]): Colour[] {
  const colours = stops.map(rgb);
  return Array.from({ length: STEPS }, (_, i) => {
    const at = (i / (STEPS - 1)) * (colours.length - 1);
    const place = Math.min(colours.length - 2, Math.floor(at));
    const [from, to] = [colours[place], colours[place + 1]];
    return colourOf((part) => from[part] + (at - place) * (to[part] - from[part]));
  });
}

export function paletteOf(isDiverging: boolean, isDark: boolean): Palette {
  const steps = stepsOf(isDiverging ? (isDark ? DARK : LIGHT) : EVEN);
  return (share) => steps[Math.max(0, Math.min(STEPS - 1, Math.round(share * (STEPS - 1))))];
}

export const cssColour = ([red, green, blue]: Colour): string =>
  `rgb(${Math.round(red)} ${Math.round(green)} ${Math.round(blue)})`;

/** Relative luminance, 0 to 1, as contrast is measured by (WCAG 2). */
export function luminance(colour: Colour): number {
  const [red, green, blue] = colour.map((part) => {
    const share = part / 255;
    return share <= 0.04045 ? share / 12.92 : ((share + 0.055) / 1.055) ** 2.4;
  });
  return 0.2126 * red + 0.7152 * green + 0.0722 * blue;
}

/** Black or white, whichever is clearer on a colour. */
export const inkOn = (colour: Colour): string => (luminance(colour) > 0.179 ? "#000" : "#fff");
