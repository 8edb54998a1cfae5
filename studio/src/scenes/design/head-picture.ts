/** The head to scale: from the side, from above and its face from behind, with CG, sweet spot line, bulge and roll. */

import { html, nothing, svg, type TemplateResult } from "lit-html";
import type { Context } from "../../context";
import type { Values } from "../../core/types";
import { handSign } from "../../equipment/equipment";
import { line } from "../../parts/axes";
import { changedNames, clubOf, designedValue, ownValue, spaceOf } from "./designed";
import { cgInFace, inClub, onFace, sweetSpot } from "./geometry";
import { VARIABLES } from "./settings";

const MILLIMETRE = 1e-3;
const MARGIN = 8;
/** Pieces of a curve, and how far the sweet spot line goes on in front of the face [mm]. */
const PIECES = 24;
const AHEAD = 18;

type Point = [number, number];

/** A view: where points of the club stand on the page [mm], and the part of the page that is shown. */
interface View {
  title: string;
  at(point: readonly [number, number, number]): Point;
  box: { x: number; y: number; width: number; height: number };
}

export function headPicture(context: Context): TemplateResult {
  const values = (source: (context: Context, name: string) => number): Values =>
    Object.fromEntries(VARIABLES.map(({ name }) => [name, source(context, name)]));
  const [designed, own] = [values(designedValue), values(ownValue)];
  const isChanged = changedNames(context).length > 0;
  const side = handSign(context.state);
  const { centre, size } = spaceOf(context);
  const ends = (axis: number): Point => [centre[axis] - size[axis] / 2, centre[axis] + size[axis] / 2];
  const frame = (across: Point, upwards: Point): View["box"] => {
    const [x, y] = [across[0] / MILLIMETRE - MARGIN, upwards[0] / MILLIMETRE - MARGIN];
    const more = 2 * MARGIN;
    return {
      x,
      y,
      width: (across[1] - across[0]) / MILLIMETRE + more,
      height: (upwards[1] - upwards[0]) / MILLIMETRE + more,
    };
  };
  const turned = ([least, most]: Point): Point => [-most, -least];
  const ahead = AHEAD * MILLIMETRE;
  const [x, y, z] = [ends(0), ends(1), side > 0 ? ends(2) : turned(ends(2))];
  const views: View[] = [
    {
      title: "From the side, target on the right",
      at: ([along, high]) => [along / MILLIMETRE, -high / MILLIMETRE],
      box: frame([x[0], Math.max(x[1], 0) + ahead], turned(y)),
    },
    {
      title: "From above, target at the top",
      at: ([along, , toe]) => [(side * toe) / MILLIMETRE, -along / MILLIMETRE],
      box: frame(z, turned([x[0], Math.max(x[1], 0) + ahead])),
    },
  ];
  const [, up] = cgInFace(designed);
  const { formatter, state } = context;
  const text = (si: number): string => formatter.text("face_height", Math.abs(si), state.system);
  const spot = sweetSpot(designed);
  const words =
    `Square to the face, the CG lies ${text(-cgInFace(designed)[0])} behind it and ${text(up)} ${up < 0 ? "below" : "above"} the normal ` +
    `through its centre. The sweet spot, where the normal of the face passes through the CG, is ${text(spot[1])} ` +
    `${spot[1] < 0 ? "below" : "above"} the centre and ${text(spot[2])} towards the ${spot[2] < 0 ? "heel" : "toe"}.`;
  return html`
    <section aria-labelledby="head">
      <h2 id="head">The head, to scale</h2>
      <div class="head-views">
        ${views.map((view, i) => viewOf(context, view, i === 0, { designed, own: isChanged ? own : null }, words))}
        ${faceView(context, { designed, own: isChanged ? own : null }, words)}
      </div>
      <p data-sweet-spot>${words}</p>
      <ul class="legend">
        <li><i class="mark cg">⊕</i>CG</li>
        <li><i class="sweet"></i>sweet spot line</li>
        <li><i class="blade"></i>face, with its curve</li>
        <li><i class="space"></i>space for mass, ${clubOf(context).space.origin.split(":")[0]}</li>
        ${isChanged ? html`<li><i class="before"></i>the club's own</li>` : nothing}
      </ul>
    </section>
  `;
}

interface Both {
  designed: Values;
  own: Values | null;
}

function viewOf(
  context: Context,
  { title, at, box }: View,
  isSide: boolean,
  { designed, own }: Both,
  words: string,
): TemplateResult {
  const { centre, size } = spaceOf(context);
  const corner = (signs: readonly [number, number, number]): Point =>
    at([0, 1, 2].map((axis) => centre[axis] + (signs[axis] * size[axis]) / 2) as [number, number, number]);
  const [one, other] = [corner([-1, -1, -1]), corner([1, 1, 1])];
  const [x, y] = [Math.min(one[0], other[0]), Math.min(one[1], other[1])];
  const [width, height] = [Math.abs(one[0] - other[0]), Math.abs(one[1] - other[1])];
  const head = (values: Values, kind: string): TemplateResult => {
    const half = (isSide ? values.face_height : values.face_width) / 2;
    const face = Array.from({ length: PIECES + 1 }, (_, i) => {
      const there = half * ((2 * i) / PIECES - 1);
      return at(inClub(isSide ? onFace(there, 0, values) : onFace(0, there, values), values.static_loft));
    });
    const [cg, spot] = [cgInFace(values), sweetSpot(values)];
    const length = Math.hypot(spot[0] - cg[0], spot[1] - cg[1], spot[2] - cg[2]);
    const beyond = 1 + (AHEAD * MILLIMETRE) / length;
    const tip = cg.map((from, i) => from + beyond * (spot[i] - from)) as [number, number, number];
    const [start, end] = [cg, tip].map((point) => at(inClub(point, values.static_loft)));
    return svg`<g class=${kind}>
      <path class="blade" d=${line(face)}></path>
      <path class="sweet" d=${line([start, end])}></path>
      ${cgMark(start)}
    </g>` as TemplateResult;
  };
  return html`<figure style=${`--mm: ${box.width.toFixed(1)}`}>
    <figcaption>${title}</figcaption>
    <svg viewBox=${`${box.x} ${box.y} ${box.width} ${box.height}`} role="img" aria-label=${`${title}. ${words}`}>
      <rect class="space" x=${x} y=${y} width=${width} height=${height}></rect>
      <rect class="body" x=${x} y=${y} width=${width} height=${height} rx=${0.42 * width} ry=${0.42 * height}></rect>
      ${own ? head(own, "before") : nothing} ${head(designed, "after")}
    </svg>
  </figure>`;
}

const cgMark = ([x, y]: Point): TemplateResult =>
  svg`<circle class="cg" cx=${x} cy=${y} r="2.6"></circle><path class="cg-cross" d=${`M${x - 2.6} ${y}h5.2M${x} ${y - 2.6}v5.2`}></path>` as TemplateResult;

/** The face from behind, as the impact point is set: the toe of a right-handed club is on the right. */
function faceView(context: Context, { designed, own }: Both, words: string): TemplateResult {
  const club = clubOf(context);
  const side = handSign(context.state);
  const [wide, high] = [club.columns.face_width ?? 1, club.columns.face_height ?? 1];
  const at = (up: number, toe: number): Point => [(side * toe) / MILLIMETRE, -up / MILLIMETRE];
  const face = (values: Values, kind: string): TemplateResult => {
    const [across, upwards] = [values.face_width / wide, values.face_height / high];
    const corners = club.outline.map(([toe, up]) => at(up * upwards, toe * across).join(",")).join(" ");
    const [, up, toe] = cgInFace(values);
    const spot = sweetSpot(values);
    const [x, y] = at(spot[1], spot[2]);
    return svg`<g class=${kind}>
      <polygon class="outline" points=${corners}></polygon>
      ${cgMark(at(up, toe))}
      <path class="spot" d=${`M${x - 3} ${y - 3}l6 6M${x - 3} ${y + 3}l6 -6`}></path>
    </g>` as TemplateResult;
  };
  const half = [Math.max(wide, designed.face_width), Math.max(high, designed.face_height)].map(
    (size) => size / 2 / MILLIMETRE + MARGIN,
  );
  return html`<figure style=${`--mm: ${(2 * half[0]).toFixed(1)}`}>
    <figcaption>The face from behind: CG (⊕) and sweet spot (×)</figcaption>
    <svg
      viewBox=${`${-half[0]} ${-half[1]} ${2 * half[0]} ${2 * half[1]}`}
      role="img"
      aria-label=${`The face from behind, ${context.formatter.text("face_width", designed.face_width, context.state.system)} wide. ${words}`}
    >
      ${own ? face(own, "before") : nothing} ${face(designed, "after")}
      <path class="centre" d="M-1.5 0h3M0 -1.5v3"></path>
    </svg>
  </figure>`;
}
