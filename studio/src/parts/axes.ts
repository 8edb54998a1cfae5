/** Places and marks of axes, for pictures that are drawn at the size at which they are shown. */

/** Maps values to pixels. */
export interface Scale {
  at(value: number): number;
  /** Pixels of one unit of the value. */
  size: number;
}

export const scale = (from: readonly [number, number], to: readonly [number, number]): Scale => {
  const size = (to[1] - to[0]) / (from[1] - from[0]);
  return { at: (value) => to[0] + (value - from[0]) * size, size: Math.abs(size) };
};

/** Round numbers within a range, about `count` of them. */
export function ticks([least, most]: readonly [number, number], count: number): number[] {
  const rough = (most - least) / Math.max(1, count);
  if (!(rough > 0) || !Number.isFinite(rough)) return [];
  const power = 10 ** Math.floor(Math.log10(rough));
  const step = [1, 2, 5, 10].map((each) => each * power).find((each) => each >= rough) ?? 10 * power;
  const result: number[] = [];
  for (let i = Math.ceil(least / step - 1e-9); i * step <= most * (1 + 1e-9); i += 1) result.push(i * step + 0);
  return result;
}

/** Points as an SVG path. */
export const line = (points: readonly (readonly [number, number])[]): string =>
  points.map(([x, y], i) => `${i ? "L" : "M"}${x.toFixed(1)} ${y.toFixed(1)}`).join("");
