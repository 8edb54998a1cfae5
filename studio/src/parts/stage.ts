/** A picture in three dimensions on a canvas that the page keeps; three.js is loaded when the first one is shown. */

import { html, type TemplateResult } from "lit-html";
import type { Color, PerspectiveCamera, Scene, WebGLRenderer } from "three";
import type { OrbitControls } from "three/addons/controls/OrbitControls.js";
import { colourReader } from "./page-colours";

export type Three = typeof import("./three");

/** Axes of the world: x to the target, y up, z to the right [m]. */
export interface Stage {
  three: Three;
  scene: Scene;
  camera: PerspectiveCamera;
  renderer: WebGLRenderer;
  controls: OrbitControls;
  /** A colour of the page, such as `--ink`. */
  colour(variable: string): Color;
  /** Draws what has been changed with the next frame. */
  redraw(): void;
  /** Takes the size of its frame, if that is another now. */
  fit(): void;
}

interface Kept {
  frame: HTMLElement;
  stage: Promise<Stage>;
  /** What it was last set from, and the latest way of setting it. */
  inputs: readonly unknown[];
  end(): void;
}

const kept = new Map<string, Kept>();

/** A place for a picture; `label` says what it shows, for who does not see it. */
export const stageFrame = (name: string, label: string): TemplateResult => html`
  <div class="stage" data-stage=${name} role="img" aria-label=${label}></div>
`;

/**
 * Sets the picture of a frame, if it is on the page and `inputs` are not those of the last time. `set` changes the
 * objects of the scene; it is called with `isNew` for a scene that is still empty.
 */
export function setStage(name: string, inputs: readonly unknown[], set: (stage: Stage, isNew: boolean) => void): void {
  const frame = document.querySelector<HTMLElement>(`[data-stage="${name}"]`);
  const before = kept.get(name);
  if (before && before.frame !== frame) {
    before.end();
    kept.delete(name);
  }
  if (!frame) return;
  const old = kept.get(name);
  const all = [...inputs, colourReader(frame)("--ink")];
  if (old?.inputs.length === all.length && old.inputs.every((input, i) => input === all[i])) return;
  const made = old ?? makeStage(frame);
  made.inputs = all;
  if (!old) kept.set(name, made);
  // Without WebGL the frame says so already.
  void made.stage.then(
    (stage) => {
      if (kept.get(name) !== made || made.inputs !== all) return;
      stage.fit();
      set(stage, stage.scene.children.length === 0);
      stage.redraw();
    },
    () => undefined,
  );
}

/** Ends the pictures whose frames are not on the page any more. */
export function endStages(): void {
  for (const [name, { frame, end }] of kept) {
    if (frame.isConnected) continue;
    end();
    kept.delete(name);
  }
}

function makeStage(frame: HTMLElement): Kept {
  let ended = false;
  let finish = (): void => undefined;
  const stage = Promise.all([import("./three"), import("three/addons/controls/OrbitControls.js")]).then(
    ([three, { OrbitControls }]): Stage => {
      const renderer = new three.WebGLRenderer({ antialias: true, alpha: true, preserveDrawingBuffer: true });
      renderer.setPixelRatio(Math.min(devicePixelRatio, 2));
      const { domElement } = renderer;
      domElement.tabIndex = 0;
      domElement.setAttribute("aria-label", "Turn by dragging or the arrow keys, zoom by the wheel or + and -");
      if (!ended) frame.replaceChildren(domElement);
      const scene = new three.Scene();
      const camera = new three.PerspectiveCamera(40, 1, 0.001, 1000);
      const controls = new OrbitControls(camera, domElement);
      let isAsked = false;
      const redraw = (): void => {
        if (isAsked || ended) return;
        isAsked = true;
        requestAnimationFrame(() => {
          isAsked = false;
          renderer.render(scene, camera);
        });
      };
      controls.addEventListener("change", redraw);
      domElement.addEventListener("webglcontextrestored", redraw);
      turnByKeys(domElement, camera, controls, redraw);
      const resize = (): void => {
        const { clientWidth: width, clientHeight: height } = frame;
        const { x, y } = renderer.getSize(new three.Vector2());
        if (!width || !height || (x === width && y === height)) return;
        renderer.setSize(width, height, false);
        camera.aspect = width / height;
        camera.updateProjectionMatrix();
        redraw();
      };
      const sizes = new ResizeObserver(resize);
      sizes.observe(frame);
      resize();
      finish = () => {
        sizes.disconnect();
        controls.dispose();
        renderer.dispose();
        renderer.forceContextLoss();
      };
      if (ended) finish();
      const read = colourReader(frame);
      const colour = (variable: string): Color => new three.Color(read(variable));
      return { three, scene, camera, renderer, controls, colour, redraw, fit: resize };
    },
  );
  stage.catch((error: unknown) => {
    frame.textContent = `This picture needs WebGL: ${error instanceof Error ? error.message : String(error)}`;
  });
  return {
    frame,
    stage,
    inputs: [],
    end: () => {
      ended = true;
      finish();
    },
  };
}

/** Angle of a press of an arrow key [rad], and share of a press of + or -. */
const TURN = 0.1;
const ZOOM = 1.15;

function turnByKeys(canvas: HTMLElement, camera: PerspectiveCamera, controls: OrbitControls, redraw: () => void): void {
  canvas.addEventListener("keydown", (event) => {
    const offset = camera.position.clone().sub(controls.target);
    const turns: Record<string, () => void> = {
      ArrowLeft: () => offset.applyAxisAngle(camera.up, -TURN),
      ArrowRight: () => offset.applyAxisAngle(camera.up, TURN),
      ArrowUp: () => tilt(-TURN),
      ArrowDown: () => tilt(TURN),
      "+": () => offset.divideScalar(ZOOM),
      "-": () => offset.multiplyScalar(ZOOM),
    };
    const tilt = (angle: number): void => {
      const axis = camera.up.clone().cross(offset).normalize();
      const steep = offset.angleTo(camera.up) + angle;
      if (steep > TURN && steep < Math.PI - TURN) offset.applyAxisAngle(axis, angle);
    };
    const turn = turns[event.key];
    if (!turn) return;
    event.preventDefault();
    turn();
    camera.position.copy(controls.target).add(offset);
    controls.update();
    redraw();
  });
}
