/** The deformed ball on the face in three dimensions: objects of the scene, made of an impact and set to a moment. */

import type { BufferAttribute, BufferGeometry, Group, Matrix4, Plane } from "three";
import type { ElementsImpact } from "../../core/elements";
import type { ColourScale } from "../../parts/colours";
import type { Stage } from "../../parts/stage";
import { displacements, radiusOf, speeds, valueAt } from "./shape-fields";

export interface Look {
  cut: string;
  colour: string;
  scale: ColourScale;
  /** Corners of a rigid face from the point where it is struck: towards the toe and up the face [m]. */
  outline: readonly (readonly [number, number])[];
}

/** Quadrilaterals with corners of their own, so that each can have its colour. */
interface Patchwork {
  geometry: BufferGeometry;
  corners: Uint32Array;
  pieces: Uint8Array | null;
}

interface Ball {
  impact: ElementsImpact;
  cut: string;
  patchworks: Patchwork[];
  face: Patchwork | null;
  plate: Group | null;
  /** The plane that cuts the face where the ball is cut. */
  plane: Plane;
}

/** Outlines of elements, dark on every colour of a scale. */
const EDGE = "#111";
/** Distance of the camera in radii of the ball, and whence it looks: along the face, from a little above and in front. */
const DISTANCE = 4.3;
const FROM = [0.4, 0.22, 1] as const;
/** Thickness with which a rigid face is drawn [m]. */
const PLATE = 2.5e-3;

export function setBall(stage: Stage, impact: ElementsImpact, frame: number, look: Look, isNew: boolean): void {
  const { scene } = stage;
  if (isNew) lookAt(stage, impact);
  const before = scene.userData.ball as Ball | undefined;
  const isSame = before?.impact === impact && before.cut === look.cut && scene.userData.outline === look.outline;
  const ball = isSame && before ? before : makeBall(stage, impact, look);
  scene.userData.ball = ball;
  scene.userData.outline = look.outline;
  const values =
    look.colour === "speed"
      ? speeds(impact, frame)
      : look.colour === "displacement"
        ? displacements(impact, frame)
        : null;
  for (const each of ball.patchworks) {
    place(each, impact.places, impact.nodes, frame);
    colour(stage, each, values, look.scale);
  }
  if (ball.face && impact.face) place(ball.face, impact.face.places, impact.face.nodes, frame);
  if (ball.plate) ball.plate.matrix.copy(plateMatrix(stage, impact, frame));
  const [x, y, z] = impact.centres.subarray(3 * frame, 3 * frame + 3);
  ball.plane.constant = -ball.plane.normal.dot({ x, y, z });
}

function lookAt({ camera, controls }: Stage, impact: ElementsImpact): void {
  const [x, y, z] = impact.centres;
  const radius = radiusOf(impact);
  controls.target.set(x - 0.15 * radius, y, z);
  const length = Math.hypot(...FROM);
  camera.position.copy(controls.target);
  camera.position.x += (DISTANCE * radius * FROM[0]) / length;
  camera.position.y += (DISTANCE * radius * FROM[1]) / length;
  camera.position.z += (DISTANCE * radius * FROM[2]) / length;
  camera.near = 0.1 * radius;
  camera.far = 100 * radius;
  camera.updateProjectionMatrix();
  controls.update();
}

function makeBall(stage: Stage, impact: ElementsImpact, look: Look): Ball {
  const { scene, three } = stage;
  clear(stage);
  const { surface, section, half } = impact;
  const patchworks: Patchwork[] = [];
  if (look.cut === "half") {
    // The half that is farther from the camera, which looks from the right.
    const isHeel = impact.axes[2][2] > 0;
    const [from, to] = isHeel ? [0, half] : [half, surface.pieces.length];
    patchworks.push(patchwork(stage, surface.corners.subarray(4 * from, 4 * to), surface.pieces.subarray(from, to)));
    patchworks.push(patchwork(stage, section.corners, section.pieces));
  } else patchworks.push(patchwork(stage, surface.corners, surface.pieces));
  for (const { geometry } of patchworks) addTo(stage, geometry, { vertexColors: true }, 0.45);
  const isHeelFar = impact.axes[2][2] > 0;
  const plane = new three.Plane(new three.Vector3(...impact.axes[2]).multiplyScalar(isHeelFar ? -1 : 1), 0);
  stage.renderer.localClippingEnabled = true;
  const cut = { clippingPlanes: look.cut === "half" ? [plane] : [], color: stage.colour("--faint") };
  let [face, plate]: [Patchwork | null, Group | null] = [null, null];
  if (impact.face) {
    face = patchwork(stage, impact.face.corners, null);
    addTo(stage, face.geometry, look.cut === "half" ? cut : { ...cut, transparent: true, opacity: 0.35 }, 0.3);
  } else {
    plate = new three.Group();
    plate.matrixAutoUpdate = false;
    const corners = look.cut === "half" ? heelPart(look.outline, isHeelFar ? 1 : -1) : look.outline;
    const shape = new three.Shape(corners.map(([toe, up]) => new three.Vector2(toe, up)));
    const geometry = new three.ExtrudeGeometry(shape, { depth: PLATE, bevelEnabled: false }).translate(0, 0, -PLATE);
    const isCut = look.cut === "half";
    const material = { transparent: !isCut, opacity: isCut ? 1 : 0.35, depthWrite: isCut, side: three.DoubleSide };
    plate.add(new three.Mesh(geometry, new three.MeshBasicMaterial({ color: cut.color, ...material })));
    if (!isCut) {
      const edge = new three.BufferGeometry().setFromPoints(shape.getPoints());
      plate.add(new three.LineLoop(edge, new three.LineBasicMaterial({ color: stage.colour("--ink") })));
    }
    scene.add(plate);
  }
  return { impact, cut: look.cut, patchworks, face, plate, plane };
}

/** What lies towards the heel of an outline, or towards the toe for a sign of -1. */
function heelPart(outline: Look["outline"], sign: number): [number, number][] {
  return outline.flatMap(([toe, up], i) => {
    const [next, nextUp] = outline[(i + 1) % outline.length];
    const kept: [number, number][] = sign * toe <= 0 ? [[toe, up]] : [];
    const share = toe / (toe - next);
    if (toe * next < 0) kept.push([0, up + share * (nextUp - up)]);
    return kept;
  });
}

function clear({ scene }: Stage): void {
  scene.traverse((object) => {
    const { geometry, material } = object as { geometry?: BufferGeometry; material?: { dispose(): void } };
    geometry?.dispose();
    material?.dispose();
  });
  scene.clear();
}

function patchwork({ three }: Stage, corners: Uint32Array, pieces: Uint8Array | null): Patchwork {
  const geometry = new three.BufferGeometry();
  const attribute = (): BufferAttribute => new three.BufferAttribute(new Float32Array(3 * corners.length), 3);
  geometry.setAttribute("position", attribute());
  geometry.setAttribute("color", attribute());
  const quads = corners.length / 4;
  const triangles = new Uint32Array(6 * quads);
  for (let quad = 0; quad < quads; quad += 1)
    triangles.set(
      [0, 1, 2, 0, 2, 3].map((corner) => 4 * quad + corner),
      6 * quad,
    );
  geometry.setIndex(new three.BufferAttribute(triangles, 1));
  return { geometry, corners, pieces };
}

interface Paint {
  clippingPlanes?: Plane[];
  vertexColors?: boolean;
  color?: import("three").Color;
  transparent?: boolean;
  opacity?: number;
}

/** Adds quadrilaterals and the outlines of all of them. */
function addTo({ scene, three }: Stage, geometry: BufferGeometry, paint: Paint, strength: number): void {
  const { clippingPlanes = [] } = paint;
  const behind = { polygonOffset: true, polygonOffsetFactor: 1, polygonOffsetUnits: 1, side: three.DoubleSide };
  const mesh = new three.Mesh(geometry, new three.MeshBasicMaterial({ ...paint, ...behind }));
  mesh.frustumCulled = false;
  const quads = geometry.getAttribute("position").count / 4;
  const ends = new Uint32Array(8 * quads);
  for (let quad = 0; quad < quads; quad += 1)
    ends.set(
      [0, 1, 1, 2, 2, 3, 3, 0].map((corner) => 4 * quad + corner),
      8 * quad,
    );
  const outline = new three.BufferGeometry();
  outline.setAttribute("position", geometry.getAttribute("position"));
  outline.setIndex(new three.BufferAttribute(ends, 1));
  const lines = new three.LineSegments(
    outline,
    new three.LineBasicMaterial({ color: EDGE, transparent: true, opacity: strength, clippingPlanes }),
  );
  lines.frustumCulled = false;
  scene.add(mesh, lines);
}

function place({ geometry, corners }: Patchwork, places: Float32Array, nodes: number, frame: number): void {
  const attribute = geometry.getAttribute("position") as BufferAttribute;
  const first = 3 * frame * nodes;
  corners.forEach((node, corner) => {
    for (let axis = 0; axis < 3; axis += 1) attribute.array[3 * corner + axis] = places[first + 3 * node + axis];
  });
  attribute.needsUpdate = true;
}

const PIECES = ["--series-1", "--series-2", "--series-3", "--series-4", "--series-6"];
export const pieceColour = (piece: number): string => PIECES[piece % PIECES.length];

/** sRGB as it is mixed by the renderer. */
const linear = (channel: number): number => {
  const share = channel / 255;
  return share <= 0.04045 ? share / 12.92 : ((share + 0.055) / 1.055) ** 2.4;
};

function colour(
  stage: Stage,
  { geometry, corners, pieces }: Patchwork,
  values: Float32Array | null,
  scale: ColourScale,
): void {
  const attribute = geometry.getAttribute("color") as BufferAttribute;
  if (values)
    corners.forEach((node, corner) => {
      attribute.array.set(scale.at(values[node]).map(linear), 3 * corner);
    });
  else {
    const colours = PIECES.map((name) => stage.colour(name));
    corners.forEach((_, corner) => {
      const { r, g, b } = colours[(pieces?.[Math.floor(corner / 4)] ?? 0) % PIECES.length];
      attribute.array.set([r, g, b], 3 * corner);
    });
  }
  attribute.needsUpdate = true;
}

/** Where a rigid face stands: through its nearest point to the ball, with the axes of first touch. */
function plateMatrix({ three }: Stage, impact: ElementsImpact, frame: number): Matrix4 {
  const { axes, centres, times } = impact;
  const [normal, up, toe] = axes.map((axis) => new three.Vector3(...axis));
  const centre = new three.Vector3(...centres.subarray(3 * frame, 3 * frame + 3));
  const start = new three.Vector3(...centres.subarray(0, 3));
  const gap = valueAt(impact, "motion", "radius", times[frame]);
  const radius = radiusOf(impact);
  const moved = centre.dot(normal) - gap - (start.dot(normal) - radius);
  const at = start.clone().addScaledVector(normal, moved - radius);
  return new three.Matrix4().makeBasis(toe, up, normal).setPosition(at);
}
