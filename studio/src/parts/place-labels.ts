/** Places for the names of points in a picture, so that none covers another. */

/** A point and the size of its name [px]; y goes down. */
export interface Named {
  at: readonly [x: number, y: number];
  width: number;
  height: number;
}

/** A rectangle by its middle [px]. */
export interface Box {
  x: number;
  y: number;
  width: number;
  height: number;
}

type Point = readonly [x: number, y: number];

/** Half of the free space around a point that no name may cover [px], and the space between names. */
const POINT = 4;
const SPACE = 2;
/** How far a name may be to the side of its point and above or below it, in its height. */
const ACROSS = [0, 0.8, 1.5, 2.5, 4, 6, 8];
const UP = [0, 1, 1.6, 2.3, 3, 4, 5];
/** How much dearer a distance upwards is than one to the side: names stand in rows. */
const UPRIGHT = 2;
/** What else costs as much as so many heights to the side: a leader across another or through a name, a covered place. */
const CROSSING = 6;
const THROUGH = 10;
const COVERED = 2;
/** A name that costs more is left out. */
const MOST = 16;

/** Whether two boxes leave space between them. */
export const isApart = (a: Box, b: Box): boolean =>
  Math.abs(a.x - b.x) >= (a.width + b.width) / 2 + SPACE || Math.abs(a.y - b.y) >= (a.height + b.height) / 2 + SPACE;

/** The point of a box that is nearest to another, where a leader ends. */
export const edgeOf = ({ x, y, width, height }: Box, [toX, toY]: Point): Point => [
  Math.max(x - width / 2, Math.min(x + width / 2, toX)),
  Math.max(y - height / 2, Math.min(y + height / 2, toY)),
];

/** Whether two lines between points cross. */
function cross([a, b]: readonly [Point, Point], [c, d]: readonly [Point, Point]): boolean {
  const side = (p: Point, q: Point, r: Point): number => (q[0] - p[0]) * (r[1] - p[1]) - (q[1] - p[1]) * (r[0] - p[0]);
  return side(a, b, c) * side(a, b, d) < 0 && side(c, d, a) * side(c, d, b) < 0;
}

/** Whether a line between points runs through a box. */
function runsThrough(leader: readonly [Point, Point], { x, y, width, height }: Box): boolean {
  const [left, right, top, bottom] = [x - width / 2, x + width / 2, y - height / 2, y + height / 2];
  return (
    cross(leader, [
      [left, top],
      [right, bottom],
    ]) ||
    cross(leader, [
      [left, bottom],
      [right, top],
    ])
  );
}

/** Offsets of a name from its point, in its height, by turns to both sides; one at the point itself is none. */
const OFFSETS = UP.flatMap((up) =>
  ACROSS.flatMap((across) => [1, -1].flatMap((right) => [-1, 1].map((down): Point => [right * across, down * up]))),
).filter(([across, up]) => across !== 0 || up !== 0);

/** What stands in a picture besides the names: boxes that they must not cover, and places that they had better not. */
export interface Standing {
  taken: readonly Box[];
  places: readonly Point[];
}

/**
 * A box for each name, as near to its point as the others leave room for; null where there is none within the picture.
 * Earlier names have the choice.
 */
export function placeLabels(
  names: readonly Named[],
  picture: { width: number; height: number },
  { taken, places }: Standing = { taken: [], places: [] },
): (Box | null)[] {
  const points = names.map(({ at: [x, y] }): Box => ({ x, y, width: 2 * POINT, height: 2 * POINT }));
  const boxes: Box[] = [...taken];
  const leaders: [Point, Point][] = [];
  return names.map(({ at, width, height }) => {
    let best: { box: Box; leader: [Point, Point] } | null = null;
    let least = MOST;
    for (const [across, up] of OFFSETS) {
      const distance = Math.abs(across) + UPRIGHT * Math.abs(up);
      if (distance >= least) continue;
      const box: Box = {
        x: at[0] + across * height + (Math.sign(across) * width) / 2,
        y: at[1] + up * height,
        width,
        height,
      };
      if (!isWithin(box, picture) || ![...points, ...boxes].every((each) => isApart(box, each))) continue;
      const leader: [Point, Point] = [at, edgeOf(box, at)];
      const cost =
        distance +
        CROSSING * leaders.filter((each) => cross(leader, each)).length +
        THROUGH * boxes.filter((each) => runsThrough(leader, each)).length +
        THROUGH * leaders.filter((each) => runsThrough(each, box)).length +
        COVERED * places.filter(([x, y]) => !isApart(box, { x, y, width: 0, height: 0 })).length;
      if (cost < least) [best, least] = [{ box, leader }, cost];
    }
    if (!best) return null;
    boxes.push(best.box);
    leaders.push(best.leader);
    return best.box;
  });
}

const isWithin = ({ x, y, width, height }: Box, picture: { width: number; height: number }): boolean =>
  x >= width / 2 && x <= picture.width - width / 2 && y >= height / 2 && y <= picture.height - height / 2;
