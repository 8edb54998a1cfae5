/** All numbers of the shot, each with its unit and what it means. */

import { html, type TemplateResult } from "lit-html";
import type { Context } from "../../context";
import type { Variable } from "../../core/types";
import { gap, printedSymbol } from "../../quantities/formatter";
import { numberButton } from "./explanation/explanation";

/** The output that is 1 where a flight leaves the range of the aerodynamic data. */
const OUTSIDE = "outside_fit";

export function numbersPanel(context: Context): TemplateResult {
  if (!context.model.good) return html``;
  const { outputs, flight_outputs } = context.description;
  const isVector = ({ name }: Variable): boolean => /_[xyz]$/.test(name);
  return html`
    <section aria-labelledby="numbers">
      <h2 id="numbers">All numbers</h2>
      ${numbersTable(
        context,
        "Launch",
        outputs.filter((each) => !isVector(each)),
      )}
      ${numbersTable(
        context,
        "Flight",
        flight_outputs.filter(({ name }) => name !== OUTSIDE),
      )}
      ${context.model.good.values[OUTSIDE] ? html`<p class="remark">The spin of this flight leaves the range for which lift and drag were measured.</p>` : ""}
      <details>
        <summary>Components along the axes: x to the target, y up, z to the right</summary>
        ${numbersTable(context, "Ball and club after impact", outputs.filter(isVector))}
      </details>
    </section>
  `;
}

/** A table of quantities of the shot; a press on one explains it. */
export function numbersTable(context: Context, title: string, variables: Variable[]): TemplateResult {
  const { model, state, formatter } = context;
  const values = model.good?.values ?? {};
  return html`
    <table class="numbers">
      <caption>${title}</caption>
      <thead>
        <tr><th scope="col">Quantity</th><th scope="col">Value</th><th scope="col">Meaning</th></tr>
      </thead>
      <tbody>
        ${variables.map(({ name, meaning }) => {
          const { number, unit, side } = formatter.show(name, values[name], state.system);
          const { symbol, label } = formatter.quantity(name);
          const [letter, index] = printedSymbol(symbol);
          return html`<tr>
            <th scope="row" data-explains=${name}>
              ${numberButton(context, name, html`${label} <span class="symbol">${letter}<sub>${index}</sub></span>`)}
            </th>
            <td data-quantity=${name} data-value=${String(values[name])}>
              <b>${number}</b>${gap(unit)}${unit} ${side}
            </td>
            <td>${meaning}</td>
          </tr>`;
        })}
      </tbody>
    </table>
  `;
}
