/** The designed club in short: what golfers ask for first, how it differs, and whether it is allowed. */

import { html, nothing, type TemplateResult } from "lit-html";
import type { Context } from "../../context";
import { gap } from "../../quantities/formatter";
import { outputOf } from "../../state/store";
import { verdicts } from "./designed";

const FIRST = ["ball_speed", "launch", "total_spin", "carry", "side", "total"];

export function inShort(context: Context): TemplateResult | typeof nothing {
  const { model, state, formatter } = context;
  const design = outputOf(model, "design");
  if (!design || design.designed.failure) return nothing;
  const limits = outputOf(model, "limits");
  const isBuilt = !limits || limits.margins.every(({ value }) => value >= -limits.rounding);
  const isWithin = verdicts(context).every(({ conforms }) => conforms !== false);
  return html`
    <section class="headline" aria-label="The designed club in short">
      <dl>
        ${FIRST.map((name) => {
          const value = design.designed.values[name];
          const { number, unit, side } = formatter.show(name, value, state.system);
          return html`<div>
            <dt>${formatter.quantity(name).label}</dt>
            <dd>
              <b>${number}</b>${gap(unit) ? html` <span>${unit}</span>` : unit} <i>${side}</i>
              <small>${formatter.difference(name, value - design.own.values[name], state.system)}</small>
            </dd>
          </div>`;
        })}
      </dl>
      <p class="allowed">
        ${isWithin ? "Within the rules" : html`<b class="mistake">Beyond the rules</b>`}, and
        ${isBuilt ? "it can be built" : html`<b class="mistake">it cannot be built</b>`}.
        <span>In small type, the difference from the original.</span>
      </p>
    </section>
  `;
}
