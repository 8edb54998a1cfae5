/** Impacts by finite elements: a case, and what the pages show of it. */

import type { LoadedCore } from "clubface-core";
import { outputValues } from "./compute";
import { drawnParts, type Quads } from "./element-shapes";
import type { CoreArray, Simulated, Values } from "./types";

/** A case as the core takes it, and how often to try it. */
export interface ElementsCase {
  described: {
    ball: object;
    face: { plane: { speed: number; angle: number } } | { head: { inputs: number[]; mesh: object | null } };
    friction: number;
    run: Record<string, number | string | boolean | null>;
  };
  /** Time steps over the stable one that are tried in turn while elements fail; null for that of the core. */
  safeties: (number | null)[];
  /** 1 for a right-handed club, -1 for a left-handed one, whose shapes are mirrored. */
  hand: number;
}

export interface ElementsImpact {
  /** The case that this is the impact of, as text. */
  key: string;
  summary: Simulated;
  /** The launch by the names of the outputs; empty where there is none. */
  launch: Values;
  /** Velocity and spin of the ball after a throw at a plane, along the normal, up the face and about the toe direction. */
  thrown: Values;
  /** Histories by name: `contact.normal`, `motion.spin`, `energy.strain`, `patch.up` and others. */
  arrays: Record<string, CoreArray>;
  /** Directions of the normal, up the face and towards the toe in world axes: x to the target, y up, z right. */
  axes: [number, number, number][];
  /** Moments of the shapes [s]. */
  times: Float64Array;
  /** Places of kept nodes of the ball by moment [m], in world axes, seen from the clubhead as it came. */
  places: Float32Array;
  /** Mass centre of the ball by moment [m], likewise. */
  centres: Float32Array;
  /** Velocity of the ball's mass centre that the clubhead's is taken from [m/s]: what rests in the world moves so. */
  drift: [number, number, number];
  nodes: number;
  surface: Quads;
  half: number;
  section: Quads;
  /** The face of a head that deforms: places by moment and its quadrilaterals; null for a rigid one. */
  face: { places: Float32Array; nodes: number; corners: Uint32Array } | null;
}

type Vector = [number, number, number];

export const caseKey = (input: ElementsCase): string => JSON.stringify(input);

export function simulateElements(core: LoadedCore, input: ElementsCase): ElementsImpact {
  const { described, safeties, hand } = input;
  let run = simulate(core, described, safeties[0] ?? null);
  for (const safety of safeties.slice(1)) {
    if (run.text.stopped === null) break;
    run = simulate(core, described, safety);
  }
  const { text: summary, arrays } = run;
  const { frames, frame_times: times, ...histories } = arrays;
  const mesh = core.ballMesh(described.ball).arrays;
  const drawn = drawnParts(mesh.nodes.values, mesh.elements.values, mesh.piece.values);
  const toWorld = (vector: ArrayLike<number>): Vector => {
    const rows = summary.attitude.map((row) => row[0] * vector[0] + row[1] * vector[1] + row[2] * vector[2]);
    return [rows[0], rows[1], hand * rows[2]];
  };
  const axes = summary.axes.map(toWorld);
  const isPlane = "plane" in described.face;
  const along = (values: ArrayLike<number>, at: number): Vector =>
    [0, 1, 2].map((axis) => [0, 1, 2].reduce((sum, i) => sum + values[3 * at + i] * axes[i][axis], 0)) as Vector;
  // The ball rests before it is hit, so that it comes at the head as the head moves.
  const drift: Vector = isPlane ? [0, 0, 0] : along(histories["motion.velocity"].values, 0);
  const count = summary.nodes[1];
  const keep = (nodes: ArrayLike<number>, first: number): Float32Array => {
    const kept = new Float32Array(times.values.length * nodes.length * 3);
    times.values.forEach((time, frame) => {
      for (let i = 0; i < nodes.length; i += 1) {
        const from = 3 * (frame * count + first + nodes[i]);
        const place = toWorld([frames.values[from], frames.values[from + 1], frames.values[from + 2]]);
        for (let axis = 0; axis < 3; axis += 1)
          kept[3 * (frame * nodes.length + i) + axis] = place[axis] + drift[axis] * time;
      }
    });
    return kept;
  };
  const start = meanOf(frames.values, summary.nodes[0]);
  return {
    key: caseKey(input),
    summary,
    launch: launchOf(core, described.face, summary),
    thrown: isPlane ? thrownOf(summary) : {},
    arrays: histories,
    axes,
    times: times.values,
    places: keep(drawn.nodes, 0),
    centres: centresOf(times.values, histories, toWorld(start), along),
    drift,
    nodes: drawn.nodes.length,
    surface: drawn.surface,
    half: drawn.half,
    section: drawn.section,
    face: faceOf(core, described.face, (nodes) => keep(nodes, summary.nodes[0])),
  };
}

const simulate = (
  core: LoadedCore,
  described: ElementsCase["described"],
  safety: number | null,
): ReturnType<LoadedCore["simulate"]> =>
  core.simulate(safety === null ? described : { ...described, run: { ...described.run, safety } });

/** The mean of places of which the first `count` count, the mass centre of a ball before it is hit. */
function meanOf(places: ArrayLike<number>, count: number): Vector {
  const sum: Vector = [0, 0, 0];
  for (let i = 0; i < 3 * count; i += 1) sum[i % 3] += places[i] / count;
  return sum;
}

/** Places of the mass centre, whose velocity relative to the head as it came is recorded. */
function centresOf(
  times: Float64Array,
  histories: Record<string, CoreArray>,
  start: Vector,
  along: (values: ArrayLike<number>, at: number) => Vector,
): Float32Array {
  const { values: moments } = histories["motion.time"];
  const { values: velocity } = histories["motion.velocity"];
  const centres = new Float32Array(3 * times.length);
  let [place, record] = [[...start], 0];
  let before = along(velocity, 0);
  times.forEach((time, frame) => {
    while (record + 1 < moments.length && moments[record + 1] <= time + 1e-12) {
      const next = along(velocity, record + 1);
      const span = moments[record + 1] - moments[record];
      place = place.map((value, axis) => value + 0.5 * (before[axis] + next[axis]) * span);
      [before, record] = [next, record + 1];
    }
    const rest = time - moments[record];
    for (let axis = 0; axis < 3; axis += 1) centres[3 * frame + axis] = place[axis] + before[axis] * rest;
  });
  return centres;
}

function launchOf(core: LoadedCore, face: ElementsCase["described"]["face"], summary: Simulated): Values {
  if (!("head" in face) || !summary.launch || summary.stopped !== null) return {};
  return outputValues(core.description.outputs, summary.launch);
}

export function thrownOf({ axes, ball_velocity, ball_spin }: Simulated): Values {
  const component = (axis: number[], vector: number[]): number =>
    axis.reduce((sum, each, i) => sum + each * vector[i], 0);
  return {
    normal_velocity: component(axes[0], ball_velocity),
    tangential_velocity: component(axes[1], ball_velocity),
    backspin: component(axes[2], ball_spin),
  };
}

function faceOf(
  core: LoadedCore,
  face: ElementsCase["described"]["face"],
  keep: (nodes: ArrayLike<number>) => Float32Array,
): ElementsImpact["face"] {
  if (!("head" in face) || !face.head.mesh) return null;
  const quads = core.headMesh(face.head.mesh).arrays.face.values;
  const nodes = [...new Set(quads)];
  const places = new Map(nodes.map((node, place) => [node, place]));
  const corners = Uint32Array.from(quads, (node) => places.get(node) ?? 0);
  return { places: keep(nodes), nodes: nodes.length, corners };
}
