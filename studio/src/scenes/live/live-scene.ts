/** A shot in little room: what the ball does in a sentence, its flight, and the inputs that change it most. */

import { html, nothing, type TemplateResult } from "lit-html";
import type { Context, Scene } from "../../context";
import { gap } from "../../quantities/formatter";
import { outputOf } from "../../state/store";
import { deliveryField } from "../shot/delivery";
import { facePanel } from "../shot/face";
import { flightPanel } from "../shot/flight-panel";

const NUMBERS = ["ball_speed", "launch", "backspin", "carry"];
const INPUTS = ["speed", "loft", "path", "face"];

export const liveScene: Scene = { view };

function view(context: Context): TemplateResult {
  const { model } = context;
  const failure = outputOf(model, "shot")?.failure;
  return html`
    <main class=${failure ? "live stale" : "live"}>
      <h1 class="unseen">A shot and its delivery</h1>
      <p class="failure" role="alert">${failure ? `This shot cannot be computed: ${failure.message}.` : nothing}</p>
      ${numbers(context)} ${flightPanel(context)}
      <section class="inputs" aria-label="Delivery">${INPUTS.map((name) => deliveryField(context, name))}</section>
      ${facePanel(context)}
    </main>
  `;
}

function numbers({ model, state, formatter }: Context): TemplateResult {
  const shot = model.good;
  if (!shot) return html``;
  return html`
    <section class="numbers" aria-label="The shot in short">
      <dl aria-live="polite">
        ${NUMBERS.map((name) => {
          const { number, unit } = formatter.show(name, shot.values[name], state.system);
          return html`<div>
            <dt>${formatter.quantity(name).label}</dt>
            <dd><b>${number}</b>${gap(unit) ? html` <span>${unit}</span>` : unit}</dd>
          </div>`;
        })}
      </dl>
    </section>
  `;
}
