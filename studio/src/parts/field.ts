/** One input of the delivery: its name, a text that takes any unit, and a slider. */

import { html, nothing, type TemplateResult } from "lit-html";
import { live } from "lit-html/directives/live.js";
import { type Context, delivered } from "../context";
import { sideOf } from "../quantities/formatter";
import { measure } from "./measure";

export interface Field {
  name: string;
  label: string;
  /** Ends of the slider in SI. */
  range: readonly [number, number];
  /** What stands under the field, such as where its value comes from. */
  remark?: string;
}

export function fieldOf(context: Context, { name, label, range, remark }: Field): TemplateResult {
  const { state, formatter, actions, model } = context;
  const { unit, digits } = formatter.reading(name, state.system);
  const amount = state.delivery[name];
  const value = amount
    ? formatter.inSystem(name, amount, state.system)
    : formatter.units.fromSi(delivered(context, name), unit);
  const text = formatter.format(value, Math.max(digits, decimals(amount?.unit === unit ? amount.value : 0)));
  const [least, most] = range.map((end) => formatter.units.fromSi(end, unit));
  const mistake = model.mistakes[name];
  const typed = model.typing?.name === name ? model.typing.text : undefined;
  const { sides, meaning, sign } = formatter.quantity(name);

  const take = (event: Event): void => {
    const field = event.target as HTMLInputElement;
    try {
      actions.change({ kind: "delivery", amounts: { [name]: formatter.units.parse(field.value, unit) } });
    } catch (error) {
      const message = error instanceof Error ? error.message : String(error);
      actions.mistake(name, { text: field.value, message });
    }
  };
  const slide = (event: Event): void => {
    measure.asked(event);
    const slid = { value: Number((event.target as HTMLInputElement).value), unit };
    actions.change({ kind: "delivery", amounts: { [name]: slid } }, name);
  };

  return html`
    <div class="field" data-name=${name}>
      <label for=${`text-${name}`} title=${[meaning, sign].filter(Boolean).join(": ")}>${label}</label>
      <span class="side">${sideOf(sides, value, digits)}</span>
      <span class="typed">
        <input
          id=${`text-${name}`}
          type="text"
          inputmode="text"
          autocomplete="off"
          spellcheck="false"
          data-shown=${text}
          .value=${live(typed ?? mistake?.text ?? text)}
          aria-invalid=${mistake ? "true" : nothing}
          aria-describedby=${`about-${name}`}
          @input=${(event: Event) => actions.type(name, (event.target as HTMLInputElement).value)}
          @change=${take}
        />
        <span class="unit">${formatter.units.symbol(unit)}</span>
      </span>
      <input
        type="range"
        aria-label=${`${label}, slider`}
        aria-valuetext=${formatter.text(name, delivered(context, name), state.system)}
        min=${rounded(least, digits)}
        max=${rounded(most, digits)}
        step=${10 ** -digits}
        .value=${live(String(rounded(value, digits)))}
        @input=${slide}
        @change=${actions.settle}
      />
      <small id=${`about-${name}`} class=${mistake ? "mistake" : ""} role=${mistake ? "alert" : nothing}>
        ${mistake?.message ?? remark ?? nothing}
      </small>
    </div>
  `;
}

const rounded = (value: number, digits: number): number => Number(value.toFixed(digits));

/** How many digits after the point a number was given with, at most six. */
const decimals = (value: number): number => Math.min(6, (String(value).split(".")[1] ?? "").length);
