/** How sure a number is: what the package's comparisons with published figures come to, in words. */

import { html, nothing, type TemplateResult } from "lit-html";
import type { Context } from "../../../context";
import type { PublishedComparison } from "../../../equipment/equipment";
import { ballName, modelName } from "../../../equipment/names";
import { join } from "../../../quantities/formatter";

const PER_CENT = "%";
const ANOTHER_MODEL = "a model";

/** The comparisons of a number with published figures: those of the model for this kind of club, then those of the flight. */
function comparisons({ equipment, state }: Context, name: string): PublishedComparison[] {
  const { models, flights, rows } = equipment.numbers.certainty;
  const kind = equipment.clubs[state.club].published_kind;
  const places = [...(models[state.model]?.[kind]?.[name] ?? []), ...(flights[kind]?.[name] ?? [])];
  const all = places.map((place) => rows[place]);
  const measured = (each: PublishedComparison): number => (each.certainty === ANOTHER_MODEL ? 1 : 0);
  return all.sort((a, b) => measured(a) - measured(b) || b.figures - a.figures);
}

export function certaintyOf(context: Context, name: string): TemplateResult {
  const all = comparisons(context, name);
  const { equipment, state } = context;
  const kind = { driver: "drivers", wood: "fairway woods and hybrids", iron: "irons and wedges" }[
    equipment.clubs[state.club].published_kind
  ];
  if (!all.some(({ certainty }) => certainty !== ANOTHER_MODEL))
    return html`
      <p><b>No measurement supports this number</b> for ${kind} by the model ${modelName(context, state.model)}.</p>
      ${all.length ? html`<p>Another model gives something to compare with, which proves nothing:</p>${list(context, all)}` : nothing}
    `;
  return html`
    <p>Compared with published figures of ${kind}, by the model ${modelName(context, state.model)} with the ball ${ballName(context, "modern")}:</p>
    ${list(context, all)}
  `;
}

/** The comparisons, and what the words for their certainty mean. */
function list(context: Context, all: PublishedComparison[]): TemplateResult {
  const { certainties } = context.equipment.numbers.certainty;
  const words = [...new Set(all.map(({ certainty }) => certainty))];
  return html`
    <ul class="comparisons">${all.map((each) => html`<li>${item(context, each)}</li>`)}</ul>
    ${words.map((word) => html`<p class="remark"><b>${word}:</b> ${certainties[word]}</p>`)}
  `;
}

function item(context: Context, each: PublishedComparison): TemplateResult {
  const read = (value: number): string => error(context, each, value);
  const bias = each.bias === null ? "" : `, mean ${each.bias > 0 ? "+" : "−"}${read(Math.abs(each.bias))}`;
  const figures = each.title.startsWith("Measured shots") ? "measured shots" : "published figures";
  const count = each.figures === 1 ? figures.replace(/s$/, "") : figures;
  return html`
    <b>± ${read(each.size)}</b>${bias} in ${each.quantity} against ${each.figures} ${count}: ${each.title}.
    ${each.within === null || each.tolerance === null ? nothing : html`${each.within} of ${each.figures} within ${read(each.tolerance)}.`}
    (${each.certainty})
  `;
}

/** An error in the unit in which it is read; one of the published value in per cent. */
function error({ formatter, state }: Context, { reads_as }: PublishedComparison, value: number): string {
  if (reads_as === "share") return join(formatter.format(100 * value, 1), PER_CENT);
  const { unit, digits } = formatter.reading(reads_as, state.system);
  const shown = formatter.format(formatter.units.differenceFromSi(value, unit), digits);
  return join(shown, formatter.units.symbol(unit));
}

/** The sources of the comparisons of a number, each once. */
export function sourcesOf(context: Context, name: string): string[] {
  const { sources } = context.equipment.numbers.certainty;
  return [...new Set(comparisons(context, name).flatMap((each) => each.sources))].map((place) => sources[place]);
}
