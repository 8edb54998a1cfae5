/** Where the head and the ball are at first touch and around it, by the conventions of clubface, for drawing them. */

import type { Values } from "../../core/types";
import {
  type Axes,
  along,
  direction,
  dot,
  minus,
  plus,
  times,
  turned,
  turnedAxes,
  unit,
  type Vector,
} from "../../parts/vectors";

/** Both bodies at one moment; the origin is the centre of the ball at rest [m]. */
export interface Pose {
  /** Face axes in the world: outward normal at the face centre, up the face, towards the toe. */
  axes: Axes;
  faceCentre: Vector;
  /** Mass centre of the head. */
  cg: Vector;
  /** The point of the face that touches the ball first, and the outward normal there. */
  contact: Vector;
  normal: Vector;
  /** Middle of the ball, which is flattened while it is pressed against the face. */
  ball: Vector;
  /** Axis and angle by which the ball has turned since first touch [rad]. */
  ballTurn: Vector;
  /** Diameter of the ball along the normal over that of the ball at rest. */
  flattened: number;
}

const X: Vector = [1, 0, 0];
const Y: Vector = [0, 1, 0];
const Z: Vector = [0, 0, 1];

/** Curvature of a radius, 0 of an infinite one. */
const curvature = (radius: number): number => (Number.isFinite(radius) ? 1 / radius : 0);

/** How far forward the face lies at offsets towards the toe and up, in the plane tangent to it at its centre [m]. */
export function faceForward({ bulge, roll }: Values, toe: number, high: number): number {
  const [across, up] = [curvature(bulge), curvature(roll)];
  const arc = -(up * high ** 2) / (1 + Math.sqrt(1 - (up * high) ** 2));
  const radial = 1 + across * arc;
  return (2 * arc + across * (arc ** 2 - toe ** 2)) / (1 + Math.sqrt(radial ** 2 - (across * toe) ** 2));
}

/** Outward normal of the face at such offsets, in face axes. */
export function faceNormal({ bulge, roll }: Values, toe: number, high: number): Vector {
  const [across, up] = [curvature(bulge), curvature(roll)];
  const sine = up * high;
  const cosine = Math.sqrt(1 - sine ** 2);
  // Of the arc of the roll at this height, turned about the axis of the bulge.
  const arc = -(up * high ** 2) / (1 + cosine);
  const turn = Math.asin((across * toe) / (1 + across * arc));
  return [cosine * Math.cos(turn), sine, cosine * Math.sin(turn)];
}

/** The face axes of a right-handed head as it is delivered: lie, back to azimuth 0, to the dynamic loft, face angle. */
function delivered({ lie, loft, face, static_loft }: Values): Axes {
  const rest: Axes = [turned(X, times(Z, static_loft)), turned(Y, times(Z, static_loft)), Z];
  const tilted = turnedAxes(rest, times(X, -lie));
  const square = turnedAxes(tilted, times(Y, Math.atan2(tilted[0][2], tilted[0][0])));
  const raised = turnedAxes(square, times(Z, loft - Math.asin(square[0][1])));
  return turnedAxes(raised, times(Y, -face));
}

const mirrored = (a: Vector, hand: number): Vector => [a[0], a[1], a[2] * hand];

/** The pose at first touch of a strike in SI, by the names of the core's inputs. */
export function poseAtImpact(inputs: Values): Pose {
  const { hand, toe, high, ball_radius, static_loft, cg_x, cg_y, cg_z } = inputs;
  const right = delivered({ ...inputs, face: inputs.face * hand });
  const axes: Axes = [mirrored(right[0], hand), mirrored(right[1], hand), mirrored(right[2], hand)];
  const normal = along(axes, faceNormal(inputs, toe, high));
  const contact = times(normal, -ball_radius);
  const faceCentre = minus(contact, along(axes, [faceForward(inputs, toe, high), high, toe]));
  const toFace = turned([cg_x, cg_y, cg_z], times(Z, -static_loft));
  const cg = minus(faceCentre, along(axes, toFace));
  return { axes, normal, contact, faceCentre, cg, ball: [0, 0, 0], ballTurn: [0, 0, 0], flattened: 1 };
}

/** Velocities and angular velocities before and after impact, in the world. */
interface Motion {
  club: Vector;
  turning: Vector;
  clubAfter: Vector;
  turningAfter: Vector;
  ball: Vector;
  spin: Vector;
  /** Time in contact [s], 0 where the model has none. */
  contact: number;
}

function motionOf(inputs: Values, outputs: Values): Motion {
  const vector = (name: string): Vector => [outputs[`${name}_x`], outputs[`${name}_y`], outputs[`${name}_z`]];
  const { speed, attack, path, hand, lie_rate, closure, pitch_rate, contact_time } = { ...inputs, ...outputs };
  return {
    club: times(direction(attack, path), speed),
    turning: [-lie_rate * hand, closure * hand, pitch_rate],
    clubAfter: vector("club_velocity"),
    turningAfter: vector("club_spin"),
    ball: vector("velocity"),
    spin: vector("spin"),
    contact: Number.isFinite(contact_time) ? contact_time : 0,
  };
}

/** How far a body has moved at a time after first touch whose velocity changes smoothly in the time of contact. */
function moved(before: Vector, after: Vector, contact: number, time: number): Vector {
  if (time <= 0) return times(before, time);
  const change = minus(after, before);
  if (time >= contact) return plus(times(before, time), times(change, time - contact / 2));
  const share = time / contact;
  return plus(times(before, time), times(change, (contact / 2) * (share - Math.sin(Math.PI * share) / Math.PI)));
}

/**
 * The pose at a time after first touch, negative before it. Before and after impact both bodies move as computed; in
 * between the drawing goes smoothly from one to the other.
 */
export function poseAt(inputs: Values, outputs: Values, time: number): Pose {
  const first = poseAtImpact(inputs);
  const motion = motionOf(inputs, outputs);
  const { contact } = motion;
  const turn = moved(motion.turning, motion.turningAfter, contact, time);
  const cg = plus(first.cg, moved(motion.club, motion.clubAfter, contact, time));
  const fixed = (point: Vector): Vector => plus(cg, turned(minus(point, first.cg), turn));
  const there = (at: number): Vector => moved([0, 0, 0], motion.ball, contact, at);
  /** Distance of the ball's centre from the face over the radius. */
  const gapAt = (at: number): number => {
    const head = plus(first.cg, moved(motion.club, motion.clubAfter, contact, at));
    const spun = moved(motion.turning, motion.turningAfter, contact, at);
    const face = plus(head, turned(minus(first.contact, first.cg), spun));
    return dot(minus(there(at), face), turned(first.normal, spun)) / inputs.ball_radius;
  };
  // Both paths are smooth but not exact, so that the ball would not just touch when it leaves.
  const remainder = contact > 0 ? 1 - gapAt(contact) : 0;
  const share = contact > 0 ? Math.min(Math.max(time / contact, 0), 1) : 0;
  const gap = time > 0 && time < contact ? gapAt(time) + remainder * share : 1;
  const shift = remainder * share + (1 - gap) / 2;
  const pressed = turned(first.normal, moved(motion.turning, motion.turningAfter, contact, Math.min(time, contact)));
  const ball = time > 0 ? plus(there(time), times(pressed, shift * inputs.ball_radius)) : first.ball;
  return {
    axes: turnedAxes(first.axes, turn),
    faceCentre: fixed(first.faceCentre),
    cg,
    contact: fixed(first.contact),
    normal: turned(first.normal, turn),
    ball,
    ballTurn: time > 0 ? moved([0, 0, 0], motion.spin, contact, time) : [0, 0, 0],
    flattened: Math.min(1, (gap + 1) / 2),
  };
}

/** Elevation above the horizontal and azimuth to the right of the target of a direction [rad]. */
export function anglesOf(vector: Vector): { elevation: number; azimuth: number } {
  const [x, y, z] = unit(vector);
  return { elevation: Math.asin(y), azimuth: Math.atan2(z, x) };
}
