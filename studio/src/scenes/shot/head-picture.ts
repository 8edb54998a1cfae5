/** Head and ball in three dimensions, with the directions that a coach draws. */

import type { BufferGeometry, Group, Mesh, Object3D, Sprite } from "three";
import type { Values } from "../../core/types";
import type { Stage, Three } from "../../parts/stage";
import { arrow, empty, heightOf, point, tube, word } from "../../parts/stage-objects";
import { direction, plus, times, unit, type Vector } from "../../parts/vectors";
import { faceForward, faceNormal, poseAt } from "./head-pose";
import { headShape, type Surface } from "./head-shape";

/** What the picture is made of. */
export interface Picture {
  club: string;
  kind: string;
  outline: readonly (readonly [number, number])[];
  /** The strike in SI by the names of the core's inputs, and what came of it. */
  inputs: Values;
  outputs: Values;
  /** Time after first touch [s]. */
  moment: number;
  view: string;
}

/** Lengths of arrows [m]. */
const PATH = 0.22;
const BEFORE = 0.12;
const NORMAL = 0.13;
const START = 0.2;
const TARGET = [-0.2, 0.26] as const;
/** How far before the face the mark of the impact point is drawn [m]. */
const MARK_BEFORE = 0.4e-3;
/** Names of the arrows in the picture; the legend of the page says more. */
const NAMES = ["path", "face", "start", "target"] as const;
type Name = (typeof NAMES)[number];

interface Drawn {
  /** What it was built of. */
  key: string;
  view: string;
  built: Group;
  head: Group;
  ball: Object3D;
  spun: Object3D;
  mark: Mesh;
  arrows: Record<Name, Group>;
  words: Record<Name | "toe" | "heel", Sprite>;
}

const drawn = new WeakMap<Stage, Drawn>();

export function drawHead(stage: Stage, picture: Picture): void {
  const { inputs, view } = picture;
  const ink = stage.colour("--ink").getHexString();
  const key = JSON.stringify([picture.club, inputs.ball_radius, ink, heightOf(stage)]);
  const before = drawn.get(stage);
  const current = before?.key === key ? before : build(stage, picture, key, before);
  drawn.set(stage, current);
  if (before?.view !== view) look(stage, picture);
  current.view = view;
  move(stage, current, picture);
}

function build(stage: Stage, picture: Picture, key: string, before: Drawn | undefined): Drawn {
  const { three, scene, colour } = stage;
  const { inputs } = picture;
  if (before) {
    empty(before.built);
    before.built.removeFromParent();
  } else {
    scene.add(new three.HemisphereLight(0xffffff, 0x99a39d, 2.2));
    const sun = new three.DirectionalLight(0xffffff, 2.2);
    sun.position.set(-0.6, 1, 0.5);
    scene.add(sun);
  }
  const built = new three.Group();
  const head = new three.Group();
  head.matrixAutoUpdate = false;
  const shape = headShape(picture.kind, picture.outline, inputs);
  const steel = { roughness: 0.4, metalness: 0.35, side: three.DoubleSide };
  head.add(
    new three.Mesh(geometry(three, shape.body), new three.MeshStandardMaterial({ ...steel, color: colour("--edge") })),
    new three.Mesh(geometry(three, shape.face), new three.MeshStandardMaterial({ ...steel, color: colour("--line") })),
    tube(three, shape.hosel.from, shape.hosel.to, shape.hosel.radius, colour("--edge")),
    tube(three, shape.shaft.from, shape.shaft.to, shape.shaft.radius, colour("--faint")),
  );
  const mark = new three.Mesh(
    new three.TorusGeometry(5e-3, 0.7e-3, 8, 32),
    new three.MeshBasicMaterial({ color: colour("--accent") }),
  );
  head.add(mark);
  const { ball, spun } = ballOf(stage, inputs.ball_radius);
  const solid = { radius: 1.8e-3 };
  const arrows: Record<Name, Group> = {
    path: arrow(three, { ...solid, length: PATH, colour: colour("--path") }),
    face: arrow(three, { ...solid, length: NORMAL, colour: colour("--face"), dashes: [12e-3, 4e-3, 3e-3, 4e-3] }),
    start: arrow(three, { ...solid, length: START, colour: colour("--start"), dashes: [9e-3, 6e-3] }),
    target: arrow(three, {
      radius: 0.8e-3,
      length: TARGET[1] - TARGET[0],
      colour: colour("--edge"),
      dashes: [14e-3, 10e-3],
    }),
  };
  const words = {
    path: word(stage, "path", colour("--path")),
    face: word(stage, "face", colour("--face")),
    start: word(stage, "start", colour("--start")),
    target: word(stage, "target", colour("--faint")),
    toe: word(stage, "toe", colour("--ink")),
    heel: word(stage, "heel", colour("--ink")),
  };
  const low: Vector = [TARGET[0], -inputs.ball_radius, 0];
  point(three, arrows.target, low, [1, 0, 0]);
  words.target.position.set(TARGET[1], -inputs.ball_radius + 8e-3, 0);
  built.add(head, ball, ...Object.values(arrows), ...Object.values(words));
  scene.add(built);
  return { key, view: before?.view ?? "", built, head, ball, spun, mark, arrows, words };
}

function geometry(three: Three, { positions, triangles }: Surface): BufferGeometry {
  const result = new three.BufferGeometry();
  result.setAttribute("position", new three.Float32BufferAttribute(positions, 3));
  result.setIndex(triangles);
  result.computeVertexNormals();
  return result;
}

/** A white ball with a line around it, by which its turning is seen. */
function ballOf({ three }: Stage, radius: number): Pick<Drawn, "ball" | "spun"> {
  const ball = new three.Group();
  const spun = new three.Group();
  spun.add(
    new three.Mesh(
      new three.SphereGeometry(radius, 48, 32),
      new three.MeshStandardMaterial({ color: 0xf4f4ef, roughness: 0.5 }),
    ),
    new three.Mesh(new three.TorusGeometry(radius, 0.6e-3, 8, 64), new three.MeshBasicMaterial({ color: 0x3a4a42 })),
  );
  ball.add(spun);
  return { ball, spun };
}

function move({ three }: Stage, { head, ball, spun, mark, arrows, words }: Drawn, picture: Picture): void {
  const { inputs, outputs, moment } = picture;
  const pose = poseAt(inputs, outputs, moment);
  const vector = (from: Vector): InstanceType<Three["Vector3"]> => new three.Vector3(...from);
  head.matrix
    .makeBasis(vector(pose.axes[0]), vector(pose.axes[1]), vector(pose.axes[2]))
    .setPosition(vector(pose.faceCentre));
  head.matrixWorldNeedsUpdate = true;
  const { toe, high } = inputs;
  mark.position.set(faceForward(inputs, toe, high) + MARK_BEFORE, high, toe);
  mark.quaternion.setFromUnitVectors(vector([0, 0, 1]), vector(faceNormal(inputs, toe, high)));
  // Flattened along the normal, and turned within.
  const along = new three.Quaternion().setFromUnitVectors(vector([1, 0, 0]), vector(pose.normal));
  const spin = vector(pose.ballTurn);
  const angle = spin.length();
  ball.position.set(...pose.ball);
  ball.quaternion.copy(along);
  ball.scale.set(pose.flattened, 1, 1);
  spun.quaternion
    .setFromAxisAngle(angle ? spin.divideScalar(angle) : vector([0, 0, 1]), angle)
    .premultiply(along.clone().invert());
  const path = direction(inputs.attack, inputs.path);
  const start = direction(outputs.launch, outputs.azimuth);
  point(three, arrows.path, plus(pose.cg, times(path, -BEFORE / 4)), path);
  point(three, arrows.face, pose.faceCentre, pose.axes[0]);
  point(three, arrows.start, pose.ball, start);
  const tip = (from: Vector, way: Vector, length: number): Vector => plus(from, times(unit(way), length + 0.012));
  words.path.position.set(...tip(pose.cg, path, PATH - BEFORE / 4));
  words.face.position.set(...tip(pose.faceCentre, pose.axes[0], NORMAL));
  words.start.position.set(...tip(pose.ball, start, START));
  const side = (toe: number): Vector => plus(pose.faceCentre, times(pose.axes[2], toe));
  words.toe.position.set(...side(0.5 * inputs.face_width + 0.012));
  words.heel.position.set(...side(-0.5 * inputs.face_width - 0.012));
}

/** Distance from which the head is seen [m], and the point that is looked at. */
const FAR = 0.46;
const MIDDLE: Vector = [0.04, 0.02, 0];
/** Width over height from which a picture is wide enough. */
const WIDE = 1.7;

/** Turns the camera to the side from which the head is to be seen. */
function look({ camera, controls }: Stage, { view, inputs: { hand } }: Picture): void {
  const from: Record<string, Vector> = {
    corner: [0.3, 0.42, 0.86 * hand],
    above: [-1e-3, 1, 0],
    line: [-1, 0.12, 0],
    face: [0, 0.1, hand],
  };
  // A narrow picture is seen from farther away, so that it holds as much from side to side.
  const far = FAR * Math.max(1, WIDE / camera.aspect);
  controls.target.set(...MIDDLE);
  camera.position.set(...plus(MIDDLE, times(unit(from[view] ?? from["corner"]), far)));
  controls.update();
}
