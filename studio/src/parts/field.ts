/** One amount: its name, a text that takes any unit, and a slider. */

import { html, nothing, type TemplateResult } from "lit-html";
import { live } from "lit-html/directives/live.js";
import { amountSetting, type Context, delivered } from "../context";
import { join, sideOf } from "../quantities/formatter";
import type { Amount } from "../quantities/units";
import { measure } from "./measure";

export interface Field {
  name: string;
  label: string;
  /** Ends of the slider in SI. */
  range: readonly [number, number];
  /** What stands under the field, such as where its value comes from. */
  remark?: string;
  /** What the amount means where it is no value of its quantity but a size, which has no sides. */
  meaning?: string;
  /** What stands under the field where its value is not allowed. */
  broken?: string;
  /** Parts of the slider that are allowed, one line a limit. */
  bands?: Band[];
}

/** Where a limit is kept. */
export interface Band {
  /** Its class, which has its colour. */
  kind: string;
  /** What it is, and where, in words. */
  words: string;
  /** From where to where [SI]. */
  parts: readonly (readonly [number, number])[];
}

/** What a field shows and changes. */
export interface Source {
  /** Name of the quantity that gives unit, digits and meaning. */
  quantity: string;
  /** The amount as it was given; undefined where something stands for it. */
  amount: Amount | undefined;
  /** In SI, whether given or not. */
  si: number;
  change(amount: Amount, going: string | null): void;
}

/** A field of an input of the delivery. */
export const fieldOf = (context: Context, field: Field): TemplateResult =>
  amountField(context, field, {
    quantity: field.name,
    amount: context.state.delivery[field.name],
    si: delivered(context, field.name),
    change: (amount, going) => context.actions.change({ kind: "delivery", amounts: { [field.name]: amount } }, going),
  });

/** A field of a setting of a scene. */
export function settingField(context: Context, field: Field): TemplateResult {
  const { settings, formatter, actions } = context;
  const setting = settings[field.name];
  const amount = amountSetting(context, field.name);
  return amountField(context, field, {
    quantity: setting.kind === "amount" ? setting.quantity : field.name,
    amount,
    si: formatter.units.toSi(amount),
    change: (next, going) => actions.change({ kind: "settings", settings: { [field.name]: next } }, going),
  });
}

/** A field of a number of the club that can be changed; `own` is its own [SI]. */
export function clubField(context: Context, field: Field, own: number): TemplateResult {
  const { settings, formatter, actions, state } = context;
  const setting = settings[field.name];
  const value = state.settings[field.name];
  const amount = typeof value === "object" ? value : undefined;
  return amountField(context, field, {
    quantity: setting.kind === "of-club" ? setting.quantity : field.name,
    amount,
    si: amount ? formatter.units.toSi(amount) : own,
    change: (next, going) => actions.change({ kind: "settings", settings: { [field.name]: next } }, going),
  });
}

/** A field of any amount. */
export function amountField(context: Context, field: Field, source: Source): TemplateResult {
  const { name, label, range, remark, meaning: size, broken, bands = [] } = field;
  const { state, formatter, actions, model } = context;
  const { quantity, amount, si } = source;
  const { unit, digits } = formatter.reading(quantity, state.system);
  const value = amount ? formatter.inSystem(quantity, amount, state.system) : formatter.units.fromSi(si, unit);
  const text = formatter.format(value, Math.max(digits, decimals(amount?.unit === unit ? amount.value : 0)));
  const [least, most] = range.map((end) => formatter.units.fromSi(end, unit));
  const mistake = model.mistakes[name];
  const typed = model.typing?.name === name ? model.typing.text : undefined;
  const described = formatter.quantity(quantity);
  const sides = size ? null : described.sides;
  const title = size ?? [described.meaning, described.sign].filter(Boolean).join(": ");
  const spoken = size ? join(text, formatter.units.symbol(unit)) : formatter.text(quantity, si, state.system);

  const take = (event: Event): void => {
    const field = event.target as HTMLInputElement;
    try {
      source.change(formatter.units.parse(field.value, unit), null);
    } catch (error) {
      const message = error instanceof Error ? error.message : String(error);
      actions.mistake(name, { text: field.value, message });
    }
  };
  const slide = (event: Event): void => {
    measure.asked(event);
    source.change({ value: Number((event.target as HTMLInputElement).value), unit }, name);
  };

  return html`
    <div class="field" data-name=${name}>
      <label for=${`text-${name}`} title=${title}>${label}</label>
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
        aria-valuetext=${spoken}
        min=${rounded(least, digits)}
        max=${rounded(most, digits)}
        step=${10 ** -digits}
        .value=${live(String(rounded(Math.min(value, most), digits)))}
        @input=${slide}
        @change=${actions.settle}
      />
      ${bands.map((band) => track(band, range))}
      <small id=${`about-${name}`} class=${mistake || broken ? "mistake" : ""} role=${mistake ? "alert" : nothing}>
        ${mistake?.message ?? broken ?? remark ?? nothing}
      </small>
    </div>
  `;
}

/** The parts of a slider that a limit allows. */
function track({ kind, words, parts }: Band, [least, most]: readonly [number, number]): TemplateResult {
  const percent = (value: number): number => (100 * (Math.max(least, Math.min(most, value)) - least)) / (most - least);
  return html`<div class=${`band ${kind}`} role="img" aria-label=${words} title=${words}>
    ${parts.map(
      ([from, to]) => html`<i style=${`left: ${percent(from)}%; width: ${percent(to) - percent(from)}%`}></i>`,
    )}
  </div>`;
}

const rounded = (value: number, digits: number): number => Number(value.toFixed(digits));

/** How many digits after the point a number was given with, at most six. */
const decimals = (value: number): number => Math.min(6, (String(value).split(".")[1] ?? "").length);
