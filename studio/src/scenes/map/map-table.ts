/** The numbers of the map: every fifth point, as the face is seen. */

import { html, type TemplateResult } from "lit-html";
import type { Context } from "../../context";
import { clubsOf, isOnFace, type Shown, shownMap } from "./mapped";
import { titleOf, valueInWords, valueScale } from "./scales";

/** Rows and columns that the table has. */
const LINES = 9;
const MILLIMETRE = 1e-3;

export function mapTable(context: Context): TemplateResult {
  const shown = shownMap(context);
  if (!shown) return html``;
  const { formatter, state } = context;
  const { toe, high } = shown.known;
  const across = some(toe.length);
  if (shown.side < 0) across.reverse();
  const title = titleOf(context, shown.name, clubsOf(context));
  const place = (name: string, metres: number): string => formatter.text(name, metres, state.system);
  return html`
    <details>
      <summary>The map as a table</summary>
      <div class="scroll" tabindex="0" role="region" aria-label="Table of the map">
        <table class="values">
          <caption>${title}</caption>
          <thead>
            <tr>
              <th scope="col">Impact</th>
              ${across.map((column) => html`<th scope="col">${place("toe", toe[column])}</th>`)}
            </tr>
          </thead>
          <tbody>
            ${some(high.length)
              .reverse()
              .map(
                (row) => html`<tr>
                  <th scope="row">${place("high", high[row])}</th>
                  ${across.map((column) => cell(context, shown, row, column))}
                </tr>`,
              )}
          </tbody>
        </table>
      </div>
    </details>
  `;
}

/** Evenly spread places among so many, both ends with them. */
function some(count: number): number[] {
  const step = (count - 1) / (LINES - 1);
  return [...new Set(Array.from({ length: LINES }, (_, i) => Math.round(i * step)))];
}

function cell(context: Context, shown: Shown, row: number, column: number): TemplateResult {
  const { toe, high, values } = shown.known;
  const si = values[row * toe.length + column];
  if (!isOnFace(shown.outlines, [toe[column], high[row]]) || Number.isNaN(si)) return html`<td></td>`;
  const { digits, fromSi } = valueScale(context, shown);
  const text = shown.isDifference ? context.formatter.format(fromSi(si), digits) : valueInWords(context, shown, si);
  return html`<td data-quantity=${shown.name} data-value=${String(si)} data-toe=${(toe[column] / MILLIMETRE).toFixed(3)} data-high=${(high[row] / MILLIMETRE).toFixed(3)}>${text}</td>`;
}
