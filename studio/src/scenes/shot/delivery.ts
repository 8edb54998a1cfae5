/** The delivery: speed, directions, loft, and what few golfers know of their swing. */

import { html, type TemplateResult } from "lit-html";
import type { Context } from "../../context";
import { fieldOf } from "../../parts/field";
import { DELIVERY, FURTHER, MAIN } from "./words";

/** The ends of the slider of an input [SI], as the core describes it. */
export function usualRange({ description }: Context, name: string): readonly [number, number] {
  const usual = description.inputs.find((input) => input.name === name)?.usual;
  if (!usual) throw new Error(`${name}: the core describes no usual range`);
  return usual;
}

export function deliveryField(
  context: Context,
  name: string,
  range: readonly [number, number] = usualRange(context, name),
): TemplateResult {
  const remark = name === "loft" && !context.state.delivery.loft ? "the club's own; few golfers deliver it" : undefined;
  return fieldOf(context, { name, label: DELIVERY[name].label, range, remark });
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
