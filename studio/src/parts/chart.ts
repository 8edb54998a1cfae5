/** Curves, drawn by uPlot on canvases that the page keeps, and the same as a table. */

import { html, nothing, type TemplateResult } from "lit-html";
import uPlot from "uplot";
import "uplot/dist/uPlot.min.css";
import type { Context } from "../context";
import { join } from "../quantities/formatter";
import { seriesLook } from "./colours";
import { rootSize } from "./measure";
import { colourReader } from "./page-colours";

/** One axis of a chart: what it is called, and the quantity that gives unit and digits. */
export interface ChartAxis {
  label: string;
  quantity: string;
}

export interface Chart {
  /** Its name on the page, of which there is one. */
  name: string;
  title: string;
  x: ChartAxis;
  y: ChartAxis;
  /** Places and values in SI; at most seven lines, which differ in colour and dashes. */
  lines: { label: string; x: ArrayLike<number>; y: ArrayLike<number> }[];
  /** A place that is marked by an upright line [SI]. */
  mark?: number;
}

/** Least and greatest height of a chart, in letters of the page, and its height as a share of the width in between. */
const HEIGHTS = [14, 22] as const;
const SHARE = 0.55;
/** Rows that the tables have. */
const ROWS = 11;
const DASHES = [[], [8, 4], [2, 3], [8, 3, 2, 3], [14, 4], [4, 4], [12, 3, 4, 3]];

interface Drawn {
  plot: uPlot;
  /** Where the upright line stands [SI]. */
  mark: { place: number | undefined };
  frame: Element;
  /** What it was drawn from: it is drawn anew where one of them is another. */
  inputs: readonly unknown[];
}

const drawn = new Map<string, Drawn>();
/** The charts of the page that is being made. */
let charts: Chart[] = [];

export function chartFrame(context: Context, chart: Chart): TemplateResult {
  charts.push(chart);
  const { formatter, state } = context;
  const unit = formatter.units.symbol(formatter.reading(chart.y.quantity, state.system).unit);
  return html`
    <figure>
      <figcaption>${chart.title}${unit ? `, ${unit}` : ""}</figcaption>
      <div data-sized=${`chart-${chart.name}`} data-chart=${chart.name} role="img" aria-label=${spoken(context, chart)}></div>
      ${signOf(context, chart)}
      <details>
        <summary>${chart.title} as a table</summary>
        ${chart.lines.map((line) => table(context, chart, line))}
      </details>
    </figure>
  `;
}

/** What positive means of the upright axis, where it has two sides. */
function signOf({ formatter }: Context, { y }: Chart): TemplateResult | typeof nothing {
  const { sign, meaning } = formatter.quantity(y.quantity);
  return sign ? html`<p class="sign" title=${meaning}>${sign[0].toUpperCase() + sign.slice(1)}.</p>` : nothing;
}

/** The greatest and the least value of each line, for who does not see the canvas. */
function spoken({ formatter, state }: Context, { title, x, y, lines }: Chart): string {
  const parts = lines.map(({ label, y: values }) => {
    const finite = Array.from(values).filter(Number.isFinite);
    const text = (value: number): string => formatter.text(y.quantity, value, state.system);
    return finite.length
      ? `${label} from ${text(Math.min(...finite))} to ${text(Math.max(...finite))}`
      : `${label}: no value`;
  });
  return `${title} over ${x.label}: ${parts.join("; ")}`;
}

function table({ formatter, state }: Context, { x, y, title }: Chart, line: Chart["lines"][number]): TemplateResult {
  const { unit, digits } = formatter.reading(x.quantity, state.system);
  const places = Array.from({ length: ROWS }, (_, i) => Math.round((i * (line.x.length - 1)) / (ROWS - 1)));
  return html`<table>
    <caption>${line.label}</caption>
    <thead>
      <tr><th scope="col">${x.label}</th><th scope="col">${title}</th></tr>
    </thead>
    <tbody>
      ${[...new Set(places)].map(
        (at) => html`<tr>
          <th scope="row">
            ${join(formatter.format(formatter.units.fromSi(line.x[at], unit), digits), formatter.units.symbol(unit))}
          </th>
          <td>${formatter.text(y.quantity, line.y[at], state.system)}</td>
        </tr>`,
      )}
    </tbody>
  </table>`;
}

/** Draws the charts of the page, anew where something has changed, and forgets those that are gone. */
export function drawCharts(context: Context): void {
  for (const [name, { plot, frame }] of drawn) {
    if (frame.isConnected) continue;
    plot.destroy();
    drawn.delete(name);
  }
  for (const chart of charts) {
    const frame = document.querySelector<HTMLElement>(`[data-chart="${chart.name}"]`);
    if (frame && chart.lines.length) draw(context, chart, frame);
  }
  charts = [];
}

function draw({ model, state, formatter }: Context, chart: Chart, frame: HTMLElement): void {
  const width = Math.max(240, model.widths[`chart-${chart.name}`] ?? 320);
  const colour = colourReader(frame);
  const rem = rootSize();
  const font = `${0.75 * rem}px system-ui, sans-serif`;
  const ink = colour("--ink");
  const labels = chart.lines.map(({ label }) => label).join("\n");
  const arrays = chart.lines.flatMap(({ x, y }) => [x, y]);
  const inputs = [width, rem, state.system, ink, chart.title, labels, ...arrays];
  const before = drawn.get(chart.name);
  if (before?.inputs.length === inputs.length && before.inputs.every((input, i) => input === inputs[i])) {
    if (before.mark.place !== chart.mark) {
      before.mark.place = chart.mark;
      before.plot.redraw(false);
    }
    return;
  }
  before?.plot.destroy();
  const [across, upwards] = [chart.x, chart.y].map(({ quantity }) => formatter.reading(quantity, state.system).unit);
  const convert = (values: ArrayLike<number>, unit: string): number[] =>
    Array.from(values, (value) => formatter.units.fromSi(value, unit));
  const data = uPlot.join(chart.lines.map(({ x, y }) => [convert(x, across), convert(y, upwards)]));
  const axis = { stroke: ink, grid: { stroke: colour("--line"), width: 1 }, font };
  const symbol = formatter.units.symbol(across);
  const mark = { place: chart.mark };
  const drawMark = (plot: uPlot): void => {
    if (mark.place === undefined) return;
    const { ctx, bbox } = plot;
    const at = plot.valToPos(formatter.units.fromSi(mark.place, across), "x", true);
    ctx.save();
    ctx.strokeStyle = ink;
    ctx.setLineDash([]);
    ctx.beginPath();
    ctx.moveTo(at, bbox.top);
    ctx.lineTo(at, bbox.top + bbox.height);
    ctx.stroke();
    ctx.restore();
  };
  const plot = new uPlot(
    {
      width,
      height: Math.max(HEIGHTS[0] * rem, Math.min(HEIGHTS[1] * rem, SHARE * width)),
      scales: { x: { time: false } },
      cursor: { y: false },
      hooks: { draw: [drawMark] },
      axes: [
        {
          ...axis,
          label: symbol ? `${chart.x.label}, ${symbol}` : chart.x.label,
          labelFont: font,
          labelSize: 1.1 * rem,
          size: 2.1 * rem,
        },
        { ...axis, size: 3.3 * rem },
      ],
      series: [
        {},
        ...chart.lines.map(({ label }, i) => ({
          label,
          stroke: colour(`--series-${seriesLook(i).number}`),
          width: rem / 8,
          dash: DASHES[i],
          spanGaps: true,
        })),
      ],
      legend: { live: false, show: chart.lines.length > 1 },
    },
    data,
    frame,
  );
  drawn.set(chart.name, { plot, mark, frame, inputs });
}
