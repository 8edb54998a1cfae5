/** What makes a number of this shot: from a straight strike in the middle of the face, one input after another. */

import { html, nothing, type TemplateResult } from "lit-html";
import { type Context, delivered } from "../../../context";
import type { ContributionsInput } from "../../../core/contributions";
import type { Strike, Values } from "../../../core/types";
import { usualValue } from "../../../equipment/equipment";
import { join } from "../../../quantities/formatter";
import { outputOf } from "../../../state/store";
import { DELIVERY } from "../words";

/** What is wanted of the core: contributions from the straight strike of this speed at the club's own loft. */
export function contributionsInput({ description, equipment, state }: Context, strike: Strike): ContributionsInput {
  const delivery = description.inputs.filter(({ name, group }) => group === "delivery" && name !== "speed");
  const from: Values = Object.fromEntries(delivery.map(({ name }) => [name, usualValue(equipment, state, name)]));
  return { strike, from };
}

/** Words for a difference of a quantity, with its sign; "" where it rounds to nothing. */
function difference({ formatter, state }: Context, name: string, si: number): string {
  const { unit, digits } = formatter.reading(name, state.system);
  const value = formatter.units.differenceFromSi(si, unit);
  if (Number(value.toFixed(digits)) === 0) return "";
  return join(`${value > 0 ? "+" : "−"}${formatter.format(Math.abs(value), digits)}`, formatter.units.symbol(unit));
}

export function contributionsTable(context: Context, name: string): TemplateResult | typeof nothing {
  const { model, formatter, state } = context;
  const output = outputOf(model, "contributions");
  const value = model.good?.values[name] ?? Number.NaN;
  const parts = output?.parts[name];
  if (!output || !parts || !Number.isFinite(output.start[name]) || !Object.values(parts).every(Number.isFinite))
    return nothing;
  const { unit, digits } = formatter.reading(name, state.system);
  const signed = (si: number): string =>
    join(formatter.format(formatter.units.fromSi(si, unit), digits), formatter.units.symbol(unit));
  const rows = Object.entries(parts).map(([input, part]) => ({ input, part, text: difference(context, name, part) }));
  const sum = rows.reduce((total, { part }) => total + part, output.start[name]);
  const rest = difference(context, name, value - sum);
  const shown = rows.filter(({ text }) => text).sort((a, b) => Math.abs(b.part) - Math.abs(a.part));
  return html`
    <h4>What makes it</h4>
    <table class="contributions">
      <caption>From a straight strike in the middle of the face, at the loft of the club</caption>
      <tbody>
        <tr><th scope="row">straight, in the middle</th><td>${signed(output.start[name])}</td></tr>
        ${shown.map(
          ({ input, text }) => html`<tr>
            <th scope="row">
              ${DELIVERY[input]?.label ?? input} ${formatter.text(input, delivered(context, input), state.system)}
            </th>
            <td>${text}</td>
          </tr>`,
        )}
        ${rest ? html`<tr><th scope="row">what the integration leaves</th><td>${rest}</td></tr>` : nothing}
        <tr class="sum"><th scope="row">this shot</th><td>${signed(value)}</td></tr>
      </tbody>
    </table>
    <p class="remark">Integrals of exact derivatives along the straight line from that strike to this one.</p>
  `;
}
