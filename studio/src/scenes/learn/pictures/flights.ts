/** Several flights over one another, from above or from the side. */

import { html, svg, type TemplateResult } from "lit-html";
import { line, scale, ticks } from "../../../parts/axes";
import { GROUND_BOTTOM, GROUND_LEFT, type Ground, groundGrid } from "../../../parts/ground-grid";
import { letterZoom } from "../../../parts/measure";
import type { LessonResult } from "../lesson";

export interface DrawnFlight {
  /** Class of its line. */
  kind: string;
  label: string;
  /** Name of its case. */
  case: string;
}

const [RIGHT, TOP] = [16, 10];
const LEAST_SIDE = 12;
const [LEAST_HEIGHT, MOST_HEIGHT] = [110, 260];

/** From above: the target is on the right, and what lies right of it is below. */
export function flightsPicture(result: LessonResult, name: string, flights: DrawnFlight[]): TemplateResult {
  const { formatter, state, model } = result.context;
  const { unit } = formatter.reading("carry", state.system);
  const convert = (metres: number): number => formatter.units.fromSi(metres, unit);
  const paths = flights.map((flight) => {
    const { path } = result.case(flight.case);
    const points = Array.from({ length: path.length / 3 }, (_, i) => [convert(path[3 * i]), convert(path[3 * i + 2])]);
    return points as [number, number][];
  });
  const zoom = letterZoom();
  const width = Math.max(260, (model.widths[`flights-${name}`] ?? 480) / zoom);
  const reach = Math.max(1, ...paths.flat().map(([along]) => along)) * 1.04;
  const sideways = paths.flat().map(([, right]) => right);
  const [least, most] = [Math.min(-LEAST_SIDE, ...sideways) * 1.1, Math.max(LEAST_SIDE, ...sideways) * 1.1];
  const along = scale([0, reach], [GROUND_LEFT, width - RIGHT]);
  const inner = Math.min(MOST_HEIGHT, Math.max(LEAST_HEIGHT, (most - least) * along.size * 2));
  const right = scale([least, most], [TOP, TOP + inner]);
  const ratio = right.size / along.size;
  const height = TOP + inner + GROUND_BOTTOM;
  const ground: Ground = {
    along,
    right,
    alongTicks: ticks([0, reach], Math.max(3, width / 110)),
    across: [least, most],
    width,
    top: TOP,
    bottom: TOP + inner,
    unit: formatter.units.symbol(unit),
  };
  const words = flights.map((flight) => ({
    ...flight,
    text:
      `${flight.label}: starts ${result.text("azimuth", result.value(flight.case, "azimuth"))}, ` +
      `lands ${result.text("side", result.value(flight.case, "side"))}`,
  }));
  return html`
    <figure>
      <figcaption>Flight from above${ratio > 1.05 ? `, sideways ×${ratio.toFixed(1)}` : ""}</figcaption>
      <div data-sized=${`flights-${name}`}>
        <svg
          class="view"
          role="img"
          aria-label=${`Flight from above. ${words.map(({ text }) => text).join("; ")}.`}
          width=${width * zoom}
          height=${height * zoom}
          viewBox=${`0 0 ${width} ${height}`}
        >
          ${groundGrid(formatter, ground)}
          ${flights.map(
            ({ kind }, i) =>
              svg`<path class=${`ball-path ${kind}`} d=${line(paths[i].map(([x, z]) => [along.at(x), right.at(z)]))}></path>`,
          )}
        </svg>
      </div>
      <ul class="legend">
        ${words.map(({ kind, text }) => html`<li><i class=${`ball-path ${kind}`}></i>${text}</li>`)}
      </ul>
    </figure>
  `;
}
