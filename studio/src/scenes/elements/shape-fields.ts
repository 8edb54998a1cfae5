/** What the shapes of an impact say at a moment: how far and how fast its pieces move, and how flat it is. */

import type { ElementsImpact } from "../../core/elements";

/** The shape nearest to a moment. */
export function frameAt({ times }: ElementsImpact, moment: number): number {
  let best = 0;
  for (let i = 1; i < times.length; i += 1) if (Math.abs(times[i] - moment) < Math.abs(times[best] - moment)) best = i;
  return best;
}

/** How far each kept node stands from where it would be in a ball that keeps its shape and does not turn [m]. */
export function displacements({ places, centres, nodes }: ElementsImpact, frame: number): Float32Array {
  const result = new Float32Array(nodes);
  for (let i = 0; i < nodes; i += 1) {
    let square = 0;
    for (let axis = 0; axis < 3; axis += 1) {
      const now = places[3 * (frame * nodes + i) + axis] - centres[3 * frame + axis];
      square += (now - (places[3 * i + axis] - centres[axis])) ** 2;
    }
    result[i] = Math.sqrt(square);
  }
  return result;
}

/** The speed of each kept node over the ground [m/s], from the shapes before and after. */
export function speeds({ places, nodes, times, drift }: ElementsImpact, frame: number): Float32Array {
  const result = new Float32Array(nodes);
  const [before, after] = [Math.max(0, frame - 1), Math.min(times.length - 1, frame + 1)];
  const span = times[after] - times[before];
  if (!(span > 0)) return result;
  for (let i = 0; i < nodes; i += 1) {
    let square = 0;
    for (let axis = 0; axis < 3; axis += 1) {
      const moved = places[3 * (after * nodes + i) + axis] - places[3 * (before * nodes + i) + axis];
      square += (moved / span - drift[axis]) ** 2;
    }
    result[i] = Math.sqrt(square);
  }
  return result;
}

/** The largest value of a field over all shapes; kept, since it does not change. */
export function most(impact: ElementsImpact, field: typeof displacements): number {
  const known = kept.get(impact) ?? new Map<typeof displacements, number>();
  kept.set(impact, known);
  let result = known.get(field);
  if (result === undefined) {
    result = 0;
    for (let frame = 0; frame < impact.times.length; frame += 1)
      for (const value of field(impact, frame)) result = Math.max(result, value);
    known.set(field, result);
  }
  return result;
}
const kept = new WeakMap<ElementsImpact, Map<typeof displacements, number>>();

/** How wide the ball is along the normal, up the face and towards the toe [m]. */
export function widths({ places, nodes, axes }: ElementsImpact, frame: number): [number, number, number] {
  return axes.map((axis) => {
    let [least, greatest] = [Number.POSITIVE_INFINITY, Number.NEGATIVE_INFINITY];
    for (let i = 0; i < nodes; i += 1) {
      const at = 3 * (frame * nodes + i);
      const along = places[at] * axis[0] + places[at + 1] * axis[1] + places[at + 2] * axis[2];
      [least, greatest] = [Math.min(least, along), Math.max(greatest, along)];
    }
    return greatest - least;
  }) as [number, number, number];
}

/** The value of a history at a moment, between its records; `axis` of vectors. */
export function valueAt({ arrays }: ElementsImpact, group: string, name: string, moment: number, axis = 0): number {
  const times = arrays[`${group}.time`].values;
  const { values, shape } = arrays[`${group}.${name}`];
  const width = shape[1] ?? 1;
  if (!times.length) return Number.NaN;
  let after = 0;
  while (after < times.length - 1 && times[after] < moment) after += 1;
  const before = Math.max(0, after - 1);
  const span = times[after] - times[before];
  const share = span > 0 ? Math.max(0, Math.min(1, (moment - times[before]) / span)) : 0;
  return values[before * width + axis] * (1 - share) + values[after * width + axis] * share;
}

/** The radius of the ball before it is hit [m]: at first touch it stands that far from the face. */
export const radiusOf = ({ arrays }: ElementsImpact): number => arrays["motion.radius"].values[0];
