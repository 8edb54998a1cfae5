/** The numbers of the flight; a press on one says where it comes from. */

import { html, nothing, type TemplateResult } from "lit-html";
import type { Context } from "../../context";
import { numbersTable } from "../shot/numbers";

/** The output that is 1 where a flight leaves the range of the aerodynamic data. */
const OUTSIDE = "outside_fit";

export function flightNumbers(context: Context): TemplateResult {
  const values = context.model.good?.values;
  if (!values) return html``;
  const variables = context.description.flight_outputs.filter(({ name }) => name !== OUTSIDE);
  return html`
    <section aria-labelledby="flight-numbers">
      <h2 id="flight-numbers">The flight in numbers</h2>
      ${numbersTable(context, "From launch to rest", variables)}
      ${
        values[OUTSIDE]
          ? html`<p class="remark">The spin of this flight leaves the range for which lift and drag were measured.</p>`
          : nothing
      }
    </section>
  `;
}
