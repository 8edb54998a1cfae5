/** Values over the points of a grid, and what is drawn of them: finer values in between, ranges, contour lines. */

import { contours as gridContours } from "../../parts/contours";

export interface Field {
  /** Places towards the toe and up the face [m], rising at even distances. */
  toe: ArrayLike<number>;
  high: ArrayLike<number>;
  /** Row by row from the lowest one up; NaN where there is none. */
  values: ArrayLike<number>;
}

export type Place = [toe: number, high: number];

/** The least and the greatest value of those that count; null where there is none. */
export function rangeOf(values: ArrayLike<number>, counts: (place: number) => boolean): [number, number] | null {
  let [least, most] = [Infinity, -Infinity];
  for (let i = 0; i < values.length; i += 1) {
    if (!counts(i) || Number.isNaN(values[i])) continue;
    least = Math.min(least, values[i]);
    most = Math.max(most, values[i]);
  }
  return least <= most ? [least, most] : null;
}

/** A curve through four values at even distances, at a share of the way from the second to the third (Catmull-Rom). */
function between([a, b, c, d]: number[], share: number): number {
  if (share === 0) return b;
  const curved = b + 0.5 * share * (c - a + share * (2 * a - 5 * b + 4 * c - d + share * (3 * (b - c) + d - a)));
  return Number.isNaN(curved) ? b + share * (c - b) : curved;
}

/** A value anywhere within the grid; NaN beyond it. */
export function valueAt({ toe, high, values }: Field, [across, up]: Place): number {
  const [columns, rows] = [toe.length, high.length];
  const x = ((across - toe[0]) / (toe[columns - 1] - toe[0])) * (columns - 1);
  const y = ((up - high[0]) / (high[rows - 1] - high[0])) * (rows - 1);
  if (!(x >= -1e-9 && y >= -1e-9 && x <= columns - 1 + 1e-9 && y <= rows - 1 + 1e-9)) return Number.NaN;
  const [column, row] = [cell(x, columns), cell(y, rows)];
  const along = (at: number): number =>
    between(
      four(column, columns).map((each) => values[at * columns + each]),
      x - column,
    );
  return between(four(row, rows).map(along), y - row);
}

const cell = (at: number, count: number): number => Math.max(0, Math.min(count - 2, Math.floor(at)));

/** The places of four values around a cell, those beyond the ends being the ends. */
const four = (at: number, count: number): number[] =>
  [at - 1, at, at + 1, at + 2].map((each) => Math.max(0, Math.min(count - 1, each)));

/**
 * The same field with values where there are none next to some, on the straight line through two of them: a picture that
 * is cut along an outline needs those beyond it.
 */
export function extended({ toe, high, values }: Field): Field {
  const columns = toe.length;
  const beyond = (place: number): number => {
    const [column, row] = [place % columns, Math.floor(place / columns)];
    const lines: number[] = [];
    for (const [right, up] of [
      [1, 0],
      [-1, 0],
      [0, 1],
      [0, -1],
    ]) {
      const [x, y] = [column + 2 * right, row + 2 * up];
      if (x < 0 || y < 0 || x >= columns || y >= high.length) continue;
      const step = up * columns + right;
      const value = 2 * values[place + step] - values[place + 2 * step];
      if (!Number.isNaN(value)) lines.push(value);
    }
    return lines.length ? lines.reduce((sum, each) => sum + each, 0) / lines.length : Number.NaN;
  };
  return { toe, high, values: Float64Array.from(values, (value, i) => (Number.isNaN(value) ? beyond(i) : value)) };
}

/** The same field with `times` as many points along each side. */
export function refined(field: Field, times: number): Field {
  const finer = (places: ArrayLike<number>): Float64Array => {
    const count = (places.length - 1) * times + 1;
    const step = (places[places.length - 1] - places[0]) / (count - 1);
    return Float64Array.from({ length: count }, (_, i) => places[0] + i * step);
  };
  const { toe, high, values } = field;
  const [across, up] = [finer(toe), finer(high)];
  // Along the rows first, and then up.
  const wide = new Float64Array(across.length * high.length);
  for (let row = 0; row < high.length; row += 1)
    for (let i = 0; i < across.length; i += 1) {
      const column = cell(i / times, toe.length);
      const near = four(column, toe.length).map((each) => values[row * toe.length + each]);
      wide[row * across.length + i] = between(near, i / times - column);
    }
  const whole = new Float64Array(across.length * up.length);
  for (let j = 0; j < up.length; j += 1) {
    const row = cell(j / times, high.length);
    const [a, b, c, d] = four(row, high.length).map((each) => each * across.length);
    for (let i = 0; i < across.length; i += 1)
      whole[j * across.length + i] = between([wide[a + i], wide[b + i], wide[c + i], wide[d + i]], j / times - row);
  }
  return { toe: across, high: up, values: whole };
}

/** Lines on which a field has a value: of each its points from one end to the other, closed ones back to the first. */
export function contours({ toe, high, values }: Field, level: number): Place[][] {
  const along = (places: ArrayLike<number>, at: number): number => {
    const before = cell(at, places.length);
    return places[before] + (at - before) * (places[before + 1] - places[before]);
  };
  const lines = gridContours({ columns: toe.length, rows: high.length, values }, level);
  return lines.map((line) => line.map(([column, row]) => [along(toe, column), along(high, row)]));
}
