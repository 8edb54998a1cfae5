/** Numbers of the impacts: the launch next to that of the chosen model, the contact, and what the computation took. */

import { html, nothing, type TemplateResult } from "lit-html";
import type { Context } from "../../context";
import type { ElementsImpact } from "../../core/elements";
import type { Values } from "../../core/types";
import { modelName } from "../../equipment/names";
import { IMPACT_AND_FLIGHT } from "../../quantities/compared";
import { withUnit } from "../../quantities/formatter";
import { outputOf } from "../../state/store";
import { ballOf } from "./case";
import { flightSlot, modelSlot, type ShownCase } from "./impacts";

const THROWN = ["normal_velocity", "tangential_velocity", "backspin"];
const CONTACT = [
  "peak_force",
  "peak_force_time",
  "contact_time",
  "tangential_max",
  "tangential_min",
  "reversal_time",
  "spin_max",
  "contraction",
  "contraction_time",
  "f_prime",
  "f",
];
const COST = ["energy_error", "steps", "step", "wall"];

export interface NamedCase extends ShownCase {
  label: string;
}

export function numbersTables(context: Context, cases: NamedCase[]): TemplateResult {
  const shown = cases.flatMap((each) => (each.impact ? [{ ...each, impact: each.impact }] : []));
  const summary = (impact: ElementsImpact): Values => impact.summary as unknown as Values;
  const launched = shown.filter(({ setup }) => setup.against !== "plane");
  const thrown = shown.filter(({ setup }) => setup.against === "plane");
  const launches = launched.flatMap(({ name, label, impact }) => {
    const flight = outputOf(context.model, "flight", flightSlot(name)) ?? {};
    const reduced = outputOf(context.model, "shot", modelSlot(name));
    const columns = [{ label: named("finite elements", label, shown), values: { ...impact.launch, ...flight } }];
    if (reduced && !reduced.failure)
      columns.push({
        label: named(`${modelName(context, reduced.model)}, rigid head`, label, shown),
        values: reduced.values,
      });
    return columns;
  });
  const contact = shown.map(({ label, impact }) => ({ label: label || "Value", values: summary(impact) }));
  return html`
    ${launches.length ? table(context, "Launch and flight, next to the chosen model", IMPACT_AND_FLIGHT, launches) : nothing}
    ${launches.length ? html`<p class="remark">The chosen model takes the head as rigid, and friction as its own parameters have it.</p>` : nothing}
    ${
      thrown.length
        ? table(
            context,
            "After the throw at a plane",
            THROWN,
            thrown.map(({ label, impact }) => ({ label: label || "Value", values: impact.thrown })),
          )
        : nothing
    }
    ${table(context, "Contact", CONTACT, contact)} ${table(context, "Computation", COST, contact, elements(context, shown))}
  `;
}

/** A heading that says which case it is of, where there are two. */
const named = (what: string, label: string, cases: unknown[]): string =>
  cases.length > 1 ? `${label}: ${what}` : what;

const elements = (context: Context, cases: ShownCase[]): TemplateResult => html`<tr>
  <th scope="row" title="hexahedra of the ball and shells of a head that deforms">elements</th>
  ${cases.map((each) => html`<td data-quantity="elements">${elementCount(context, each)}</td>`)}
</tr>`;

export function elementCount(context: Context, { setup, mesh }: ShownCase): number {
  const head = context.equipment.elements.heads[setup.against]?.elements ?? 0;
  return (ballOf(context, setup)?.meshes[mesh].elements ?? 0) + head;
}

interface Column {
  label: string;
  values: Values;
}

function table(
  { formatter, state }: Context,
  caption: string,
  names: readonly string[],
  columns: Column[],
  more: TemplateResult | typeof nothing = nothing,
): TemplateResult {
  return html`
    <div class="scroll" tabindex="0" role="region" aria-label=${caption}>
      <table>
        <caption>${caption}</caption>
        <thead>
          <tr><th scope="col">Quantity</th>${columns.map(({ label }) => html`<th scope="col">${label}</th>`)}</tr>
        </thead>
        <tbody>
          ${names.map((name) => {
            const { label, meaning, sign } = formatter.quantity(name);
            const symbol = formatter.units.symbol(formatter.reading(name, state.system).unit);
            return html`<tr>
              <th scope="row" title=${[meaning, sign].filter(Boolean).join(": ")}>${withUnit(label, symbol)}</th>
              ${columns.map(({ values }) => {
                const value = values[name];
                if (value === undefined || value === null || !Number.isFinite(value)) return html`<td>–</td>`;
                const { number, side } = formatter.show(name, value, state.system);
                return html`<td data-quantity=${name} data-value=${String(value)}>${number} ${side}</td>`;
              })}
            </tr>`;
          })}
          ${more}
        </tbody>
      </table>
    </div>
  `;
}
