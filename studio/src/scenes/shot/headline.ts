/** The numbers that golfers ask for first, and the shot in one sentence. */

import { html, type TemplateResult } from "lit-html";
import type { Context } from "../../context";
import { gap } from "../../quantities/formatter";
import { outputOf } from "../../state/store";
import { numberButton } from "./explanation/explanation";

const FIRST = ["ball_speed", "launch", "total_spin", "carry", "side", "total"];

export function headline(context: Context): TemplateResult {
  const { model, state, formatter } = context;
  const shot = model.good;
  if (!shot) return outputOf(model, "shot") ? html`` : html`<p aria-busy="true">The first shot is being computed …</p>`;
  const { system } = state;
  const { shape } = shot;
  const text = (name: string): string => formatter.text(name, shot.values[name], system);
  return html`
    <section class="headline" aria-label="The shot in short">
      <dl>
        ${FIRST.map((name) => {
          const { number, unit, side } = formatter.show(name, shot.values[name], system);
          return html`<div>
            <dt>${numberButton(context, name, formatter.quantity(name).label)}</dt>
            <dd><b>${number}</b>${gap(unit) ? html` <span>${unit}</span>` : unit} <i>${side}</i></dd>
          </div>`;
        })}
      </dl>
      <p aria-live="polite">
        The ball starts ${text("azimuth")} of the target, rises to ${text("apex")}, curves
        ${text("curve")} and lands ${text("side")} after
        ${text("carry")}${shape ? html`: a <b class="shape">${shape}</b>.` : "."}
      </p>
    </section>
  `;
}
