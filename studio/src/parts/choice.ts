/** A list to choose from. */

import { html, type TemplateResult } from "lit-html";

export interface Choice {
  name: string;
  label: string;
  value: string;
  options: readonly (readonly [value: string, label: string])[];
  choose(value: string): void;
}

export const choiceOf = ({ name, label, value, options, choose }: Choice): TemplateResult => html`
  <label class="choice">
    <span>${label}</span>
    <select name=${name} .value=${value} @change=${(event: Event) => choose((event.target as HTMLSelectElement).value)}>
      ${options.map(([key, text]) => html`<option value=${key} ?selected=${key === value}>${text}</option>`)}
    </select>
  </label>
`;
