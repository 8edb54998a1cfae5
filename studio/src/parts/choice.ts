/** A list to choose from. */

import { html, type TemplateResult } from "lit-html";
import { type Context, choiceSetting } from "../context";

export interface Choice<T extends string> {
  name: string;
  label: string;
  value: T;
  options: readonly (readonly [value: T, label: string])[];
  choose(value: T): void;
}

export const choiceOf = <T extends string>({ name, label, value, options, choose }: Choice<T>): TemplateResult => html`
  <label class="choice">
    <span>${label}</span>
    <select name=${name} .value=${value} @change=${(event: Event) => choose((event.target as HTMLSelectElement).value as T)}>
      ${options.map(([key, text]) => html`<option value=${key} ?selected=${key === value}>${text}</option>`)}
    </select>
  </label>
`;

/** A list for a setting of a scene. */
export const settingChoice = (
  context: Context,
  { name, label, options }: Pick<Choice<string>, "name" | "label" | "options">,
): TemplateResult =>
  choiceOf({
    name,
    label,
    value: choiceSetting(context, name),
    options,
    choose: (value) => context.actions.change({ kind: "settings", settings: { [name]: value } }),
  });
