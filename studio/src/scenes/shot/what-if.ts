/** What a little more of each input would do, from exact derivatives; a press does it. */

import { html, type nothing, type TemplateResult } from "lit-html";
import { type Context, delivered } from "../../context";
import type { Quantity } from "../../core/types";
import { join, sideOf } from "../../quantities/formatter";
import { outputOf } from "../../state/store";
import { DELIVERY, IMPACT_POINT, MAIN } from "./words";

export function whatIfPanel(context: Context): TemplateResult {
  if (!context.model.good) return html``;
  return html`
    <section aria-labelledby="what-if">
      <h2 id="what-if">What if</h2>
      <ul class="chips">
        ${[...MAIN, ...IMPACT_POINT].map((name) => html`<li>${chip(context, name)}</li>`)}
      </ul>
      <p class="remark">Computed from exact derivatives at this delivery. Click a change to make it.</p>
    </section>
  `;
}

function chip(context: Context, name: string): TemplateResult | typeof nothing {
  const { state, formatter, actions } = context;
  const slopes = outputOf(context.model, "slopes") ?? {};
  const { step, more } = DELIVERY[name];
  const { unit, digits } = formatter.reading(name, state.system);
  const { units } = formatter;
  const size = units.toSi({ value: step, unit });
  const sides = formatter.quantity("side").sides;
  const across = difference(context, "side", (slopes.side?.[name] ?? 0) * size, sides);
  const along = difference(context, "carry", (slopes.carry?.[name] ?? 0) * size, ["shorter", "longer"]);
  const isKnown = Object.keys(slopes).length > 0;
  const effects = isKnown ? [across, along].filter(Boolean).join(", ") || "no difference" : "…";
  const take = (): void => {
    const value = units.fromSi(delivered(context, name), unit) + step;
    actions.change({ kind: "delivery", amounts: { [name]: { value: Number(value.toFixed(digits + 1)), unit } } });
  };
  return html`<button type="button" data-name=${name} @click=${take}>
    <span>${join(formatter.format(step, 0), units.symbol(unit))} ${more}</span> <b>${effects}</b>
  </button>`;
}

/** A difference with its word, "" where it rounds to nothing. */
function difference({ formatter, state }: Context, name: string, si: number, words: Quantity["sides"]): string {
  const { unit, digits } = formatter.reading(name, state.system);
  const value = formatter.units.differenceFromSi(si, unit);
  const word = sideOf(words, value, digits);
  return word && join(formatter.format(Math.abs(value), digits), formatter.units.symbol(unit), word);
}
