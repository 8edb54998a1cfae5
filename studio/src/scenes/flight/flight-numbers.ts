/** The numbers of the flight, beside those of the same flight in still air of the usual kind. */

import { html, type TemplateResult } from "lit-html";
import type { Context } from "../../context";
import { gap, printedSymbol } from "../../quantities/formatter";

/** The output that is 1 where a flight leaves the range of the aerodynamic data. */
const OUTSIDE = "outside_fit";

export function flightNumbers({ model, description, formatter, state }: Context): TemplateResult {
  const values = model.good?.values;
  if (!values) return html``;
  return html`
    <section aria-labelledby="flight-numbers">
      <h2 id="flight-numbers">The flight in numbers</h2>
      <table>
        <thead>
          <tr><th scope="col">Quantity</th><th scope="col">Value</th><th scope="col">Meaning</th></tr>
        </thead>
        <tbody>
          ${description.flight_outputs
            .filter(({ name }) => name !== OUTSIDE)
            .map(({ name, meaning }) => {
              const { number, unit, side } = formatter.show(name, values[name], state.system);
              const { symbol, label } = formatter.quantity(name);
              const [letter, index] = printedSymbol(symbol);
              return html`<tr>
                <th scope="row">${label} <span class="symbol">${letter}<sub>${index}</sub></span></th>
                <td data-quantity=${name} data-value=${String(values[name])}><b>${number}</b>${gap(unit)}${unit} ${side}</td>
                <td>${meaning}</td>
              </tr>`;
            })}
        </tbody>
      </table>
      ${
        values[OUTSIDE]
          ? html`<p class="remark">The spin of this flight leaves the range for which lift and drag were measured.</p>`
          : ""
      }
    </section>
  `;
}
