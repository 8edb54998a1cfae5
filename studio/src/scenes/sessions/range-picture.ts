/** Shots on a range, from the side and from above, one colour a club. */

import { html, nothing, svg, type TemplateResult } from "lit-html";
import type { Context } from "../../context";
import { clubName } from "../../equipment/names";
import { line, type Scale, scale, ticks } from "../../parts/axes";
import { type SeriesLook, seriesLine, seriesLook } from "../../parts/colours";
import { GROUND_BOTTOM, GROUND_LEFT, groundGrid } from "../../parts/ground-grid";
import { letterZoom, USUAL_WIDTH } from "../../parts/measure";
import { clubsOf, landing, type ShotRow } from "./shot-rows";

const RIGHT = 16;
const TOP = 24;
const HEIGHTS = { side: [70, 190], above: [140, 360] } as const;
/** Least distance to either side of the target line, in the unit of the picture. */
const LEAST_SIDE = 12;

interface Range {
  context: Context;
  rows: readonly ShotRow[];
  width: number;
  zoom: number;
  along: Scale;
  alongTicks: number[];
  unit: string;
  convert(metres: number): number;
  series(club: string): SeriesLook;
}

/** `name` is unique among the pictures of a page. */
export function rangePicture(context: Context, name: string, rows: readonly ShotRow[]): TemplateResult {
  const drawn = rows.filter((row) => landing(row) !== null);
  return html`<div data-sized=${name} class="shots-range">
    ${drawn.length ? pictures(context, name, drawn) : html`<p class="remark">No shot has a flight path to draw.</p>`}
  </div>`;
}

function pictures(context: Context, name: string, rows: readonly ShotRow[]): TemplateResult {
  const { model, state, formatter } = context;
  const { unit } = formatter.reading("carry", state.system);
  const convert = (metres: number): number => formatter.units.fromSi(metres, unit);
  const zoom = letterZoom();
  const width = Math.max(260, (model.widths[name] ?? USUAL_WIDTH) / zoom);
  const end = convert(Math.max(...rows.map((row) => landing(row)?.[0] ?? 0), 1)) * 1.06;
  const clubs = clubsOf(rows);
  const range: Range = {
    context,
    rows,
    width,
    zoom,
    along: scale([0, end], [GROUND_LEFT, width - RIGHT]),
    alongTicks: ticks([0, end], Math.max(3, Math.min(10, width / 90))),
    unit: formatter.units.symbol(unit),
    convert,
    series: (club) => seriesLook(clubs.findIndex(([each]) => each === club)),
  };
  return html`
    ${rows.some(({ path }) => path.length) ? fromSide(range) : nothing} ${fromAbove(range)}
    <ul class="legend" aria-label="Clubs of the picture">
      ${clubs.map(
        ([club, shots]) =>
          html`<li><i style=${seriesLine(range.series(club))}></i>${clubName(context, club) || "shots"}, ${shots}</li>`,
      )}
    </ul>
  `;
}

function fromSide(range: Range): TemplateResult {
  const { context, rows, width, zoom, along, alongTicks, convert } = range;
  const highest = convert(Math.max(1, ...rows.flatMap(({ path }) => path.map(([, high]) => high))));
  const inner = Math.min(HEIGHTS.side[1], Math.max(HEIGHTS.side[0], highest * along.size));
  const up = scale([0, highest], [TOP + inner, TOP]);
  const ratio = up.size / along.size;
  const apexes = rows.map(({ path }) => Math.max(0, ...path.map(([, high]) => high)));
  const { unit } = range;
  const apex = context.formatter.text("apex", Math.max(...apexes), context.state.system);
  return html`
    <svg
      class="view"
      role="img"
      aria-label=${`${rows.length} shots from the side; the highest rises to ${apex}.`}
      width=${width * zoom}
      height=${(TOP + inner + 12) * zoom}
      viewBox=${`0 0 ${width} ${TOP + inner + 12}`}
    >
      <text class="title" x="0" y="13">From the side, heights in ${unit}${ratio > 1.05 ? `, ×${ratio.toFixed(1)}` : ""}</text>
      ${alongTicks.map((tick) => svg`<line class="grid" x1=${along.at(tick)} x2=${along.at(tick)} y1=${TOP} y2=${TOP + inner}></line>`)}
      ${ticks([0, highest], 3).map(
        (tick) => svg`<text class="tick" x=${GROUND_LEFT - 6} y=${up.at(tick) + 4} text-anchor="end">${tick}</text>`,
      )}
      <line class="ground" x1=${GROUND_LEFT} x2=${width} y1=${TOP + inner} y2=${TOP + inner}></line>
      ${rows.map(({ path, ...row }) =>
        flightPath(
          range,
          row,
          path.map(([x, y]) => [along.at(convert(x)), up.at(convert(y))]),
        ),
      )}
    </svg>
  `;
}

function fromAbove(range: Range): TemplateResult {
  const { context, rows, width, zoom, along, convert } = range;
  const { state, formatter } = context;
  const sides = rows.flatMap((row) => [landing(row)?.[1] ?? 0, ...row.path.map(([, , right]) => right)]).map(convert);
  const [least, most] = [Math.min(-LEAST_SIDE, ...sides) * 1.1, Math.max(LEAST_SIDE, ...sides) * 1.1];
  const inner = Math.min(HEIGHTS.above[1], Math.max(HEIGHTS.above[0], (most - least) * along.size));
  const height = TOP + inner + GROUND_BOTTOM;
  const right = scale([least, most], [TOP, TOP + inner]);
  const ratio = right.size / along.size;
  const landings = rows.flatMap((row) => [landing(row) ?? []].filter((each) => each.length) as [number, number][]);
  const text = (name: string, value: number): string => formatter.text(name, value, state.system);
  const label =
    `${rows.length} shots from above: they land after ${text("carry", Math.min(...landings.map(([x, z]) => Math.hypot(x, z))))} ` +
    `to ${text("carry", Math.max(...landings.map(([x, z]) => Math.hypot(x, z))))}, ` +
    `from ${text("side", Math.min(...landings.map(([, z]) => z)))} to ${text("side", Math.max(...landings.map(([, z]) => z)))}.`;
  return html`
    <svg class="view" role="img" aria-label=${label} width=${width * zoom} height=${height * zoom} viewBox=${`0 0 ${width} ${height}`}>
      <text class="title" x="0" y="13">From above${ratio > 1.05 ? `, sideways ×${ratio.toFixed(1)}` : ""}</text>
      ${groundGrid(formatter, { ...range, right, across: [least, most], top: TOP, bottom: TOP + inner })}
      ${rows.map(({ path, ...row }) =>
        flightPath(
          range,
          row,
          path.map(([x, , z]) => [along.at(convert(x)), right.at(convert(z))]),
        ),
      )}
      ${rows.map((row) => spot(range, row, right))}
    </svg>
  `;
}

/** Classes of what is drawn of a shot. */
const marks = ({ context, series }: Range, { club, shot, mishit }: Omit<ShotRow, "path">): string =>
  `${series(club).isDashed ? " dashed" : ""}${mishit ? " off" : ""}${context.model.session.marked === shot ? " marked" : ""}`;

/** The colour of the club of a shot, as a style. */
const colour = ({ series }: Range, { club }: Omit<ShotRow, "path">): string =>
  `--series: var(--series-${series(club).number})`;

const flightPath = (range: Range, row: Omit<ShotRow, "path">, points: [number, number][]): TemplateResult =>
  svg`<path class=${`flight-path${marks(range, row)}`} style=${colour(range, row)} d=${line(points)}></path>` as TemplateResult;

function spot(range: Range, row: ShotRow, right: Scale): TemplateResult {
  const [x, z] = landing(row) ?? [0, 0];
  const isMarked = range.context.model.session.marked === row.shot;
  return svg`<circle class=${`spot${marks(range, row)}`} style=${colour(range, row)} data-shot=${row.shot} cx=${range.along.at(range.convert(x))}
    cy=${right.at(range.convert(z))} r=${isMarked ? 6 : 3.5}><title>${clubName(range.context, row.club)} ${row.shot}</title></circle>` as TemplateResult;
}
