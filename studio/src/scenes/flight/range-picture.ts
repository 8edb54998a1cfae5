/** The range in three dimensions: turf, flights as tubes, landings as dots and ellipses, the wind as an arrow. */

import type { CatmullRomCurve3, Group, Object3D, TubeGeometry } from "three";
import { type Context, settingSi } from "../../context";
import { type Stage, setStage } from "../../parts/stage";
import { arrow, empty, label, point } from "../../parts/stage-objects";
import type { Vector } from "../../parts/vectors";
import { outputOf } from "../../state/store";
import { takeView } from "./range-camera";
import { type Content, contentOf, type Extent, extentOf, type Flying, outline } from "./range-content";
import { type FreeLabel, freeLabel, placeWords } from "./range-labels";
import { endPlay, type Played } from "./range-play";
import { type View, viewOf } from "./settings";
import { layTurf, type Marks, STEP } from "./turf";

export const RANGE = "range";

/** What the picture was last made of. */
interface Picture {
  turf: Group;
  flying: Group;
  /** Names that go where there is room. */
  free: FreeLabel[];
  /** What the turf was laid for, and the view that was last taken of it. */
  laid: string;
  seen: string;
}

const pictures = new WeakMap<Stage, Picture>();
/** The range that is on the page, for the buttons next to it. */
export let played: Played | null = null;

export function setRange(context: Context): void {
  const { model, state } = context;
  const settings = ["flying", "range_view", "wind", "wind_from"].map((name) => state.settings[name]);
  const results = [model.good, outputOf(model, "bag"), outputOf(model, "dispersion")];
  setStage(RANGE, [...results, ...settings, state.system, state.club, model.widths[RANGE]], (stage, isNew) => {
    const picture = (isNew ? null : pictures.get(stage)) ?? begin(stage);
    draw(context, stage, picture);
  });
}

function begin(stage: Stage): Picture {
  const { three, scene } = stage;
  const sun = new three.DirectionalLight("white", 2.2);
  sun.position.set(-1, 2, 1);
  const [turf, flying] = [new three.Group(), new three.Group()];
  scene.add(new three.HemisphereLight("white", "gray", 1.6), sun, turf, flying);
  const picture: Picture = { turf, flying, free: [], laid: "", seen: "" };
  pictures.set(stage, picture);
  stage.controls.addEventListener("change", () => placeWords(stage, [flying, turf], picture.free));
  return picture;
}

function draw(context: Context, stage: Stage, picture: Picture): void {
  const { formatter, state, model } = context;
  const { unit } = formatter.reading("carry", state.system);
  const marks: Marks = { metres: formatter.units.toSi({ value: 1, unit }), symbol: formatter.units.symbol(unit) };
  const content = contentOf(context);
  const extent = extentOf(content, STEP * marks.metres);
  const view = viewOf(context);
  const isHigh = stage.camera.aspect < 1;
  const ground = JSON.stringify([
    extent,
    marks,
    view,
    isHigh,
    stage.colour("--turf").getHexString(),
    model.widths[RANGE],
  ]);
  if (picture.laid !== ground) {
    empty(picture.turf);
    layTurf(stage, picture.turf, extent, marks, view);
    picture.laid = ground;
  }
  endPlay();
  empty(picture.flying);
  const free = names(stage, content);
  picture.free = free;
  const objects = [
    ...content.flights.flatMap((flight) => tubes(stage, flight, extent)),
    ...free.flatMap(({ sprite, leader }) => [leader, sprite]),
    ...heights(context, stage, content),
    ...landings(stage, content, extent),
    ...wind(context, stage, extent),
  ];
  for (const each of objects) picture.flying.add(each);
  const seen = JSON.stringify([view, extent, stage.camera.aspect]);
  const look = (): void => {
    takeView(stage, view, extent);
    placeWords(stage, [picture.flying, picture.turf], picture.free);
  };
  if (picture.seen !== seen) look();
  else placeWords(stage, [picture.flying, picture.turf], free);
  picture.seen = seen;
  played = { stage, group: picture.flying, flights: content.flights, view, extent, look };
}

/** Thickness of a flight, as a share of the range. */
const THICK = 0.0022;
const SEGMENTS = 96;

/** The flight, its shadow, and the way over the ground from landing to rest. */
function tubes(stage: Stage, flight: Flying, { far }: Extent): Object3D[] {
  const { path, rest, colour: variable, isDashed } = flight;
  if (path.length < 2) return [];
  const { three, colour } = stage;
  const points = path.map((each) => new three.Vector3(...each));
  const ink = colour(variable);
  const curve = new three.CatmullRomCurve3(points);
  const pieces = isDashed ? dashes(stage, curve, far) : [new three.TubeGeometry(curve, SEGMENTS, far * THICK, 8)];
  const flown = pieces.map(
    (piece) => new three.Mesh(piece, new three.MeshStandardMaterial({ color: ink, roughness: 0.6 })),
  );
  const landed = path[path.length - 1];
  const onGround = (places: Vector[], opacity: number): Object3D => {
    const geometry = new three.BufferGeometry().setFromPoints(places.map(([x, , z]) => new three.Vector3(x, 0, z)));
    const material = new three.LineBasicMaterial({ color: ink, transparent: true, opacity, depthWrite: false });
    const line = new three.Line(geometry, material);
    line.renderOrder = -6;
    return line;
  };
  const dot = (place: Vector, size: number): Object3D => {
    const mesh = new three.Mesh(
      new three.SphereGeometry(far * size, 16, 12),
      new three.MeshStandardMaterial({ color: ink, roughness: 0.6 }),
    );
    mesh.position.set(...place);
    return mesh;
  };
  const roll = new three.Mesh(
    new three.TubeGeometry(
      new three.LineCurve3(new three.Vector3(...landed), new three.Vector3(...rest)),
      1,
      far * THICK * 0.6,
      6,
    ),
    new three.MeshStandardMaterial({ color: ink, roughness: 0.9 }),
  );
  return [...flown, roll, onGround(path, 0.45), dot(landed, 0.004), dot(rest, 0.0055)];
}

/** Length of a dash and of the gap after it, as shares of the range. */
const DASH = 0.025;
const GAP = 0.015;

/** The tubes of a dashed flight. */
function dashes({ three }: Stage, curve: CatmullRomCurve3, far: number): TubeGeometry[] {
  const length = curve.getLength() / far;
  const count = Math.max(1, Math.round(length / (DASH + GAP)));
  return Array.from({ length: count }, (_, i) => {
    const part = [0, 0.5, 1].map((share) => curve.getPointAt(Math.min(1, (i * (DASH + GAP) + share * DASH) / length)));
    return new three.TubeGeometry(new three.CatmullRomCurve3(part), 4, far * THICK, 8);
  });
}

function post({ three, colour }: Stage, from: Vector, to: Vector, variable: string): Object3D {
  const geometry = new three.BufferGeometry().setFromPoints([from, to].map((each) => new three.Vector3(...each)));
  return new three.Line(geometry, new three.LineBasicMaterial({ color: colour(variable) }));
}

/** The names of several flights, for their landings. */
const names = (stage: Stage, { flights, landings: dots }: Content): FreeLabel[] =>
  flights.length > 1 && !dots.length
    ? flights
        .filter(({ path }) => path.length > 1)
        .map(({ name, colour, path }) => freeLabel(stage, name, colour, path))
    : [];

/** Which point of the word for the carry lies at the landing: the word is clear of flight and roll. */
function carryAnchor(view: View, path: Vector[]): [across: number, up: number] {
  const isLeft = path[path.length - 1][2] < 0;
  if (view === "behind") return [isLeft ? 1.08 : -0.08, 1.1];
  if (view === "side") return [0.5, 1.7];
  return [0.5, isLeft ? 1.6 : -0.6];
}

/** Apex and carry of a single flight. */
function heights(context: Context, stage: Stage, { flights, landings: dots }: Content): Object3D[] {
  const { formatter, state } = context;
  const [first, ...others] = flights;
  if (!first || first.path.length < 2 || others.length || dots.length) return [];
  const { path, values } = first;
  const text = (name: string, value: number): string => `${name} ${formatter.text(name, value, state.system)}`;
  const apex = path.reduce((highest, each) => (each[1] > highest[1] ? each : highest));
  return [
    post(stage, [apex[0], 0, apex[2]], apex, "--ink"),
    label(stage, text("apex", values.apex), "--ink", apex, [0.5, -0.2]),
    label(stage, text("carry", values.carry), "--ink", path[path.length - 1], carryAnchor(viewOf(context), path)),
  ];
}

function landings(stage: Stage, { landings: places, ellipses }: Content, { far }: Extent): Object3D[] {
  if (!places.length) return [];
  const { three, colour } = stage;
  const dots = new Float32Array((places.length / 2) * 3);
  for (let i = 0; 2 * i + 1 < places.length; i += 1) dots.set([places[2 * i], 0, places[2 * i + 1]], 3 * i);
  const geometry = new three.BufferGeometry().setAttribute("position", new three.BufferAttribute(dots, 3));
  const cloud = new three.Points(
    geometry,
    new three.PointsMaterial({ color: colour("--start"), size: 2.5, sizeAttenuation: false, depthWrite: false }),
  );
  cloud.renderOrder = -5;
  const rings = ellipses.flatMap((ellipse, i) => {
    // At the far end of one and the near end of the next.
    const end = outline(ellipse, 4)[i % 2 ? 2 : 0];
    const curve = new three.CatmullRomCurve3(
      outline(ellipse, 72).map((each) => new three.Vector3(...each)),
      true,
    );
    const ring = new three.Mesh(
      new three.TubeGeometry(curve, 96, far * THICK * 0.7, 6, true),
      new three.MeshBasicMaterial({ color: colour("--path") }),
    );
    return [ring, label(stage, `${Math.round(100 * ellipse.share)}%`, "--path", end, [0.5, 0.5])];
  });
  return [cloud, ...rings];
}

/** The wind as an arrow over the range, near the tee on the right, or from the side in the sky. */
function wind(context: Context, stage: Stage, { far, side, high }: Extent): Object3D[] {
  const speed = settingSi(context, "wind");
  if (!speed) return [];
  const from = settingSi(context, "wind_from");
  const blowing = arrow(stage.three, { length: 0.07, radius: 1.6e-3, colour: stage.colour("--face") });
  const blows: Vector = [-Math.cos(from), 0, -Math.sin(from)];
  const isFromSide = viewOf(context) === "side";
  const middle: Vector = isFromSide ? [far * 0.85, high, 0] : [far * 0.12, far * 0.03, side * 0.45];
  const reach = far * 0.035;
  point(stage.three, blowing, [middle[0] - blows[0] * reach, middle[1], middle[2] - blows[2] * reach], blows);
  blowing.scale.setScalar(far);
  const { formatter, state } = context;
  const text = formatter.text("wind_speed", speed, state.system);
  const behind = reach + far * 0.025;
  const tail: Vector = [middle[0] - blows[0] * behind, middle[1], middle[2] - blows[2] * behind];
  return [blowing, label(stage, `wind ${text}`, "--face", tail, [0.5, 0.5])];
}
