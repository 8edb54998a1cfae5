/** The flight from above: path, face, start, curve and landing; the target is on the right. */

import { html, type TemplateResult } from "lit-html";
import { type Context, delivered } from "../../context";
import { line, scale } from "../../parts/axes";
import { GROUND_BOTTOM, groundGrid } from "../../parts/ground-grid";
import type { Drawing } from "./flight-panel";

const TOP = 24;
const LEAST_HEIGHT = 120;
const MOST_HEIGHT = 300;
/** Least distance shown to either side of the target line. */
const LEAST_SIDE = 12;
/** How far path and face are drawn, as a share of the carry. */
const REACH = 0.35;

export function fromAbove(context: Context, drawing: Drawing): TemplateResult {
  const { model, state, formatter } = context;
  const { width, zoom, along, path, landing, rest } = drawing;
  const values = model.good?.values ?? {};
  const end = (angle: number, length: number): [number, number] => [length * Math.cos(angle), length * Math.sin(angle)];
  const ends = {
    path: end(delivered(context, "path"), REACH * landing[0]),
    face: end(delivered(context, "face"), REACH * landing[0]),
    start: end(values.azimuth, landing[0]),
  };
  // Where the ball would have come down, level with its landing, if it had not curved.
  const onStart = end(values.azimuth, landing[0] * Math.cos(values.azimuth) + landing[1] * Math.sin(values.azimuth));
  const shown = [
    ...path.map(([, , right]) => right),
    rest[1],
    onStart[1],
    ...Object.values(ends).map(([, right]) => right),
  ];
  const [least, most] = [Math.min(-LEAST_SIDE, ...shown) * 1.1, Math.max(LEAST_SIDE, ...shown) * 1.1];
  const inner = Math.min(MOST_HEIGHT, Math.max(LEAST_HEIGHT, (most - least) * along.size));
  const height = TOP + inner + GROUND_BOTTOM;
  // Right of the target is below, as it is for who looks to the target with the ball on the left.
  const right = scale([least, most], [TOP, TOP + inner]);
  const ratio = right.size / along.size;
  const at = ([x, z]: readonly [number, number]): [number, number] => [along.at(x), right.at(z)];
  const shape = model.good?.shape || "shot that does not fly";
  const label =
    `The flight from above, a ${shape}: the ball starts ${formatter.text("azimuth", values.azimuth, state.system)}, ` +
    `curves ${formatter.text("curve", values.curve, state.system)} and lands ` +
    `${formatter.text("side", values.side, state.system)} after ${formatter.text("carry", values.carry, state.system)}.`;
  return html`
    <svg class="view" role="img" aria-label=${label} width=${width * zoom} height=${height * zoom} viewBox=${`0 0 ${width} ${height}`}>
      <text class="title" x="0" y="13">From above: ${shape}${ratio > 1.05 ? `, sideways ×${ratio.toFixed(1)}` : ""}</text>
      ${groundGrid(formatter, { ...drawing, right, across: [least, most], top: TOP, bottom: TOP + inner })}
      <path class="direction start" d=${line([at([0, 0]), at(ends.start)])}></path>
      <path class="direction path" d=${line([at([0, 0]), at(ends.path)])}></path>
      <path class="direction face-line" d=${line([at([0, 0]), at(ends.face)])}></path>
      <path class="curve" d=${line([at(onStart), at(landing)])}></path>
      <path class="ball-path" d=${line(path.map(([x, , z]) => at([x, z])))}></path>
      <path class="roll" d=${line([at(landing), at(rest)])}></path>
      <circle class="landing" cx=${at(landing)[0]} cy=${at(landing)[1]} r="4"></circle>
      <circle class="rest" cx=${at(rest)[0]} cy=${at(rest)[1]} r="4"></circle>
    </svg>
    <ul class="legend" aria-label="Lines of the view from above">
      <li><i class="ball-path"></i>flight</li>
      <li><i class="direction start"></i>start ${formatter.text("azimuth", values.azimuth, state.system)}</li>
      <li><i class="direction path"></i>path ${formatter.text("path", delivered(context, "path"), state.system)}</li>
      <li><i class="direction face-line"></i>face ${formatter.text("face", delivered(context, "face"), state.system)}</li>
      <li><i class="curve"></i>curve ${formatter.text("curve", values.curve, state.system)}</li>
      <li><i class="roll"></i>bounce and roll</li>
    </ul>
  `;
}
