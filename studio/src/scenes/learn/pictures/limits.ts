/** Bars of what the rules limit: the value, the limit, and the tolerance of a measurement above it. */

import { html, type TemplateResult } from "lit-html";
import type { Found } from "../lesson";

export interface Limited {
  /** Name of the rule, and of the quantity that gives unit and digits. */
  rule: string;
  quantity: string;
  value: number;
}

/** How far a bar reaches beyond the limit. */
const REACH = 1.25;

export const isWithin = (found: Found, { rule, value }: Limited): boolean => {
  const { most, tolerance } = found.context.equipment.lessons.rules[rule];
  return value <= (most + tolerance) * (1 + 1e-9);
};

export function limitsPicture(found: Found, limited: Limited[]): TemplateResult {
  return html`
    <figure class="limits">
      <figcaption>Measured by the rules</figcaption>
      ${limited.map((each) => bar(found, each))}
    </figure>
  `;
}

function bar(found: Found, each: Limited): TemplateResult {
  const { title, most, tolerance } = found.context.equipment.lessons.rules[each.rule];
  const percent = (value: number): string => `${Math.min(100, (100 * value) / (REACH * most)).toFixed(2)}%`;
  const fits = isWithin(found, each);
  const words = fits ? (each.value > most ? "conforms within the tolerance" : "conforms") : "does not conform";
  const text = found.text(each.quantity, each.value);
  const limit = `${found.text(each.quantity, most)} + ${found.text(each.quantity, tolerance)}`;
  return html`
    <div class="limit">
      <p>${title}: <b>${text}</b>, ${words}</p>
      <div class="bar" role="img" aria-label=${`${title}: ${text} of at most ${limit} tolerance, ${words}`}>
        <i class=${fits ? "filled" : "filled over"} style=${`width: ${percent(each.value)}`}></i>
        <i class="tolerance" style=${`left: ${percent(most)}; width: ${percent(tolerance)}`}></i>
      </div>
      <small>at most ${limit} tolerance</small>
    </div>
  `;
}
