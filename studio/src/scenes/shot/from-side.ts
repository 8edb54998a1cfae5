/** The flight from the side. */

import { html, svg, type TemplateResult } from "lit-html";
import type { Context } from "../../context";
import { line, scale, ticks } from "../../parts/axes";
import { GROUND_LEFT } from "../../parts/ground-grid";
import type { Drawing } from "./flight-panel";

const TOP = 22;
const BOTTOM = 8;
const LEAST_HEIGHT = 70;
const MOST_HEIGHT = 260;

export function fromSide({ model, state, formatter }: Context, drawing: Drawing): TemplateResult {
  const { width, zoom, along, path, landing, rest } = drawing;
  const apex = Math.max(...path.map(([, high]) => high), 1);
  const inner = Math.min(MOST_HEIGHT, Math.max(LEAST_HEIGHT, apex * along.size * 1.08));
  const [ground, height] = [TOP + inner, TOP + inner + BOTTOM];
  const up = scale([0, apex * 1.08], [ground, TOP]);
  const ratio = up.size / along.size;
  const values = model.good?.values ?? {};
  const label = `The flight from the side: apex ${formatter.text("apex", values.apex, state.system)}, landing at ${formatter.text(
    "landing_angle",
    values.landing_angle,
    state.system,
  )}.`;
  return html`
    <svg class="view" role="img" aria-label=${label} width=${width * zoom} height=${height * zoom} viewBox=${`0 0 ${width} ${height}`}>
      <text class="title" x="0" y="13">From the side, apex ${formatter.text("apex", values.apex, state.system)}${ratio > 1.05 ? `, heights ×${ratio.toFixed(1)}` : ""}</text>
      ${ticks([0, apex], 2).map(
        (tick) => svg`
          <line class="grid" x1=${GROUND_LEFT} x2=${width} y1=${up.at(tick)} y2=${up.at(tick)}></line>
          <text class="tick" x=${GROUND_LEFT - 6} y=${up.at(tick) + 4} text-anchor="end">${tick}</text>`,
      )}
      <line class="ground" x1=${GROUND_LEFT} x2=${width} y1=${ground} y2=${ground}></line>
      <path class="ball-path" d=${line(path.map(([x, y]) => [along.at(x), up.at(Math.max(y, 0))]))}></path>
      <path class="roll" d=${line([
        [along.at(landing[0]), ground],
        [along.at(rest[0]), ground],
      ])}></path>
      <circle class="landing" cx=${along.at(landing[0])} cy=${ground} r="4"></circle>
    </svg>
  `;
}
