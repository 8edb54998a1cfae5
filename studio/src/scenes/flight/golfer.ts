/** The shots of a golfer: who it is, where the shots land, how much they differ, and what that costs on a hole. */

import { html, nothing, type TemplateResult } from "lit-html";
import { type Context, choiceSetting, delivered } from "../../context";
import type { Dispersion } from "../../core/types";
import { choiceOf } from "../../parts/choice";
import { settingField } from "../../parts/field";
import { join, withUnit } from "../../quantities/formatter";
import { outputOf } from "../../state/store";
import { COUNT, DRAWN, PERCENTILES, withGolfer } from "./golfer-shots";

const ROWS = ["carry", "side", "total", "total_side", "ball_speed", "launch", "azimuth", "backspin", "sidespin"];
/** Parts of a mean that differ by less are the same. */
const SAME = 1e-9;

export const takeGolfer = (context: Context, name: string): void =>
  context.actions.change({ kind: "all", state: withGolfer(context, name) });

export function golferPanel(context: Context): TemplateResult {
  const { equipment, state, model } = context;
  const name = choiceSetting(context, "golfer");
  const golfer = equipment.golfers[name];
  const shots = outputOf(model, "dispersion");
  const isOwn =
    golfer.club === state.club &&
    golfer[state.hand].mean.every((mean, i) => {
      const there = delivered(context, golfer[state.hand].variables[i]);
      return Math.abs(there - mean) <= SAME * Math.max(1, Math.abs(mean));
    });
  return html`
    <section aria-labelledby="golfer">
      <h2 id="golfer">Where a golfer's shots land</h2>
      <div class="wide-choice">
        ${choiceOf({
          name: "golfer",
          label: "Golfer",
          value: name,
          options: Object.entries(equipment.golfers).map(([key, { title }]) => [key, title]),
          choose: (next) => takeGolfer(context, next),
        })}
      </div>
      <p>
        ${
          isOwn
            ? html`The mean delivery is this golfer's own.`
            : html`The golfer's scatter about the delivery set by the sliders.
                <button type="button" class="quiet" @click=${() => takeGolfer(context, name)}>The golfer's own delivery</button>`
        }
        ${COUNT} shots; the first ${DRAWN} are drawn, with the ellipses that contain 50% and 90% of them.
      </p>
      ${shots ? results(context, shots) : html`<p aria-busy="true">The shots are being computed …</p>`}
      <details>
        <summary>Where the figures of this golfer come from</summary>
        <dl class="sources">
          ${golfer.sources.map(([figures, source]) => html`<dt>${figures}</dt><dd>${source}</dd>`)}
        </dl>
      </details>
    </section>
  `;
}

function results(context: Context, shots: Dispersion): TemplateResult {
  return html`
    ${spreadTable(context, shots)}
    <ul class="ellipses">${shots.ellipses.map((each) => html`<li>${ellipseInWords(context, each)}</li>`)}</ul>
    ${
      shots.lost
        ? html`<p class="remark">${shots.lost} of the shots could not be computed, such as those that miss the face.</p>`
        : nothing
    }
    ${onHole(context, shots)}
  `;
}

function spreadTable({ formatter, state, model }: Context, { quantities }: Dispersion): TemplateResult {
  const { system } = state;
  return html`
    <div class="scroll" tabindex="0" role="region" aria-label="Table of the golfer's shots">
      <table class="spreads" data-milliseconds=${model.results.dispersion.milliseconds}>
        <caption>Over all shots: mean, standard deviation and percentiles</caption>
        <thead>
          <tr>
            <th scope="col">Quantity</th>
            <th scope="col">Mean</th>
            <th scope="col" title="standard deviation from shot to shot">±</th>
            ${PERCENTILES.map(
              (share) =>
                html`<th scope="col" title=${`${Math.round(100 * share)}% of the shots stay below`}>
                  ${Math.round(100 * share)}%
                </th>`,
            )}
          </tr>
        </thead>
        <tbody>
          ${ROWS.map((name) => {
            const { mean, spread, percentiles } = quantities[name];
            const { unit, digits } = formatter.reading(name, system);
            const { label, meaning } = formatter.quantity(name);
            const symbol = formatter.units.symbol(unit);
            const cell = (part: string, value: number): TemplateResult => {
              const { number, side } = formatter.show(name, value, system);
              return html`<td data-spread=${name} data-part=${part} data-value=${String(value)}>${number} ${side}</td>`;
            };
            return html`<tr>
              <th scope="row" title=${meaning}>${withUnit(label, symbol)}</th>
              ${cell("mean", mean)}
              <td data-spread=${name} data-part="spread" data-value=${String(spread)}>
                ${formatter.format(formatter.units.differenceFromSi(spread, unit), digits)}
              </td>
              ${percentiles.map((value, i) => cell(String(PERCENTILES[i]), value))}
            </tr>`;
          })}
        </tbody>
      </table>
    </div>
  `;
}

/** An ellipse in words: its length and width, and where it points. */
function ellipseInWords(
  { formatter, state }: Context,
  { share, half_axes: [long, short], angle }: Dispersion["ellipses"][number],
): string {
  const { unit, digits } = formatter.reading("side", state.system);
  const size = (half: number): string =>
    join(formatter.format(formatter.units.fromSi(2 * half, unit), digits), formatter.units.symbol(unit));
  // A long axis has two ends; that within a quarter turn of the target is the one to name.
  const turn = Math.atan(Math.tan(angle));
  const across = formatter.text("azimuth", turn, state.system);
  return (
    `${Math.round(100 * share)}% of the landings: an ellipse ${size(long)} long and ${size(short)} wide, ` +
    `its long axis ${across} of the target line.`
  );
}

const LIES = ["green", "fairway", "rough", "recovery"];

function onHole(context: Context, { strokes, lies }: Dispersion): TemplateResult {
  const { formatter, state, equipment } = context;
  const { units } = formatter;
  const text = (metres: number): string => formatter.text("total", metres, state.system);
  const { fairway, rough } = equipment.hole;
  return html`
    <h3>On a hole</h3>
    ${settingField(context, {
      name: "hole",
      label: "Length of the hole",
      range: [units.toSi({ value: 100, unit: "yd" }), units.toSi({ value: 600, unit: "yd" })],
    })}
    <p>
      After this shot a tour player would need
      <b data-strokes=${String(strokes)}>${formatter.format(strokes ?? Number.NaN, 2)}</b> more strokes on average.
      Balls at rest:
      ${LIES.map((name, i) => `${i ? ", " : ""}${name} ${formatter.format(100 * (lies[name] ?? 0), 0)}%`)}.
    </p>
    <p class="remark">
      Straight and level; fairway ${text(fairway)} wide with ${text(rough)} of rough on either side, trees beyond. Strokes
      to hole out: averages of the PGA Tour (Broadie).
    </p>
  `;
}
