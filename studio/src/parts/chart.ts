/** Curves over time, drawn by uPlot on canvases that the page keeps, and the same as a table. */

import { html, type TemplateResult } from "lit-html";
import uPlot from "uplot";
import "uplot/dist/uPlot.min.css";
import type { Context } from "../context";
import { HISTORIES, type HistoryChart } from "../scenes/models/histories";
import { rootSize } from "./measure";

/** Height of a chart, in letters of the page. */
const HEIGHT = 14;
/** Moments that the tables have. */
const ROWS = 11;
const DASHES = [[], [8, 4], [2, 3]];

interface Drawn {
  chart: uPlot;
  frame: Element;
  /** What it was drawn from: it is drawn anew where one of them is another. */
  inputs: readonly unknown[];
}

const drawn = new Map<string, Drawn>();

export function chartFrame(context: Context, each: HistoryChart): TemplateResult {
  const { formatter, state } = context;
  const unit = formatter.units.symbol(formatter.reading(each.quantity, state.system).unit);
  return html`
    <figure>
      <figcaption>${each.title}, ${unit}</figcaption>
      <div data-sized=${`chart-${each.name}`} data-chart=${each.name} role="img" aria-label=${spoken(context, each)}></div>
      <details>
        <summary>${each.title} as a table</summary>
        ${table(context, each)}
      </details>
    </figure>
  `;
}

/** The greatest and the least value by each model, for who does not see the canvas. */
function spoken({ model, formatter, state }: Context, each: HistoryChart): string {
  const parts = (model.comparison?.histories ?? []).map(({ model: name, arrays }) => {
    const values = each.values(arrays);
    const text = (value: number): string => formatter.text(each.quantity, value, state.system);
    return `${name} from ${text(Math.min(...values))} to ${text(Math.max(...values))}`;
  });
  return `${each.title} over time: ${parts.join("; ")}`;
}

function table({ model, formatter, state }: Context, each: HistoryChart): TemplateResult {
  return html`${(model.comparison?.histories ?? []).map(({ model: name, arrays }) => {
    const [times, values] = [arrays.time.values, each.values(arrays)];
    const { unit } = formatter.reading("contact_time", state.system);
    const places = Array.from({ length: ROWS }, (_, i) => Math.round((i * (times.length - 1)) / (ROWS - 1)));
    return html`<table>
      <caption>${name}</caption>
      <thead>
        <tr><th scope="col">Time, ${formatter.units.symbol(unit)}</th><th scope="col">${each.title}</th></tr>
      </thead>
      <tbody>
        ${places.map(
          (at) => html`<tr>
            <th scope="row">${formatter.format(formatter.units.fromSi(times[at], unit), 0)}</th>
            <td>${formatter.text(each.quantity, values[at], state.system)}</td>
          </tr>`,
        )}
      </tbody>
    </table>`;
  })}`;
}

/** Draws the charts whose frames are on the page, anew where something has changed. */
export function drawCharts(context: Context): void {
  for (const each of HISTORIES) {
    const frame = document.querySelector(`[data-chart="${each.name}"]`);
    const before = drawn.get(each.name);
    if (before && before.frame !== frame) {
      before.chart.destroy();
      drawn.delete(each.name);
    }
    if (frame && context.model.comparison) draw(context, each, frame);
  }
}

function draw(context: Context, each: HistoryChart, frame: Element): void {
  const { model, state, formatter } = context;
  const histories = model.comparison?.histories ?? [];
  const width = Math.max(240, model.widths[`chart-${each.name}`] ?? 320);
  const style = getComputedStyle(frame);
  const rem = rootSize();
  const font = `${0.75 * rem}px system-ui, sans-serif`;
  const ink = style.getPropertyValue("--ink");
  const inputs = [width, rem, state.system, ink, model.comparison];
  const before = drawn.get(each.name);
  if (before?.inputs.every((input, i) => input === inputs[i])) return;
  before?.chart.destroy();
  const { unit } = formatter.reading(each.quantity, state.system);
  const time = formatter.reading("contact_time", state.system).unit;
  const data = uPlot.join(
    histories.map(({ arrays }) => [
      Array.from(arrays.time.values, (value) => formatter.units.fromSi(value, time)),
      each.values(arrays).map((value) => formatter.units.fromSi(value, unit)),
    ]),
  );
  const axis = { stroke: ink, grid: { stroke: style.getPropertyValue("--line"), width: 1 }, font };
  const chart = new uPlot(
    {
      width,
      height: HEIGHT * rem,
      scales: { x: { time: false } },
      cursor: { y: false },
      axes: [
        {
          ...axis,
          label: `time, ${formatter.units.symbol(time)}`,
          labelFont: font,
          labelSize: 1.1 * rem,
          size: 2.1 * rem,
        },
        { ...axis, size: 3.3 * rem },
      ],
      series: [
        {},
        ...histories.map(({ model: label }, i) => ({
          label,
          stroke: style.getPropertyValue(`--series-${i + 1}`),
          width: 2,
          dash: DASHES[i],
          spanGaps: true,
        })),
      ],
      legend: { live: false },
    },
    data,
    frame as HTMLElement,
  );
  drawn.set(each.name, { chart, frame, inputs });
}
