/** Colours of the map: even steps of brightness, and for what has a middle two hues that everybody can distinguish. */

import { type Colour, type Palette, paletteOf, viridis } from "../../parts/colours";

/** Blue for what is left or less, orange for what is right or more; the middle is that of the theme. */
const LIGHT = ["08408a", "3f7fc4", "9cc0e4", "f3f3ee", "f2bd8c", "d3762a", "8f3b05"];
const DARK = ["9dd2ff", "5b9fdc", "335f88", "23292b", "80562f", "d08a44", "ffc98f"];

const STEPS = 256;

/** The colours of the map, in steps: a picture asks for one a pixel. */
export function mapPalette(isDiverging: boolean, isDark: boolean): Palette {
  const palette = isDiverging ? paletteOf(isDark ? DARK : LIGHT) : viridis;
  const steps = Array.from({ length: STEPS }, (_, i) => palette(i / (STEPS - 1)));
  return (share) => steps[Math.max(0, Math.min(STEPS - 1, Math.round(share * (STEPS - 1))))];
}

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
