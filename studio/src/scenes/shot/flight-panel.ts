/** The flight from the side and from above, one below the other over the same distance. */

import { html, nothing, type TemplateResult } from "lit-html";
import type { Context } from "../../context";
import { type Scale, scale, ticks } from "../../parts/axes";
import { GROUND_LEFT } from "../../parts/ground-grid";
import { letterZoom, USUAL_WIDTH } from "../../parts/measure";
import { fromAbove } from "./from-above";
import { fromSide } from "./from-side";

/** What both views draw, in the unit in which people read distances. */
export interface Drawing {
  width: number;
  /** Pixels of the screen for one of the drawing, which grows with the letters of the page. */
  zoom: number;
  /** Distance to the target. */
  along: Scale;
  alongTicks: number[];
  unit: string;
  /** Distance to the target, height and distance to the right of each moment of the flight. */
  path: [along: number, high: number, right: number][];
  landing: [along: number, right: number];
  rest: [along: number, right: number];
}

const RIGHT = 16;

export function flightPanel(context: Context): TemplateResult {
  const drawing = drawn(context);
  return html`
    <section class="flight" aria-labelledby="flight">
      <h2 id="flight">Flight</h2>
      <div data-sized="flight">
        ${drawing ? html`${fromSide(context, drawing)} ${fromAbove(context, drawing)}` : nothing}
      </div>
    </section>
  `;
}

function drawn({ model, state, formatter }: Context): Drawing | null {
  const shot = model.good;
  if (!shot) return null;
  const { unit } = formatter.reading("carry", state.system);
  const convert = (metres: number): number => formatter.units.fromSi(metres, unit);
  const path: Drawing["path"] = [];
  for (let i = 0; i + 2 < shot.path.length; i += 3)
    path.push([convert(shot.path[i]), convert(shot.path[i + 1]), convert(shot.path[i + 2])]);
  const place = (distance: number, side: number): [number, number] => [
    convert(Math.sqrt(Math.max(distance ** 2 - side ** 2, 0))),
    convert(side),
  ];
  const { carry, side, total, total_side } = shot.values;
  const [landing, rest] = [place(carry, side), place(total, total_side)];
  const zoom = letterZoom();
  const width = Math.max(260, (model.widths.flight ?? USUAL_WIDTH) / zoom);
  const end = Math.max(landing[0], rest[0], 1) * 1.06;
  const along = scale([0, end], [GROUND_LEFT, width - RIGHT]);
  const alongTicks = ticks([0, end], Math.max(3, Math.min(10, width / 90)));
  return { width, zoom, along, alongTicks, unit: formatter.units.symbol(unit), path, landing, rest };
}
