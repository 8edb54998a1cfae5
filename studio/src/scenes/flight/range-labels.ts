/** The names of flights and marks on the range, which do not cover each other from wherever it is seen. */

import type { Group, Line, Object3D, Sprite } from "three";
import { type Box, edgeOf, isApart, type Named, placeLabels } from "../../parts/place-labels";
import type { Stage } from "../../parts/stage";
import { label } from "../../parts/stage-objects";
import type { Vector } from "../../parts/vectors";

/** A name that goes where there is room, and the line from there to what it names. */
export interface FreeLabel {
  sprite: Sprite;
  leader: Line;
  at: Vector;
  /** Places that names had better not cover: those of the flight. */
  path: readonly Vector[];
}

/** Places of a flight that are kept free. */
const KEPT = 12;

/** A name in a colour of the page for the end of a flight; it is hidden where there is no room for it. */
export function freeLabel(stage: Stage, text: string, variable: string, path: readonly Vector[]): FreeLabel {
  const { three, colour } = stage;
  const geometry = new three.BufferGeometry().setFromPoints([new three.Vector3(), new three.Vector3()]);
  const leader = new three.Line(
    geometry,
    new three.LineBasicMaterial({ color: colour(variable), depthTest: false, transparent: true }),
  );
  leader.renderOrder = 1;
  leader.frustumCulled = false;
  const at = path[path.length - 1];
  const every = Math.max(1, Math.floor(path.length / KEPT));
  const kept = path.filter((_, i) => i % every === 0);
  return { sprite: label(stage, text, variable, at, [0.5, 0.5]), leader, at, path: kept };
}

/** Whether an object is a word of the picture. */
const isWord = (object: Object3D): object is Sprite => (object as Sprite).isSprite;

/** Sets all words into the picture, those of earlier groups first, and hides what would cover another. */
export function placeWords(stage: Stage, fixed: readonly Group[], free: readonly FreeLabel[]): void {
  const { three, camera, renderer } = stage;
  const { x: width, y: height } = renderer.getSize(new three.Vector2());
  if (!width || !height) return;
  camera.updateMatrixWorld();
  const seen = 2 * Math.tan((camera.fov * Math.PI) / 360);
  const sizeOf = ({ scale }: Sprite): [number, number] => [(scale.x / seen) * height, (scale.y / seen) * height];
  const project = (at: Vector): [x: number, y: number, depth: number] => {
    const { x, y, z } = new three.Vector3(...at).project(camera);
    return [((x + 1) / 2) * width, ((1 - y) / 2) * height, z];
  };
  const movable = new Set(free.map(({ sprite }) => sprite));
  const taken: Box[] = [];
  for (const group of fixed)
    for (const word of group.children) {
      if (!isWord(word) || movable.has(word)) continue;
      const [x, y, depth] = project(word.position.toArray());
      const [wide, high] = sizeOf(word);
      const anchor: [number, number] = word.userData.anchor ?? word.center.toArray();
      word.userData.anchor = anchor;
      const left = x - anchor[0] * wide;
      // A word of the edge that would leave the picture is shifted into it.
      const shift = Math.max(0, -left) - Math.max(0, left + wide - width);
      const isNear = Math.abs(shift) < wide;
      word.center.set(anchor[0] - (isNear ? shift / wide : 0), anchor[1]);
      const box: Box = { x: left + shift + wide / 2, y: y + (anchor[1] - 0.5) * high, width: wide, height: high };
      word.visible = depth < 1 && isNear && taken.every((each) => isApart(box, each));
      if (word.visible) taken.push(box);
    }
  const named = free.map(({ sprite, at }): Named & { depth: number } => {
    const [x, y, depth] = project(at);
    const [wide, high] = sizeOf(sprite);
    return { at: [x, y], width: wide, height: high, depth };
  });
  const places = free.flatMap(({ path }) => path.map((each) => project(each)).map(([x, y]) => [x, y] as const));
  placeLabels(named, { width, height }, { taken, places }).forEach((box, i) => {
    const { sprite, leader } = free[i];
    const { at, depth } = named[i];
    sprite.visible = box !== null && depth < 1;
    leader.visible = sprite.visible;
    if (!box) return;
    sprite.center.set(0.5 - (box.x - at[0]) / box.width, 0.5 + (box.y - at[1]) / box.height);
    const [toX, toY] = edgeOf(box, at);
    const end = new three.Vector3((2 * toX) / width - 1, 1 - (2 * toY) / height, depth).unproject(camera);
    leader.geometry.setFromPoints([new three.Vector3(...free[i].at), end]);
  });
}
