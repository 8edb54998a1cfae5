/** Models side by side: the same strike by every model, and what the contact models say of the half millisecond. */

import { html, nothing, type TemplateResult } from "lit-html";
import { type Context, type Scene, strike } from "../../context";
import type { Computed, History } from "../../core/types";
import { chartFrame } from "../../parts/chart";
import { IMPACT_AND_FLIGHT } from "../../quantities/compared";
import { withUnit } from "../../quantities/formatter";
import { outputOf } from "../../state/store";
import { deliveryPanel } from "../shot/delivery";
import { equipmentPanel } from "../shot/equipment-panel";
import { facePanel } from "../shot/face";
import { historyCharts } from "./histories";
import { headlineDelivery } from "./strike-in-words";

/** No histories yet. */
const NONE: History[] = [];

export const modelsScene: Scene = {
  view,
  wanted: (context) => {
    const { state, description } = context;
    const strikes = description.models.map(({ name }) =>
      strike(context, { model: name, parameters: name === state.model ? state.parameters : "" }),
    );
    return [{ kind: "comparison", input: strikes, lane: "batch" }];
  },
};

function view(context: Context): TemplateResult {
  const comparison = outputOf(context.model, "comparison");
  return html`
    <div class="models">
      <section aria-labelledby="models">
        <h2 id="models">The same strike by every model</h2>
        <p>${headlineDelivery(context)}</p>
        <details class="strike">
          <summary>Change the strike</summary>
          <div class="side-by-side">${equipmentPanel(context)} ${deliveryPanel(context)} ${facePanel(context)}</div>
        </details>
        ${comparison ? table(context, comparison.shots) : html`<p aria-busy="true">All models are being computed …</p>`}
        <p class="remark">
          In impulse models the contact takes no time: where contact time and peak force are missing, the model has none.
        </p>
      </section>
      <section aria-labelledby="histories">
        <h2 id="histories">Force, slip and spin over time</h2>
        <p>Computed by the contact models. Friction makes backspin first (above zero), and takes some of it back as the ball springs back along the face (below zero).</p>
        <div class="charts">${historyCharts(context.description, comparison?.histories ?? NONE).map((each) => chartFrame(context, each))}</div>
      </section>
    </div>
  `;
}

function table({ state, formatter, description }: Context, shots: Computed[]): TemplateResult {
  return html`
    <div class="scroll" tabindex="0" role="region" aria-label="Table of all models">
      <table>
        <caption>Launch and flight</caption>
        <thead>
          <tr>
            <th scope="col">Quantity</th>
            ${shots.map((shot) => {
              const entry = description.models.find(({ name }) => name === shot.model);
              return html`<th scope="col" title=${entry?.summary ?? nothing}>${entry?.title ?? shot.model}</th>`;
            })}
          </tr>
        </thead>
        <tbody>
          ${IMPACT_AND_FLIGHT.map((name) => {
            const { unit } = formatter.reading(name, state.system);
            const symbol = formatter.units.symbol(unit);
            return html`<tr>
              <th scope="row">${withUnit(formatter.quantity(name).label, symbol)}</th>
              ${shots.map(({ values, failure }) => {
                const value = values[name];
                if (failure || !Number.isFinite(value)) return html`<td title=${failure?.message ?? nothing}>–</td>`;
                const { number, side } = formatter.show(name, value, state.system);
                return html`<td data-quantity=${name} data-value=${String(value)}>${number} ${side}</td>`;
              })}
            </tr>`;
          })}
        </tbody>
      </table>
    </div>
  `;
}
