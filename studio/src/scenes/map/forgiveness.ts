/** What impacts cost that scatter about the impact point of the shot: a person's own or those of a golfer. */

import { html, nothing, type TemplateResult } from "lit-html";
import { type Context, settingSi } from "../../context";
import type { FaceValues } from "../../core/face-map";
import { choiceOf } from "../../parts/choice";
import { settingField } from "../../parts/field";
import { join, withUnit } from "../../quantities/formatter";
import { deviationsOf } from "./golfer-spread";
import { areDetailsOld, clubsOf, detailedMaps } from "./mapped";

/** What is listed first; the rest stands in a second table. */
const LISTED = ["ball_speed", "launch", "backspin", "sidespin", "azimuth", "carry", "side", "total"];
const OWN = "own";
/** Difference of two deviations that are the same [m]. */
const SAME = 5e-5;
/** Least share of swings that miss the face for a remark on them. */
const LEAST_MISSED = 5e-4;
const RANGE = [1e-3, 20e-3] as const;

export function forgivenessPanel(context: Context): TemplateResult {
  const maps = detailedMaps(context, "map-forgiveness");
  const clubs = clubsOf(context);
  return html`
    <section class=${areDetailsOld(context, "map-forgiveness") ? "forgiveness old" : "forgiveness"} aria-labelledby="forgiveness">
      <h2 id="forgiveness">Forgiveness</h2>
      ${golferChoice(context)}
      ${settingField(context, {
        name: "strikes_toe",
        label: "Spread heel to toe",
        range: RANGE,
        meaning: "standard deviation of the impacts towards heel and toe",
      })}
      ${settingField(context, {
        name: "strikes_high",
        label: "Spread low to high",
        range: RANGE,
        meaning: "standard deviation of the impacts up and down the face",
      })}
      <p class="remark">Standard deviations; the impacts scatter about the impact point of the shot.</p>
      ${
        maps?.faces.length === clubs.length
          ? maps.faces.map((face, i) => costs(context, face, context.equipment.clubs[clubs[i]].label, clubs.length > 1))
          : html`<p aria-busy="true">The costs are being computed …</p>`
      }
    </section>
  `;
}

/** A list of golfers, which sets both deviations. */
function golferChoice(context: Context): TemplateResult {
  const { equipment, state, actions } = context;
  const own = [settingSi(context, "strikes_toe"), settingSi(context, "strikes_high")];
  const known = Object.entries(equipment.golfers).map(([name, golfer]) => ({
    name,
    title: golfer.title,
    deviations: deviationsOf(golfer[state.hand]),
  }));
  const same = known.find(({ deviations }) => deviations.every((each, i) => Math.abs(each - own[i]) < SAME));
  const choose = (name: string): void => {
    const golfer = known.find((each) => each.name === name);
    if (!golfer) return;
    const [toe, high] = golfer.deviations.map((each) => ({ value: Number((1e3 * each).toFixed(1)), unit: "mm" }));
    actions.change({ kind: "settings", settings: { strikes_toe: toe, strikes_high: high } });
  };
  return choiceOf({
    name: "golfer",
    label: "Impacts of",
    value: same?.name ?? OWN,
    options: [[OWN, "the spreads below"], ...known.map(({ name, title }) => [name, title] as const)],
    choose,
  });
}

function costs(context: Context, { summary, failure }: FaceValues, club: string, isNamed: boolean): TemplateResult {
  const { forgiveness } = summary;
  if (!forgiveness)
    return html`<p class="mistake" role="alert">${club}: ${failure ? "the impact point is not on the face, or the spread is wider than the face" : "no shot"}.</p>`;
  const rest = summary.quantities.filter((name) => !LISTED.includes(name));
  return html`
    ${table(context, summary, isNamed ? `${club}: what the scatter costs` : "What the scatter costs", LISTED)}
    ${
      forgiveness.missed >= LEAST_MISSED
        ? html`<p class="remark">${join(context.formatter.format(100 * forgiveness.missed, 1), "%")} of the swings miss the face; they do not count.</p>`
        : nothing
    }
    <details>
      <summary>Further quantities</summary>
      ${table(context, summary, isNamed ? club : "Further quantities", rest)}
    </details>
  `;
}

function table(
  { formatter, state }: Context,
  { forgiveness }: FaceValues["summary"],
  title: string,
  names: string[],
): TemplateResult {
  if (!forgiveness) return html``;
  const { mean, deviation, loss } = forgiveness;
  return html`
    <table>
      <caption>${title}</caption>
      <thead>
        <tr>
          <th scope="col">Quantity</th>
          <th scope="col" title="over all impacts that hit the face">On average</th>
          <th scope="col" title="standard deviation from impact to impact">Spread ±</th>
          <th scope="col" title="mean over all strikes minus the value of a strike at the impact point">
            Change by the scatter
          </th>
        </tr>
      </thead>
      <tbody>
        ${names.map((name) => {
          const { unit, digits } = formatter.reading(name, state.system);
          const { number, side } = formatter.show(name, mean[name], state.system);
          const change = formatter.difference(name, -loss[name], state.system, { hasUnit: false, finer: 1 });
          return html`<tr>
            <th scope="row">${withUnit(formatter.quantity(name).label, formatter.units.symbol(unit))}</th>
            <td data-mean=${name} data-value=${String(mean[name])}>${number} ${side}</td>
            <td data-deviation=${name} data-value=${String(deviation[name])}>${formatter.format(formatter.units.differenceFromSi(deviation[name], unit), digits + 1)}</td>
            <td data-loss=${name} data-value=${String(loss[name])}>${change}</td>
          </tr>`;
        })}
      </tbody>
    </table>
  `;
}
