/** The picture of the range with what flies on it, from where it is seen, and the button that plays it. */

import { html, type TemplateResult } from "lit-html";
import { type Context, choiceSetting } from "../../context";
import { conditionsInWords } from "../../parts/conditions";
import { stageFrame } from "../../parts/stage";
import { takeGolfer } from "./golfer";
import { contentOf } from "./range-content";
import { played, RANGE } from "./range-picture";
import { play } from "./range-play";
import { FLYING, VIEWS, viewOf } from "./settings";
import { STEP } from "./turf";

export function rangePanel(context: Context): TemplateResult {
  const { actions, state } = context;
  const [flying, view] = [choiceSetting(context, "flying"), viewOf(context)];
  const fly = (name: string): void => {
    if (name === "golfer" && !state.settings.golfer) takeGolfer(context, choiceSetting(context, "golfer"));
    else {
      // All open as they are usually seen.
      const isOther = name !== flying;
      actions.change({ kind: "settings", settings: { flying: name, ...(isOther ? { range_view: null } : {}) } });
    }
  };
  const see = (name: string): void => {
    if (name === view) played?.look();
    else actions.change({ kind: "settings", settings: { range_view: name } });
  };
  const buttons = (
    label: string,
    all: readonly (readonly [name: string, title: string])[],
    chosen: string,
    choose: (name: string) => void,
  ): TemplateResult => html`
    <div class="segments" role="group" aria-label=${label}>
      ${all.map(
        ([name, title]) => html`
          <button type="button" aria-pressed=${name === chosen} @click=${() => choose(name)}>${title}</button>
        `,
      )}
    </div>
  `;
  return html`
    <section class="range-panel" aria-labelledby="range">
      <h2 id="range">Range</h2>
      <div class="range-tools">
        ${buttons("What flies", FLYING, flying, fly)} ${buttons("Seen", VIEWS, view, see)}
        <button type="button" @click=${() => played && play(played)}>Play</button>
      </div>
      <div data-sized=${RANGE} class=${`seen-${view}`}>${stageFrame(RANGE, inWords(context))}</div>
      <p class="remark">${legend(context)}</p>
    </section>
  `;
}

/** What the lines of the picture are. */
function legend(context: Context): string {
  const { formatter, state } = context;
  const names =
    choiceSetting(context, "flying") === "clubs"
      ? "Names that do not fit are left out; the table lists them all. "
      : "";
  const symbol = formatter.units.symbol(formatter.reading("carry", state.system).unit);
  return (
    `The lines are ${STEP} ${symbol} apart; the thin line after the landing is bounce and roll. ${names}Drag or use the ` +
    "arrow keys to turn the picture, the wheel or + and - to zoom."
  );
}

/** What the picture shows, for who does not see it. */
function inWords(context: Context): string {
  const { formatter, state } = context;
  const { flights, landings } = contentOf(context);
  const text = (name: string, value: number): string => formatter.text(name, value, state.system);
  const each = flights.map(
    ({ name, values }) => `${name} carries ${text("carry", values.carry)}, ${text("side", values.side)}`,
  );
  const first = flights[0]?.values;
  const one =
    flights.length === 1
      ? `, rises to ${text("apex", first.apex)}, comes down at ${text("landing_angle", first.landing_angle)} and rests ` +
        `after ${text("total", first.total)}, ${text("total_side", first.total_side)}`
      : "";
  const dots = landings.length ? `; with the landings of ${landings.length / 2} shots` : "";
  const conditions = conditionsInWords(context);
  return `The range${conditions ? ` in ${conditions}` : ""}: ${each.join("; ")}${one}${dots}`;
}
