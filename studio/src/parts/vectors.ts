/** Vectors and rotations in three dimensions, for what is drawn. World axes: x to the target, y up, z to the right. */

export type Vector = readonly [x: number, y: number, z: number];
/** The images of the three axes. */
export type Axes = readonly [Vector, Vector, Vector];

export const plus = (a: Vector, b: Vector): Vector => [a[0] + b[0], a[1] + b[1], a[2] + b[2]];
export const times = (a: Vector, factor: number): Vector => [a[0] * factor, a[1] * factor, a[2] * factor];
export const minus = (a: Vector, b: Vector): Vector => plus(a, times(b, -1));
export const dot = (a: Vector, b: Vector): number => a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
export const size = (a: Vector): number => Math.hypot(...a);
export const unit = (a: Vector): Vector => times(a, 1 / size(a));
export const cross = (a: Vector, b: Vector): Vector => [
  a[1] * b[2] - a[2] * b[1],
  a[2] * b[0] - a[0] * b[2],
  a[0] * b[1] - a[1] * b[0],
];

/** A vector given along axes, in the world. */
export const along = (axes: Axes, [x, y, z]: Vector): Vector =>
  plus(plus(times(axes[0], x), times(axes[1], y)), times(axes[2], z));

/** A vector turned about an axis through the origin by the length of that axis [rad], right-handed. */
export function turned(a: Vector, axis: Vector): Vector {
  const angle = size(axis);
  if (angle === 0) return a;
  const direction = unit(axis);
  const [sin, cos] = [Math.sin(angle), Math.cos(angle)];
  return plus(plus(times(a, cos), times(cross(direction, a), sin)), times(direction, dot(direction, a) * (1 - cos)));
}

export const turnedAxes = (axes: Axes, axis: Vector): Axes => [
  turned(axes[0], axis),
  turned(axes[1], axis),
  turned(axes[2], axis),
];

/** The unit vector at an elevation above the horizontal and an azimuth to the right of the target [rad]. */
export const direction = (elevation: number, azimuth: number): Vector => [
  Math.cos(elevation) * Math.cos(azimuth),
  Math.sin(elevation),
  Math.cos(elevation) * Math.sin(azimuth),
];
