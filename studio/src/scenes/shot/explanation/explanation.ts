/** One number: what it means, its equation with the values of this shot, what makes it, and how certain it is. */

import { html, nothing, type TemplateResult } from "lit-html";
import fontLicense from "../../../../../docs/_static/fonts/stix-two-math-license.txt?url";
import { type Context, choiceSetting, strike } from "../../../context";
import type { Values } from "../../../core/types";
import { printedSymbol } from "../../../quantities/formatter";
import { mathOf, symbolMath, valueMath } from "../../../quantities/math";
import { evaluate, namesIn, type Tree } from "../../../quantities/tree";
import { outputOf } from "../../../state/store";
import { certaintyOf, sourcesOf } from "./certainty";
import { contributionsTable } from "./contributions";
import { contactMotion, flightMotion } from "./motion";
import { termsOf } from "./terms";

/** Least relative agreement of an equation with the number: a model may not keep momentum, for example. */
const AGREES = 1e-6;

/** The number that is explained, "" for none. */
export const explained = (context: Context): string => choiceSetting(context, "number");

/** What a press on a number does: its explanation opens, or closes where it is open. */
export function explain(context: Context, name: string): void {
  const next = explained(context) === name ? null : name;
  context.actions.change({ kind: "settings", settings: { number: next } });
  document.querySelector<HTMLElement>(".explanation")?.focus({ preventScroll: true });
}

/** A number's name, which opens its explanation. */
export const numberButton = (context: Context, name: string, content: unknown): TemplateResult => html`
  <button
    type="button"
    class="number"
    aria-haspopup="dialog"
    aria-expanded=${explained(context) === name ? "true" : "false"}
    title="What it means, its equation, and how certain it is"
    @click=${() => explain(context, name)}
  >
    ${content}
  </button>
`;

export function explanation(context: Context): TemplateResult | typeof nothing {
  const name = explained(context);
  const shot = context.model.good;
  if (!name || !shot || !(name in shot.values)) return nothing;
  const { formatter, state } = context;
  const { label, meaning, sign } = formatter.quantity(name);
  const value = shot.values[name];
  const isFlown = context.description.flight_outputs.some((each) => each.name === name);
  const close = (): void => {
    explain(context, name);
    document.querySelector<HTMLElement>(`[data-explains="${name}"] button`)?.focus();
  };
  const sources = sourcesOf(context, name);
  return html`
    <section
      class="explanation"
      role="dialog"
      aria-labelledby="explained"
      tabindex="-1"
      @keydown=${(event: KeyboardEvent) => event.key === "Escape" && close()}
    >
      <div class="heading">
        <h3 id="explained">${label}: ${Number.isFinite(value) ? formatter.text(name, value, state.system) : "not computed"}</h3>
        <button type="button" aria-label=${`Close: ${label}`} @click=${close}>Close</button>
      </div>
      <p>${sentence(meaning)} ${sign ? sentence(sign) : nothing}</p>
      ${Number.isFinite(value) ? equations(context, name, value) : nothing} ${isFlown ? ofFlight(context, name) : nothing}
      ${contributionsTable(context, name)}
      <h4>How certain it is</h4>
      ${certaintyOf(context, name)} ${isFlown ? nothing : ofImpact(context)}
      ${
        sources.length
          ? html`<details>
              <summary>Sources</summary>
              <ul>${sources.map((source) => html`<li>${source}</li>`)}</ul>
              <p><a href=${fontLicense}>Licence of the font of the formulas</a></p>
            </details>`
          : nothing
      }
    </section>
  `;
}

const sentence = (text: string): string => `${text.charAt(0).toUpperCase()}${text.slice(1)}.`;

/** All values by name: inputs, outputs, and what equations need beyond them. */
function valuesOf(context: Context): Values {
  const { description, model } = context;
  const { inputs } = strike(context);
  const given: Values = Object.fromEntries(description.inputs.map(({ name }, i) => [name, inputs[i]]));
  const outputs = model.good?.values ?? {};
  return { ...given, ...outputs, ...termsOf(given, outputs, outputOf(model, "slopes")) };
}

function equations(context: Context, name: string, value: number): TemplateResult | typeof nothing {
  const values = valuesOf(context);
  const kept = (context.equipment.numbers.equations[name] ?? []).filter(({ tree }) => {
    const computed = evaluate(tree, values);
    return Math.abs(computed - value) <= AGREES * Math.max(1, Math.abs(value));
  });
  if (!kept.length) return nothing;
  const names = [...new Set(kept.flatMap(({ tree }) => namesIn(tree)))];
  return html`
    ${kept.map(({ title, tree }) => html`<h4>${title}</h4>${equation(context, name, tree, values)}`)}
    <ul class="symbols" aria-label="Symbols">
      ${names.map((each) => html`<li><math>${symbol(context, each)}</math> ${labelOf(context, each)}</li>`)}
    </ul>
  `;
}

function equation(context: Context, name: string, tree: Tree, values: Values): TemplateResult {
  const live = (each: string, isBase: boolean): TemplateResult => liveValue(context, each, values[each], isBase);
  return html`
    <div class="formula" tabindex="0" role="group" aria-label="Equation">
      <math display="block" data-computed=${String(evaluate(tree, values))}>
        ${symbol(context, name)}<mo>=</mo>${mathOf(tree, (each) => symbol(context, each))}
      </math>
      <math display="block">
        ${symbol(context, name)}<mo>=</mo>${mathOf(tree, live)}<mo>=</mo>${liveValue(context, name, evaluate(tree, values))}
      </math>
    </div>
  `;
}

/** The quantity that gives unit and digits of a name, its symbol and what it is called. */
function namedBy({ equipment, formatter }: Context, name: string): { quantity: string; symbol: string; label: string } {
  const term = equipment.numbers.terms[name];
  if (term) return term;
  const { symbol, label } = formatter.quantity(name);
  return { quantity: name, symbol, label };
}

function symbol(context: Context, name: string): TemplateResult {
  const [letter, index] = printedSymbol(namedBy(context, name).symbol);
  const [greek] = printedSymbol(index);
  return symbolMath(letter, greek);
}

const labelOf = (context: Context, name: string): string => namedBy(context, name).label;

/** A value as it is read, with its sign in front instead of a word. */
function liveValue(context: Context, name: string, si: number, isBase = false): TemplateResult {
  const { formatter, state } = context;
  const { unit, digits } = formatter.reading(namedBy(context, name).quantity, state.system);
  return valueMath(formatter.format(formatter.units.fromSi(si, unit), digits), formatter.units.symbol(unit), isBase);
}

/** What is integrated where a number of the flight is no formula of others. */
function ofFlight(context: Context, name: string): TemplateResult {
  const { formatter, state, model } = context;
  const values = model.good?.values ?? {};
  const start = ["ball_speed", "launch", "azimuth", "total_spin", "spin_axis"].map(
    (each) => `${formatter.quantity(each).label} ${formatter.text(each, values[each], state.system)}`,
  );
  const { label, quantity } = context.equipment.numbers.terms["spin_parameter"];
  const spin = formatter.text(quantity, valuesOf(context)["spin_parameter"], state.system);
  return html`
    <h4>Where it comes from</h4>
    <p>Integrated over the flight, from ${start.join(", ")}:</p>
    <div class="formula" tabindex="0" role="group" aria-label="Equations of the flight">${flightMotion()}</div>
    <p>
      Weight, drag against the velocity through the air, and lift across it and the spin axis. Drag and lift follow from
      the ${label}: at the start ${spin}.
      ${name.startsWith("total") ? "Then the ball bounces and rolls on the ground that is chosen." : nothing}
    </p>
  `;
}

/** What the model solves or integrates. */
function ofImpact({ description, state }: Context): TemplateResult | typeof nothing {
  const entry = description.models.find((each) => each.name === state.model);
  if (!entry) return nothing;
  const { kind, title, summary, reference } = entry;
  return html`
    <h4>Where it comes from</h4>
    ${
      kind === "contact"
        ? html`<p>Integrated over the contact, until the ball leaves, with the force F of the model, ${title}:</p>
            <div class="formula" tabindex="0" role="group" aria-label="Equations of the contact">${contactMotion()}</div>`
        : html`<p>Solved at once by the model, ${title}, for the impulse between head and ball.</p>`
    }
    <p class="remark">${summary} Source: ${reference}.</p>
  `;
}
