/** Values over the points of a grid, and what is drawn of them: finer values in between, ranges, contour lines. */

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
  const columns = toe.length;
  const ends = new Map<number, Place>();
  const next = new Map<number, number[]>();
  const join = (one: number, other: number): void => {
    next.set(one, [...(next.get(one) ?? []), other]);
    next.set(other, [...(next.get(other) ?? []), one]);
  };
  /** Where the level is passed on an edge of the grid, which has a number of its own. */
  const crossing = (from: number, isUpright: boolean): number => {
    const to = from + (isUpright ? columns : 1);
    const edge = 2 * from + (isUpright ? 1 : 0);
    if (!ends.has(edge)) {
      const share = (level - values[from]) / (values[to] - values[from]);
      const at = (place: number): Place => [toe[place % columns], high[Math.floor(place / columns)]];
      const [[x, y], [u, v]] = [at(from), at(to)];
      ends.set(edge, [x + share * (u - x), y + share * (v - y)]);
    }
    return edge;
  };
  for (let row = 0; row + 1 < high.length; row += 1)
    for (let column = 0; column + 1 < columns; column += 1) {
      const corner = row * columns + column;
      const corners = [corner, corner + 1, corner + columns + 1, corner + columns];
      if (corners.some((each) => Number.isNaN(values[each]))) continue;
      const above = corners.map((each) => values[each] > level);
      const edges: (readonly [number, boolean])[] = [
        [corner, false],
        [corner + 1, true],
        [corner + columns, false],
        [corner, true],
      ];
      const passed = edges.filter((_, i) => above[i] !== above[(i + 1) % 4]).map(([at, up]) => crossing(at, up));
      if (passed.length === 2) join(passed[0], passed[1]);
      else if (passed.length === 4) {
        // A saddle: the corners whose side the middle is on are connected.
        const middle = corners.reduce((sum, each) => sum + values[each], 0) / 4 > level;
        const [a, b] = middle === above[0] ? [1, 3] : [3, 1];
        join(passed[0], passed[a]);
        join(passed[2], passed[b]);
      }
    }
  return lines(ends, next);
}

/** Chains of crossings: those with ends first, then the closed ones. */
function lines(ends: Map<number, Place>, next: Map<number, number[]>): Place[][] {
  const left = new Set(next.keys());
  const result: Place[][] = [];
  const walk = (start: number): void => {
    const line: Place[] = [];
    let at: number | undefined = start;
    while (at !== undefined) {
      left.delete(at);
      const place = ends.get(at);
      if (place) line.push(place);
      at = next.get(at)?.find((each) => left.has(each));
    }
    const last = next.get(start) ?? [];
    if (last.length === 2 && line.length > 2) line.push(line[0]);
    result.push(line);
  };
  for (const [edge, others] of next) if (others.length === 1 && left.has(edge)) walk(edge);
  for (const edge of next.keys()) if (left.has(edge)) walk(edge);
  return result;
}
