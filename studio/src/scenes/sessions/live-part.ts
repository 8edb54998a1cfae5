/** Live shots: the newest large, all of them on the range and in the table, and the connections. */

import { html, nothing, type TemplateResult } from "lit-html";
import type { Context } from "../../context";
import { clubName } from "../../equipment/names";
import { choiceOf } from "../../parts/choice";
import { gap } from "../../quantities/formatter";
import type { Units } from "../../quantities/units";
import type { Live } from "../../state/session";
import { choosePlayer } from "./effects";
import { rangePicture } from "./range-picture";
import { type ShotRow, shotRows } from "./shot-rows";
import { shotTable } from "./shot-table";

/** What is large of the newest shot. */
const LARGE = ["ball_speed", "launch", "azimuth", "total_spin", "spin_axis", "carry", "side", "apex", "speed"];
/** Shots that are drawn: the newest ones. */
const DRAWN = 100;

/** The rows of the shots so far, made once for each event. */
const rowsOfLive = new WeakMap<Live["shots"], ShotRow[]>();

function rowsOf({ shots, paths }: Live, units: Units): ShotRow[] {
  const rows = rowsOfLive.get(shots) ?? shotRows(units, shots, paths);
  rowsOfLive.set(shots, rows);
  return rows;
}

export function livePart(context: Context): TemplateResult {
  const { live } = context.model.session;
  if (!live)
    return html`<section>
      <p class="remark">
        <code>clubface studio --live shots.jsonl</code> receives shots from launch monitors that use
          GSPro Open Connect, OpenGolfSim or Flight Relay, and saves all of them in the file.
      </p>
    </section>`;
  const rows = rowsOf(live, context.formatter.units);
  const newest = rows.at(-1);
  return html`
    <section class="newest" aria-labelledby="newest">
      <h2 id="newest">${newest ? `Shot ${newest.shot}${newest.shape ? `, a ${newest.shape}` : ""}` : "No shot yet"}</h2>
      ${connection(context, live)}
      <div aria-live="polite">${newest ? large(context, newest) : html`<p>The next shot of a monitor appears here.</p>`}</div>
    </section>
    ${
      rows.length
        ? html`<section aria-labelledby="live-range">
              <h2 id="live-range">${rows.length > DRAWN ? `The last ${DRAWN} shots` : "The shots on a range"}</h2>
              ${rangePicture(context, "live-range", rows.slice(-DRAWN))}
            </section>
            <section aria-labelledby="live-shots">
              <h2 id="live-shots">Live shots, the newest first</h2>
              ${shotTable(context, live.shots, [...rows].reverse(), "Table of the live shots")}
              <p><a href=${`${context.model.session.api}live/shots.csv?save`} download>Save all live shots</a> as a table.</p>
            </section>`
        : nothing
    }
    ${remarks(live)}
  `;
}

function large({ formatter, state }: Context, { values, computed }: ShotRow): TemplateResult {
  return html`<dl class="large">
    ${LARGE.filter((name) => values[name] !== undefined).map((name) => {
      const { number, unit, side } = formatter.show(name, values[name], state.system);
      const isComputed = computed.has(name);
      return html`<div class=${isComputed ? "computed" : "measured"} data-large=${name}>
        <dt>${formatter.quantity(name).label}</dt>
        <dd><b>${number}</b>${gap(unit)}${unit} ${side}</dd>
        <dd class="origin">${isComputed ? "computed" : "measured"}</dd>
      </div>`;
    })}
  </dl>`;
}

/** Club and hand, which no monitor sends, and whether the server is there. */
function connection(context: Context, { state, isConnected }: Live): TemplateResult {
  const { offers } = context.model.session;
  if (!state || offers.state !== "there") return html`<p aria-busy="true">Connecting …</p>`;
  return html`
    <div class="filters">
      ${choiceOf({
        name: "live-club",
        label: "Club of the shots to come",
        value: state.club,
        options: offers.value.clubs.map((each) => [each, clubName(context, each)] as const),
        choose: (club) => choosePlayer(context, { club }),
      })}
      ${choiceOf({
        name: "live-hand",
        label: "Hand",
        value: state.hand,
        options: [
          ["right", "right"],
          ["left", "left"],
        ],
        choose: (hand) => choosePlayer(context, { hand }),
      })}
    </div>
    ${
      isConnected
        ? nothing
        : html`<p class="failure" role="alert">
            The server has ended or cannot be reached. No shot is lost: start clubface studio again with the same file and
            open the address that it prints.
          </p>`
    }
  `;
}

const NAMES: Record<string, string> = {
  "open-connect": "GSPro Open Connect",
  opengolfsim: "OpenGolfSim",
  "flight-relay": "Flight Relay",
};

const remarks = ({ state }: Live): TemplateResult | typeof nothing =>
  state
    ? html`<section aria-labelledby="links">
        <h2 id="links">Connections</h2>
        <ul class="links">
          ${state.links.map(({ protocol, address, problem }) => html`<li>${NAMES[protocol] ?? protocol}: ${problem || address}</li>`)}
        </ul>
        <p class="remark">All shots are saved in ${state.file}.</p>
        ${
          state.remarks.length
            ? html`<details>
                <summary>What happened last</summary>
                <ul>
                  ${[...state.remarks].reverse().map(({ at, text }) => html`<li>${at.slice(11, 19)} ${text}</li>`)}
                </ul>
              </details>`
            : nothing
        }
      </section>`
    : nothing;
