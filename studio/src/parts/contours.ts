/** Lines of equal value and areas below a level on a regular grid; places are in cells from its first corner. */

export type Place = readonly [column: number, row: number];

/** Values on a grid, one row after the other; NaN where there is none. */
export interface Grid {
  columns: number;
  rows: number;
  values: ArrayLike<number>;
}

/** The corners of a cell, all the way round. */
const corners = (column: number, row: number): Place[] => [
  [column, row],
  [column + 1, row],
  [column + 1, row + 1],
  [column, row + 1],
];

/** Where a level lies between two corners, on a straight line between their values. */
function between(one: Place, other: Place, from: number, to: number, level: number): Place {
  const share = (level - from) / (to - from);
  return [one[0] + share * (other[0] - one[0]), one[1] + share * (other[1] - one[1])];
}

/**
 * The lines on which a grid has the value of a level: of each its points from one end to the other, closed ones back to the
 * first. Cells with a corner that has no value have none.
 */
export function contours({ columns, rows, values }: Grid, level: number): Place[][] {
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
    const place = (each: number): Place => [each % columns, Math.floor(each / columns)];
    if (!ends.has(edge)) ends.set(edge, between(place(from), place(to), values[from], values[to], level));
    return edge;
  };
  for (let row = 0; row + 1 < rows; row += 1)
    for (let column = 0; column + 1 < columns; column += 1) {
      const corner = row * columns + column;
      const around = [corner, corner + 1, corner + columns + 1, corner + columns];
      if (!around.every((each) => Number.isFinite(values[each]))) continue;
      const above = around.map((each) => values[each] > level);
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
        const middle = around.reduce((sum, each) => sum + values[each], 0) / 4 > level;
        const [a, b] = middle === above[0] ? [1, 3] : [3, 1];
        join(passed[0], passed[a]);
        join(passed[2], passed[b]);
      }
    }
  return chains(ends, next);
}

/** Chains of crossings: those with ends first, then the closed ones. */
function chains(ends: Map<number, Place>, next: Map<number, number[]>): Place[][] {
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

/** The area below a level as polygons, each within one cell; what has no value counts as below. */
export function areaBelow({ columns, rows, values }: Grid, level: number): Place[][] {
  const polygons: Place[][] = [];
  for (let row = 0; row + 1 < rows; row += 1)
    for (let column = 0; column + 1 < columns; column += 1) {
      const places = corners(column, row);
      const around = places
        .map(([x, y]) => values[y * columns + x])
        .map((value) => (Number.isFinite(value) ? value : level - 1));
      const polygon: Place[] = [];
      for (let i = 0; i < 4; i += 1) {
        const next = (i + 1) % 4;
        if (around[i] < level) polygon.push(places[i]);
        if (around[i] < level !== around[next] < level)
          polygon.push(between(places[i], places[next], around[i], around[next], level));
      }
      if (polygon.length) polygons.push(polygon);
    }
  return polygons;
}
