/** A table of the clubs of a bag with the gaps between them, and the choice of the clubs. */

import { html, type TemplateResult } from "lit-html";
import type { Context } from "../../context";
import { seriesLine, seriesLook } from "../../parts/colours";
import { withUnit } from "../../quantities/formatter";
import { outputOf } from "../../state/store";
import { bagOf, driverSpeed } from "./bag-shots";

const COLUMNS = ["ball_speed", "launch", "total_spin", "apex", "landing_angle", "side", "total"];

export function bagPanel(context: Context): TemplateResult {
  const { equipment, actions, formatter, state } = context;
  const chosen = bagOf(context);
  const driven = formatter.text("speed", formatter.units.toSi(driverSpeed(context)), state.system);
  const toggle = (club: string): void => {
    const bag = chosen.includes(club) ? chosen.filter((each) => each !== club) : [...chosen, club];
    actions.change({ kind: "settings", settings: { bag: bag.join(",") } });
  };
  return html`
    <section aria-labelledby="bag">
      <h2 id="bag">Gaps between the clubs</h2>
      <p>
        Every club is delivered as on tour, with the tour's attack angle and dynamic loft, square and centred, at the speed
        that goes with a driver speed of ${driven}. A club without a tour average is delivered like the nearest club that has
        one, and its loft differs by as much as the clubs' lofts do. If you change the club speed, all clubs change with it.
      </p>
      ${gapTable(context)}
      <details>
        <summary>Choose the clubs</summary>
        <ul class="clubs">
          ${Object.entries(equipment.clubs).map(
            ([club, { label, description }]) => html`<li>
              <label title=${description}>
                <input type="checkbox" name=${`bag-${club}`} .checked=${chosen.includes(club)} @change=${() => toggle(club)} />
                ${label}
              </label>
            </li>`,
          )}
        </ul>
      </details>
    </section>
  `;
}

function gapTable(context: Context): TemplateResult {
  const { model, state, formatter, equipment } = context;
  const shots = outputOf(model, "bag");
  if (!shots) return html`<p aria-busy="true">The clubs are being computed …</p>`;
  // As the picture draws them.
  const places = new Map(shots.filter(({ failure }) => !failure).map(({ club }, place) => [club, place]));
  const longest = shots.filter(({ failure }) => !failure).sort((a, b) => b.values.carry - a.values.carry);
  const failed = shots.filter(({ failure }) => failure);
  const heading = (name: string): TemplateResult => {
    const { label, meaning } = formatter.quantity(name);
    const symbol = formatter.units.symbol(formatter.reading(name, state.system).unit);
    return html`<th scope="col" title=${meaning}>${withUnit(label, symbol)}</th>`;
  };
  const cell = (name: string, value: number): TemplateResult => {
    const { number, side } = formatter.show(name, value, state.system);
    return html`<td data-quantity=${name} data-value=${String(value)}>${number} ${side}</td>`;
  };
  return html`
    <div class="scroll" tabindex="0" role="region" aria-label="Table of the clubs">
      <table class="gaps">
        <caption>From the longest carry to the shortest</caption>
        <thead>
          <tr>
            <th scope="col">Club</th>
            ${heading("carry")}
            <th scope="col" title="how much farther it carries than the next club">
              ${withUnit("gap to the next", formatter.units.symbol(formatter.reading("carry", state.system).unit))}
            </th>
            ${COLUMNS.map(heading)}
          </tr>
        </thead>
        <tbody>
          ${longest.map(({ club, values }, i) => {
            const next = longest[i + 1]?.values.carry;
            return html`<tr data-club=${club}>
              <th scope="row">
                <i class="club-line" style=${seriesLine(seriesLook(places.get(club) ?? 0))}></i>
                ${equipment.clubs[club].label}
              </th>
              ${cell("carry", values.carry)}
              <td data-quantity="gap" data-value=${String(next === undefined ? Number.NaN : values.carry - next)}>
                ${next === undefined ? "–" : formatter.show("carry", values.carry - next, state.system).number}
              </td>
              ${COLUMNS.map((name) => cell(name, values[name]))}
            </tr>`;
          })}
        </tbody>
      </table>
    </div>
    ${failed.map(({ club, failure }) => html`<p class="failure">${equipment.clubs[club].label}: ${failure?.message}</p>`)}
  `;
}
