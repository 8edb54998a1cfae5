/** What changes with the designed club, and by how much: for the same strike, and for a golfer's shots. */

import { html, nothing, type TemplateResult } from "lit-html";
import { type Context, choiceSetting } from "../../context";
import type { Dispersion } from "../../core/types";
import { slopeOf } from "../../equipment/design";
import { settingChoice } from "../../parts/choice";
import { LAUNCH_AND_FLIGHT } from "../../quantities/compared";
import { join, withUnit } from "../../quantities/formatter";
import { outputOf } from "../../state/store";
import { speedRemark } from "./club-panel";
import { designedValue, setups } from "./designed";
import { AXES, STRIKE, type Variable } from "./settings";

interface Row {
  label: string;
  quantity: string;
  own: number;
  designed: number;
  /** Whether its sign says nothing of sides. */
  isSpread?: boolean;
}

export function changesPanel(context: Context): TemplateResult {
  const { model, formatter } = context;
  const design = outputOf(model, "design");
  const failure = design?.designed.failure ?? design?.own.failure;
  const rows = (design ? LAUNCH_AND_FLIGHT : [])
    .map((name) => ({
      label: formatter.quantity(name).label,
      quantity: name,
      own: design?.own.values[name] ?? Number.NaN,
      designed: design?.designed.values[name] ?? Number.NaN,
    }))
    .filter(({ own, designed }) => Number.isFinite(own) || Number.isFinite(designed));
  return html`
    <section aria-labelledby="changes">
      <h2 id="changes">What changes</h2>
      <p class="failure" role="alert">
        ${failure ? `This club cannot be computed. ${formatter.quantity(failure.input).label}: ${failure.message}.` : nothing}
      </p>
      ${design ? table(context, "The same strike", rows) : html`<p aria-busy="true">The shots are being computed …</p>`}
      <p class="remark">One degree more loft on the club is taken as one degree more at impact.</p>
      ${speedRemark(context)}
      <div class="choices">
        ${settingChoice(context, {
          name: "heavier",
          label: "With more mass, club speed",
          options: [
            ["slower", "falls"],
            ["same", "stays"],
          ],
        })}
        ${settingChoice(context, { name: "struck_by", label: "Shots of", options: golferOptions(context) })}
      </div>
      ${averages(context)}
      <div class="steps">
        <h3>What small changes do</h3>
        <ul class="chips">${AXES.map((each) => html`<li>${chip(context, each)}</li>`)}</ul>
        <p class="remark">Computed from exact derivatives for this club and strike. Click a change to make it.</p>
      </div>
    </section>
  `;
}

function golferOptions({ equipment, state }: Context): [string, string][] {
  const own = Object.entries(equipment.golfers);
  const kind = (club: string): boolean => equipment.clubs[club]?.kind === "iron";
  // Those who hit a club of this kind come first.
  const fits = ([, { club }]: (typeof own)[number]): number => Number(kind(club) !== kind(state.club));
  const sorted = [...own].sort((one, other) => fits(one) - fits(other));
  return [[STRIKE, "the strike alone"], ...sorted.map(([name, { title }]): [string, string] => [name, title])];
}

function averages(context: Context): TemplateResult | typeof nothing {
  const golfer = choiceSetting(context, "struck_by");
  if (golfer === STRIKE) return nothing;
  const average = outputOf(context.model, "average");
  const failure = context.model.results["average"]?.failure;
  if (failure)
    return html`<p class="failure" role="alert">The shots of this golfer cannot be computed: ${failure}.</p>`;
  if (!average) return html`<p aria-busy="true">The shots of the golfer are being computed …</p>`;
  const { own, designed } = average;
  const both = (label: string, quantity: string, value: (dispersion: Dispersion) => number, isSpread = false): Row => ({
    label,
    quantity,
    own: value(own),
    designed: value(designed),
    isSpread,
  });
  const mean = (name: string): Row =>
    both(`mean ${context.formatter.quantity(name).label}`, name, ({ quantities }) => quantities[name].mean);
  const spread = (name: string, label: string): Row =>
    both(label, name, ({ quantities }) => quantities[name].spread, true);
  const { title } = context.equipment.golfers[golfer];
  const caption = `${title}: ${own.shots} shots scattered over the face, the same for both clubs`;
  const lost = [own, designed].map(({ lost: missed, shots }) => context.formatter.format((100 * missed) / shots, 1));
  return html`
    ${table(context, caption, [
      mean("ball_speed"),
      mean("carry"),
      mean("total"),
      mean("side"),
      spread("carry", "carry, standard deviation"),
      spread("side", "side, standard deviation"),
      spread("ball_speed", "ball speed, standard deviation"),
    ])}
    ${lost.some((share) => Number(share.replace(",", ".")) > 0) ? html`<p class="remark">Shots that miss the face: ${lost[0]}% with the club's own numbers, ${lost[1]}% as designed; they are left out.</p>` : nothing}
  `;
}

function table(context: Context, caption: string, rows: Row[]): TemplateResult {
  const { formatter, state } = context;
  const text = ({ quantity, isSpread }: Row, value: number): string => {
    if (!Number.isFinite(value)) return "–";
    const { number, side } = formatter.show(quantity, value, state.system);
    return isSpread ? number : [number, side].filter(Boolean).join(" ");
  };
  const difference = ({ quantity, own, designed, isSpread }: Row): string => {
    if (!Number.isFinite(designed - own)) return "–";
    return formatter.difference(quantity, designed - own, state.system, { hasSides: !isSpread });
  };
  return html`<div class="scroll" tabindex="0" role="region" aria-label=${caption}>
    <table class="changes">
      <caption>${caption}</caption>
      <thead>
        <tr><th scope="col">Quantity</th><th scope="col">Original</th><th scope="col">Designed</th><th scope="col">Difference</th></tr>
      </thead>
      <tbody>
        ${rows.map((row) => {
          const symbol = formatter.units.symbol(formatter.reading(row.quantity, state.system).unit);
          const { meaning } = formatter.quantity(row.quantity);
          return html`<tr>
            <th scope="row" title=${meaning}>${withUnit(row.label, symbol)}</th>
            <td data-own=${row.quantity} data-value=${String(row.own)}>${text(row, row.own)}</td>
            <td data-quantity=${row.isSpread ? `${row.quantity}-spread` : row.quantity} data-value=${String(row.designed)}>
              <b>${text(row, row.designed)}</b>
            </td>
            <td data-difference=${row.quantity}>${difference(row)}</td>
          </tr>`;
        })}
      </tbody>
    </table>
  </div>`;
}

function chip(context: Context, { name, more, step, unit }: Variable): TemplateResult {
  const { formatter, state, actions } = context;
  const { units } = formatter;
  const { slopes = {} } = outputOf(context.model, "design") ?? {};
  const size = units.toSi({ value: step, unit });
  const { designed } = setups(context);
  const effects = ["carry", "side", "ball_speed"].map((output) => {
    const slope = slopes[output] ? slopeOf(designed, slopes[output], name) : Number.NaN;
    const { digits } = formatter.reading(output, state.system);
    const shown = Number.isFinite(slope) ? formatter.difference(output, slope * size, state.system) : "";
    const isNothing = !Number(
      units.differenceFromSi(slope * size, formatter.reading(output, state.system).unit).toFixed(digits),
    );
    return !shown || isNothing ? "" : output === "side" ? shown : `${shown} ${formatter.quantity(output).label}`;
  });
  const isKnown = Object.keys(slopes).length > 0;
  const value = designedValue(context, name);
  const take = (): void => {
    const next = units.fromSi(value, unit) + step;
    const { digits } = formatter.reading(name, state.system);
    actions.change({ kind: "settings", settings: { [name]: { value: Number(next.toFixed(digits + 1)), unit } } });
  };
  const carry = slopes["carry"] ? slopeOf(designed, slopes["carry"], name) * size : Number.NaN;
  return html`<button type="button" data-name=${name} data-carry=${String(carry)} ?disabled=${!Number.isFinite(value)} @click=${take}>
    <span>${join(formatter.format(step, 0), units.symbol(unit), more)}</span>
    <b>${isKnown ? effects.filter(Boolean).join(", ") || "no difference" : "…"}</b>
  </button>`;
}
