/** Shots in a table: what was measured upright, what is computed in italics. */

import { html, nothing, type TemplateResult } from "lit-html";
import type { Context } from "../../context";
import { clubName } from "../../equipment/names";
import { withUnit } from "../../quantities/formatter";
import type { TableDocument } from "../../state/session";
import { type Measured, measuredColumns, type ShotRow } from "./shot-rows";

/** Rows that are drawn at once. */
const MOST = 300;

export function shotTable(
  context: Context,
  table: TableDocument,
  rows: readonly ShotRow[],
  title: string,
): TemplateResult {
  const columns = measuredColumns(table);
  const hasClubs = rows.some(({ club }) => club);
  const { actions, model, formatter, state } = context;
  const mark = (shot: number): void => actions.session(({ marked }) => ({ marked: marked === shot ? null : shot }));
  return html`
    <div class="scroll shots" tabindex="0" role="region" aria-label=${title}>
      <table>
        <caption class="unseen">${title}</caption>
        <thead>
          <tr>
            <th scope="col">Shot</th>
            ${hasClubs ? html`<th scope="col">Club</th>` : nothing}
            <th scope="col">Shape</th>
            ${columns.map((column) => heading(context, column, table))}
          </tr>
        </thead>
        <tbody>
          ${rows.slice(0, MOST).map(
            (row) => html`<tr class=${row.mishit ? "off" : nothing}>
              <th scope="row">
                <button type="button" aria-pressed=${model.session.marked === row.shot} @click=${() => mark(row.shot)}>
                  ${row.shot}
                </button>
              </th>
              ${hasClubs ? html`<td>${clubName(context, row.club)}</td>` : nothing}
              <td>${row.shape}${row.mishit ? html` <b title="far off in ${formatterLabel(context, row.mishit)}">mishit</b>` : nothing}</td>
              ${columns.map(({ quantity }) => cell(row, quantity))}
            </tr>`,
          )}
        </tbody>
      </table>
    </div>
    ${rows.length > MOST ? html`<p class="remark">The first ${MOST} of ${rows.length} shots; the picture has all.</p>` : nothing}
    <p class="remark">Numbers <i class="computed">in italics</i> are computed by clubface from what was measured. Press the number of a shot to mark it in the picture.</p>
  `;

  function cell(row: ShotRow, quantity: string): TemplateResult {
    const value = row.values[quantity];
    if (value === undefined) return html`<td></td>`;
    const { number, side } = formatter.show(quantity, value, state.system);
    const text = `${number} ${side}`.trimEnd();
    return row.computed.has(quantity)
      ? html`<td data-quantity=${quantity} data-value=${String(value)} class="computed" title="computed"><i>${text}</i></td>`
      : html`<td data-quantity=${quantity} data-value=${String(value)}>${text}</td>`;
  }
}

const formatterLabel = ({ formatter }: Context, quantity: string): string => formatter.quantity(quantity).label;

function heading(
  { formatter, state }: Context,
  { key, quantity }: Measured,
  { columns }: TableDocument,
): TemplateResult {
  const unit = formatter.units.symbol(formatter.reading(quantity, state.system).unit);
  const { label, meaning } = columns[key];
  return html`<th scope="col" title=${meaning || nothing}>${withUnit(label, unit)}</th>`;
}
