/** Bars of what the rules limit: the value, the limit, and the tolerance of a measurement above it. */

import { html, type TemplateResult } from "lit-html";
import type { LessonResult } from "../lesson";

export interface Limited {
  /** Name of the rule, and of the quantity that gives unit and digits. */
  rule: string;
  quantity: string;
  value: number;
}

/** How far a bar reaches beyond the limit. */
const REACH = 1.25;

export const isWithin = (result: LessonResult, { rule, value }: Limited): boolean => {
  const { most, tolerance } = result.context.equipment.lessons.rules[rule];
  return value <= (most + tolerance) * (1 + 1e-9);
};

export function limitsPicture(result: LessonResult, limited: Limited[]): TemplateResult {
  return html`
    <figure class="limits">
      <figcaption>Measured by the rules</figcaption>
      ${limited.map((each) => bar(result, each))}
    </figure>
  `;
}

function bar(result: LessonResult, each: Limited): TemplateResult {
  const { title, most, tolerance } = result.context.equipment.lessons.rules[each.rule];
  const percent = (value: number): string => `${Math.min(100, (100 * value) / (REACH * most)).toFixed(2)}%`;
  const fits = isWithin(result, each);
  const words = fits ? (each.value > most ? "conforms within the tolerance" : "conforms") : "does not conform";
  const text = result.text(each.quantity, each.value);
  const limit = `${result.text(each.quantity, most)} + ${result.text(each.quantity, tolerance)}`;
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
