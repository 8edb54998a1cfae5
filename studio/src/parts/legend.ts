/** What the colours of a picture mean, with numbers. */

import { html, type TemplateResult } from "lit-html";
import type { Context } from "../context";
import { join } from "../quantities/formatter";
import type { ColourScale } from "./colours";

/** A bar of colours with the values at its ends and in its middle; `quantity` gives unit and digits. */
export function colourLegend(
  { formatter, state }: Context,
  { title, quantity, scale, ends }: { title: string; quantity: string; scale: ColourScale; ends?: [string, string] },
): TemplateResult {
  const { unit, digits } = formatter.reading(quantity, state.system);
  const symbol = formatter.units.symbol(unit);
  const values = [scale.least, (scale.least + scale.most) / 2, scale.most].map((value) =>
    formatter.format(formatter.units.fromSi(value, unit) + 0, digits),
  );
  return html`
    <div class="colours">
      <p>${symbol ? `${title}, ${symbol}` : title}</p>
      <i style=${`background: ${scale.gradient}`} role="img" aria-label=${`Colours from ${join(values[0], symbol)} to ${join(values[2], symbol)}`}></i>
      <p class="ends">${values.map((value) => html`<span>${value}</span>`)}</p>
      ${ends ? html`<p class="ends">${ends.map((end) => html`<span>${end}</span>`)}</p>` : ""}
    </div>
  `;
}
