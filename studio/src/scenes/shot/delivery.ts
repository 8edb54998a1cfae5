/** The delivery: speed, directions, loft, and what few golfers know of their swing. */

import { html, type TemplateResult } from "lit-html";
import type { Context } from "../../context";
import { fieldOf } from "../../parts/field";
import { DELIVERY, FURTHER, MAIN } from "./words";

export function deliveryField(context: Context, name: string, range?: readonly [number, number]): TemplateResult {
  const { units } = context.formatter;
  const { unit } = context.formatter.quantity(name);
  const words = DELIVERY[name];
  const [least, most] = words.range.map((text) => units.toSi(units.parse(text, unit)));
  const remark = name === "loft" && !context.state.delivery.loft ? "the club's own; few golfers deliver it" : undefined;
  return fieldOf(context, { name, label: words.label, range: range ?? [least, most], remark });
}

export function deliveryPanel(context: Context): TemplateResult {
  const { actions, state } = context;
  const reset = (): void => actions.change({ kind: "delivery", amounts: { loft: null } });
  const known = context.description.inputs.filter(({ group }) => group === "delivery").map(({ name }) => name);
  const isOpen = FURTHER.some((name) => state.delivery[name]);
  return html`
    <section aria-labelledby="delivery">
      <h2 id="delivery">Delivery</h2>
      ${MAIN.map((name) => deliveryField(context, name))}
      <button type="button" class="quiet" ?disabled=${!state.delivery.loft} @click=${reset}>Back to the club's loft</button>
      <details ?open=${isOpen}>
        <summary>Lie, rates of turning, spin before impact</summary>
        ${FURTHER.filter((name) => known.includes(name)).map((name) => deliveryField(context, name))}
      </details>
    </section>
  `;
}
