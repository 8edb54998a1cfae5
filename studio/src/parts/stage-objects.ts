/** Objects for pictures in three dimensions: arrows, tubes and words that keep their size on the screen. */

import type { Color, Group, Mesh, Sprite } from "three";
import { rootSize } from "./measure";
import type { Stage, Three } from "./stage";
import { minus, plus, size, times, unit, type Vector } from "./vectors";

/** A tube from one point to another. */
export function tube(three: Three, from: Vector, to: Vector, radius: number, colour: Color): Mesh {
  const way = minus(to, from);
  const mesh = new three.Mesh(
    new three.CylinderGeometry(radius, radius, size(way), 16),
    new three.MeshStandardMaterial({ color: colour, roughness: 0.45, metalness: 0.3 }),
  );
  mesh.position.set(...times(plus(from, to), 0.5));
  mesh.quaternion.setFromUnitVectors(new three.Vector3(0, 1, 0), new three.Vector3(...unit(way)));
  return mesh;
}

/** Lengths of what an arrow is drawn of [m]. */
const HEAD = { length: 16e-3, radius: 5e-3 };

export interface ArrowLook {
  length: number;
  radius: number;
  colour: Color;
  /** Lengths of dashes and gaps by turns; none is a solid line. */
  dashes?: readonly number[];
}

/** An arrow from the origin upwards, which is seen through whatever stands before it. */
export function arrow(three: Three, { length, colour, radius, dashes = [] }: ArrowLook): Group {
  const group = new three.Group();
  const material = new three.MeshBasicMaterial({ color: colour, depthTest: false, transparent: true });
  const piece = (start: number, end: number, bottom: number, top: number): void => {
    const mesh = new three.Mesh(new three.CylinderGeometry(top, bottom, end - start, 12), material);
    mesh.position.y = (start + end) / 2;
    mesh.renderOrder = 1;
    group.add(mesh);
  };
  const neck = length - HEAD.length;
  if (!dashes.length) piece(0, neck, radius, radius);
  for (let at = 0, i = 0; dashes.length && at < neck; i += 1) {
    const next = Math.min(at + dashes[i % dashes.length], neck);
    if (i % 2 === 0) piece(at, next, radius, radius);
    at = next;
  }
  piece(neck, length, HEAD.radius, 0);
  return group;
}

/** Sets an arrow to a point, in a direction. */
export function point(three: Three, group: Group, from: Vector, towards: Vector): void {
  group.position.set(...from);
  group.quaternion.setFromUnitVectors(new three.Vector3(0, 1, 0), new three.Vector3(...unit(towards)));
}

/** Pixels of a canvas for one of the screen. */
const SHARP = 2;

/** Height of the picture on the screen [px]. */
export const heightOf = ({ three, renderer }: Stage): number => renderer.getSize(new three.Vector2()).y || 1;

/** A word, as high as the letters of the page from wherever it is seen. */
export function word(stage: Stage, text: string, ink: Color): Sprite {
  const { three, camera, colour } = stage;
  const letters = 0.85 * rootSize();
  const canvas = document.createElement("canvas");
  const font = `600 ${letters * SHARP}px system-ui, "DejaVu Sans", sans-serif`;
  const measuring = canvas.getContext("2d");
  if (measuring) measuring.font = font;
  const width = (measuring?.measureText(text).width ?? 0) + letters * SHARP;
  const height = 1.5 * letters * SHARP;
  Object.assign(canvas, { width, height });
  const drawing = canvas.getContext("2d");
  if (drawing) {
    drawing.font = font;
    drawing.textAlign = "center";
    drawing.textBaseline = "middle";
    drawing.lineJoin = "round";
    drawing.lineWidth = 0.35 * letters * SHARP;
    drawing.strokeStyle = `#${colour("--card").getHexString()}`;
    drawing.strokeText(text, width / 2, height / 2);
    drawing.fillStyle = `#${ink.getHexString()}`;
    drawing.fillText(text, width / 2, height / 2);
  }
  const map = new three.CanvasTexture(canvas);
  map.colorSpace = three.SRGBColorSpace;
  const sprite = new three.Sprite(
    new three.SpriteMaterial({ map, sizeAttenuation: false, depthTest: false, transparent: true }),
  );
  const seen = 2 * Math.tan((camera.fov * Math.PI) / 360);
  const pixels = heightOf(stage);
  sprite.scale.set((seen * width) / SHARP / pixels, (seen * height) / SHARP / pixels, 1);
  sprite.renderOrder = 2;
  return sprite;
}

/**
 * A word at a place in the scene, in a colour of the page (`variable`). `anchor` is the point of the word that lies on the
 * place: across from 0 at its left end to 1 at its right, upwards from 0 at its lower edge to 1 at its upper.
 */
export function label(
  stage: Stage,
  text: string,
  variable: string,
  at: Vector,
  anchor: readonly [number, number],
): Sprite {
  const sprite = word(stage, text, stage.colour(variable));
  sprite.center.set(...anchor);
  sprite.position.set(...at);
  return sprite;
}

/** Takes all objects out of a group, and frees what they hold on the graphics card. */
export function empty(group: Group): void {
  group.traverse((each) => {
    const { geometry, material } = each as Partial<Mesh> & Partial<Sprite>;
    if (geometry && !(each as Sprite).isSprite) geometry.dispose();
    for (const one of [material ?? []].flat()) {
      (one as Sprite["material"]).map?.dispose();
      one.dispose();
    }
  });
  group.clear();
}
