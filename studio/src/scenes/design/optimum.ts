/** The optimum chart: what is looked for over two numbers of the club, with what is allowed, and where the club is. */

import { html, nothing, type TemplateResult } from "lit-html";
import { type Context, choiceSetting } from "../../context";
import type { Objective, Optimum, OptimumInput } from "../../core/design";
import { slopeOf } from "../../equipment/design";
import { settingChoice } from "../../parts/choice";
import { join } from "../../quantities/formatter";
import { outputOf } from "../../state/store";
import { designedValue, ownValue, reachOf, setups, spaceOf, verdicts } from "./designed";
import { optimumPicture } from "./optimum-picture";
import { AXES, OBJECTIVES, type ObjectiveName, STRIKE, type Variable } from "./settings";

/** Points along each axis, and shots at each: contact models take some hundred times as long as impulses. */
const EFFORT = {
  impulse: { strike: 33, golfer: 15, shots: 256 },
  contact: { strike: 13, golfer: 7, shots: 32 },
};

/** Axes that people ask for. */
const PRESETS: readonly (readonly [across: string, upwards: string, label: string])[] = [
  ["cg_x", "cg_y", "CG: depth and height"],
  ["cg_x", "iyy", "Inertia against CG depth"],
  ["static_loft", "cg_y", "Loft and CG height"],
  ["bulge", "roll", "Bulge and roll"],
];

export const variableNamed = (name: string): Variable => AXES.find((each) => each.name === name) ?? AXES[0];

/** The two axes, which are never the same. */
export function axesOf(context: Context): [Variable, Variable] {
  const across = choiceSetting(context, "across");
  const upwards = choiceSetting(context, "upwards");
  const other = upwards === across ? AXES.find(({ name }) => name !== across)?.name : upwards;
  return [variableNamed(across), variableNamed(other ?? upwards)];
}

/** What is looked for; one strike has no spread. */
export function objectiveName(context: Context): ObjectiveName {
  const name = OBJECTIVES.find((each) => each === choiceSetting(context, "best")) ?? "carry";
  return name === "spread" && choiceSetting(context, "struck_by") === STRIKE ? "carry" : name;
}

function objectiveOf(context: Context): Objective {
  const name = objectiveName(context);
  if (name === "spread") return { output: "side", part: "spread", sign: -1 };
  return { output: name, part: choiceSetting(context, "struck_by") === STRIKE ? "value" : "mean", sign: 1 };
}

export function objectiveLabel({ formatter }: Context, { output, part }: Objective): string {
  if (part === "spread") return "spread to the side, standard deviation";
  return part === "mean" ? `mean ${formatter.quantity(output).label}` : formatter.quantity(output).label;
}

/** What the chart needs computed. */
export function optimumInput(context: Context): OptimumInput {
  const { designed } = setups(context);
  const all = verdicts(context);
  const axes = axesOf(context);
  const isElsewhere = all.some(({ of, conforms }) => conforms === false && !axes.some(({ name }) => name === of));
  const kind = context.description.models.find(({ name }) => name === context.state.model)?.kind ?? "impulse";
  const { strike, golfer, shots } = EFFORT[kind];
  const axis = (variable: Variable): OptimumInput["axes"][number] => {
    const limit = all.find(({ of }) => of === variable.name)?.limit ?? Number.MAX_VALUE;
    return { name: variable.name, range: reachOf(context, variable), most: isElsewhere ? -Number.MAX_VALUE : limit };
  };
  return {
    setup: designed,
    objective: objectiveOf(context),
    axes: [axis(axes[0]), axis(axes[1])],
    space: spaceOf(context),
    points: designed.golfer ? golfer : strike,
    shots,
  };
}

export function optimumPanel(context: Context): TemplateResult {
  const { model, actions } = context;
  const result = model.results["optimum"];
  const optimum = outputOf(model, "optimum");
  const labels: [string, string][] = AXES.map(({ name, label }) => [name, label]);
  const isStrike = choiceSetting(context, "struck_by") === STRIKE;
  const [across, upwards] = axesOf(context);
  return html`
    <section aria-labelledby="optimum">
      <h2 id="optimum">Where the best club lies</h2>
      <div class="presets" role="group" aria-label="Charts">
        ${PRESETS.map(
          ([x, y, label]) => html`<button
            type="button"
            class="quiet"
            aria-pressed=${String(across.name === x && upwards.name === y)}
            @click=${() => actions.change({ kind: "settings", settings: { across: x, upwards: y } })}
          >
            ${label}
          </button>`,
        )}
      </div>
      <div class="choices">
        ${settingChoice(context, { name: "across", label: "Across", options: labels.filter(([name]) => name !== upwards.name) })}
        ${settingChoice(context, { name: "upwards", label: "Upwards", options: labels.filter(([name]) => name !== across.name) })}
        ${settingChoice(context, { name: "best", label: "Objective", options: objectives(context, isStrike) })}
      </div>
      ${result?.failure ? html`<p class="failure" role="alert">The chart cannot be computed: ${result.failure}.</p>` : nothing}
      ${
        optimum
          ? html`${optimumPicture(context, optimum)} ${words(context, optimum)} ${table(context, optimum)}`
          : html`<p aria-busy="true">The chart is being computed …</p>`
      }
      ${result && result.share !== null ? html`<progress aria-label="Chart" max="1" value=${result.share}></progress>` : nothing}
      ${isStrike ? html`<p class="remark">For means and the spread of scattered shots choose a golfer under “Shots of”.</p>` : nothing}
    </section>
  `;
}

function objectives({ formatter }: Context, isStrike: boolean): [string, string][] {
  return OBJECTIVES.filter((name) => name !== "spread" || !isStrike).map((name) => [
    name,
    name === "spread" ? "least spread to the side" : `most ${isStrike ? "" : "mean "}${formatter.quantity(name).label}`,
  ]);
}

/** How the value grows along both axes at the designed club [SI]. */
export function slopesOf(context: Context, { objective, axes, slopes }: Optimum): [number, number] | null {
  if (slopes) return slopes;
  const exact = outputOf(context.model, "design")?.slopes[objective.output];
  const { designed } = setups(context);
  return exact ? [slopeOf(designed, exact, axes[0].name), slopeOf(designed, exact, axes[1].name)] : null;
}

function words(context: Context, optimum: Optimum): TemplateResult {
  const { formatter, state, actions } = context;
  const { objective, axes, best, here } = optimum;
  const text = (si: number): string => {
    const { number, unit, side } = formatter.show(objective.output, si, state.system);
    return join(number, unit, objective.part === "spread" ? "" : side);
  };
  const place = (x: number, y: number): string =>
    [x, y]
      .map(
        (value, i) =>
          `${inSentence(variableNamed(axes[i].name).label)} ${formatter.text(axes[i].name, value, state.system)}`,
      )
      .join(", ");
  const go = (): void => {
    if (!best) return;
    const settings = axes.map(({ name }, i) => {
      const { unit, digits } = formatter.reading(name, state.system);
      const value = formatter.units.fromSi(i ? best.y : best.x, unit);
      return [name, { value: rounded(value, digits + 2), unit }] as const;
    });
    actions.change({ kind: "settings", settings: Object.fromEntries(settings) });
  };
  const own = axes.map(({ name }) => ownValue(context, name));
  return html`
    <div class="best-club" aria-live="polite">
      <p data-here=${String(here)}>
        <b>You are here</b>: ${objectiveLabel(context, objective)} ${text(here)} at
        ${place(designedValue(context, axes[0].name), designedValue(context, axes[1].name))}.
        ${own.every(Number.isFinite) ? html`The club's own: ${place(own[0], own[1])}.` : nothing}
      </p>
      ${
        best
          ? html`<p data-best=${String(best.value)}>
              <b>The best</b> within the rules that can be built, all else as it is: ${text(best.value)} at
              ${place(best.x, best.y)}${isAtEdge(optimum) ? ", at the end of an axis" : ""}.
              <button type="button" class="quiet" @click=${go}>Go there</button>
            </p>`
          : html`<p><b>No club</b> on this chart is within the rules and can be built: change something else first.</p>`
      }
      <p>${gradientWords(context, optimum)}</p>
    </div>
  `;
}

/** A label within a sentence. */
const inSentence = (label: string): string =>
  label.startsWith("CG") ? label : label.charAt(0).toLowerCase() + label.slice(1);

const rounded = (value: number, digits: number): number => Number(value.toFixed(digits));

/** Whether the best place would perhaps lie beyond what the chart shows. */
const isAtEdge = ({ axes, best }: Optimum): boolean =>
  best !== null &&
  axes.some(({ range: [least, most] }, i) => {
    const value = i ? best.y : best.x;
    return Math.min(value - least, most - value) < 1e-6 * (most - least);
  });

function gradientWords(context: Context, optimum: Optimum): string {
  const { formatter, state } = context;
  const slopes = slopesOf(context, optimum);
  if (!slopes?.every(Number.isFinite)) return "";
  const { objective, axes } = optimum;
  const steps = axes.map(({ name }, i) => {
    const { step, unit, more } = variableNamed(name);
    const size = formatter.units.toSi({ value: step, unit });
    const symbol = formatter.units.symbol(unit);
    const change = formatter.difference(objective.output, slopes[i] * size, state.system, {
      hasSides: objective.part !== "spread",
    });
    return `${join(formatter.format(step, 0), symbol, more)}: ${change}`;
  });
  const origin = optimum.slopes ? "differences over the same shots" : "exact derivatives";
  return `Effect of a small change from here, by ${origin}: ${steps.join("; ")}.`;
}

const ROWS = 5;

function table(context: Context, optimum: Optimum): TemplateResult {
  const { formatter, state } = context;
  const { axes, objective, x, y, values, isAllowed } = optimum;
  const some = (places: number[]): number[] =>
    Array.from({ length: ROWS }, (_, i) => Math.round((i * (places.length - 1)) / (ROWS - 1)));
  const unit = formatter.units.symbol(formatter.reading(objective.output, state.system).unit);
  return html`<details>
    <summary>The chart as a table</summary>
    <div class="scroll" tabindex="0" role="region" aria-label="The chart as a table">
      <table>
        <caption>${objectiveLabel(context, objective)}, ${unit}; values in brackets break a rule or cannot be built</caption>
        <thead>
          <tr>
            <th scope="col">${variableNamed(axes[1].name).label} \\ ${variableNamed(axes[0].name).label}</th>
            ${some(x).map((i) => html`<th scope="col">${formatter.text(axes[0].name, x[i], state.system)}</th>`)}
          </tr>
        </thead>
        <tbody>
          ${some(y).map(
            (j) => html`<tr>
              <th scope="row">${formatter.text(axes[1].name, y[j], state.system)}</th>
              ${some(x).map((i) => {
                const at = j * x.length + i;
                const { number } = formatter.show(objective.output, Math.abs(values[at]), state.system);
                return html`<td>${Number.isFinite(values[at]) ? (isAllowed[at] ? number : `(${number})`) : "–"}</td>`;
              })}
            </tr>`,
          )}
        </tbody>
      </table>
    </div>
  </details>`;
}
