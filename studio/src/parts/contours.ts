/** Lines of equal value and areas below a level on a regular grid, in parts of its cells. */

export type Place = readonly [column: number, row: number];

/** Values on a grid, one row after the other; NaN where there is none. */
export interface Grid {
  columns: number;
  rows: number;
  values: ArrayLike<number>;
}

const at = ({ columns, values }: Grid, column: number, row: number): number => values[row * columns + column];

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

function eachCell(grid: Grid, visit: (places: Place[], values: number[]) => void): void {
  for (let row = 0; row < grid.rows - 1; row += 1)
    for (let column = 0; column < grid.columns - 1; column += 1) {
      const places = corners(column, row);
      visit(
        places,
        places.map(([c, r]) => at(grid, c, r)),
      );
    }
}

/** The line of a level as pieces, each within one cell. */
export function contour(grid: Grid, level: number): [Place, Place][] {
  const pieces: [Place, Place][] = [];
  eachCell(grid, (places, values) => {
    if (!values.every(Number.isFinite)) return;
    const crossings: Place[] = [];
    for (let i = 0; i < 4; i += 1) {
      const next = (i + 1) % 4;
      if (values[i] < level === values[next] < level) continue;
      crossings.push(between(places[i], places[next], values[i], values[next], level));
    }
    // Four crossings are a saddle: any two lines are as good as the other two.
    for (let i = 0; i + 1 < crossings.length; i += 2) pieces.push([crossings[i], crossings[i + 1]]);
  });
  return pieces;
}

/** The area below a level as polygons, each within one cell; what has no value counts as below. */
export function areaBelow(grid: Grid, level: number): Place[][] {
  const polygons: Place[][] = [];
  eachCell(grid, (places, given) => {
    const values = given.map((value) => (Number.isFinite(value) ? value : level - 1));
    const polygon: Place[] = [];
    for (let i = 0; i < 4; i += 1) {
      const next = (i + 1) % 4;
      if (values[i] < level) polygon.push(places[i]);
      if (values[i] < level !== values[next] < level)
        polygon.push(between(places[i], places[next], values[i], values[next], level));
    }
    if (polygon.length) polygons.push(polygon);
  });
  return polygons;
}
