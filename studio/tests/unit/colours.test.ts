/** Colours of series, as eyes of all kinds see them. */

import { readFileSync } from "node:fs";
import { join } from "node:path";
import { expect, test } from "vitest";
import { seriesLook } from "../../src/parts/colours";

type Triple = readonly [number, number, number];
type Matrix = readonly [Triple, Triple, Triple];

const CSS = readFileSync(join(import.meta.dirname, "../../src/style/page.css"), "utf8");

const times = (matrix: Matrix, [a, b, c]: Triple): Triple =>
  matrix.map(([x, y, z]) => x * a + y * b + z * c) as unknown as Triple;

/** Red, green and blue in amounts of light. */
const light = (colour: string): Triple =>
  [1, 3, 5].map((at) => {
    const share = Number.parseInt(colour.slice(at, at + 2), 16) / 255;
    return share <= 0.04045 ? share / 12.92 : ((share + 0.055) / 1.055) ** 2.4;
  }) as unknown as Triple;

const themes = (name: string): [light: Triple, dark: Triple] => {
  const [, ...both] = new RegExp(`--${name}: light-dark\\((#\\w{6}), (#\\w{6})\\)`).exec(CSS) ?? [];
  return both.map(light) as [Triple, Triple];
};

/** What is seen without cones for red, green or blue: Machado, Oliveira and Fernandes (2009), severity 1. */
const EYES: Record<string, Matrix> = {
  all: [
    [1, 0, 0],
    [0, 1, 0],
    [0, 0, 1],
  ],
  "no red": [
    [0.152286, 1.052583, -0.204868],
    [0.114503, 0.786281, 0.099216],
    [-0.003882, -0.048116, 1.051998],
  ],
  "no green": [
    [0.367322, 0.860646, -0.227968],
    [0.280085, 0.672501, 0.047413],
    [-0.01182, 0.04294, 0.968881],
  ],
  "no blue": [
    [1.255528, -0.076749, -0.178779],
    [-0.078411, 0.930809, 0.147602],
    [0.004733, 0.691367, 0.3039],
  ],
};

/** OKLab, of B. Ottosson (2020), in which equal distances look alike. */
const CONES: Matrix = [
  [0.4122214708, 0.5363325363, 0.0514459929],
  [0.2119034982, 0.6806995451, 0.1073969566],
  [0.0883024619, 0.2817188376, 0.6299787005],
];
const LAB: Matrix = [
  [0.2104542553, 0.793617785, -0.0040720468],
  [1.9779984951, -2.428592205, 0.4505937099],
  [0.0259040371, 0.7827717662, -0.808675766],
];
const seen = (colour: Triple, eye: Matrix): Triple => {
  const cones = times(CONES, times(eye, colour).map((share) => Math.max(0, Math.min(1, share))) as unknown as Triple);
  return times(LAB, cones.map(Math.cbrt) as unknown as Triple);
};

const luminance = ([red, green, blue]: Triple): number => 0.2126 * red + 0.7152 * green + 0.0722 * blue;

const SERIES = Array.from({ length: 7 }, (_, i) => themes(`series-${i + 1}`));

test("fourteen series differ in colour or dash", () => {
  const looks = Array.from({ length: 14 }, (_, place) => JSON.stringify(seriesLook(place)));
  expect(new Set(looks).size).toBe(14);
  expect(seriesLook(6).number).toBe(7);
});

test.each([0, 1])("the seven colours differ for eyes of all kinds, theme %i", (theme) => {
  // 0.02 is a difference that is just seen; a third of the way from black to a grey of the middle is 0.15.
  for (const [name, eye] of Object.entries(EYES))
    SERIES.forEach((one, i) => {
      for (const other of SERIES.slice(0, i)) {
        const [a, b] = [seen(one[theme], eye), seen(other[theme], eye)];
        expect(Math.hypot(a[0] - b[0], a[1] - b[1], a[2] - b[2]), name).toBeGreaterThan(0.1);
      }
    });
});

test.each([0, 1])("they stand out from what they are drawn on, theme %i", (theme) => {
  // Lines must have 3 to 1 against what they are drawn on (WCAG 2.1, 1.4.11).
  const card = luminance(themes("card")[theme]);
  for (const series of SERIES) {
    const [least, most] = [luminance(series[theme]), card].sort((a, b) => a - b);
    expect((most + 0.05) / (least + 0.05)).toBeGreaterThanOrEqual(3);
  }
});
