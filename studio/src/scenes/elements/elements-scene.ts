/** Impact by finite elements: the ball as it deforms on the face, what acts between them, and how exact it is. */

import { html, nothing, type TemplateResult } from "lit-html";
import { repeat } from "lit-html/directives/repeat.js";
import type { Context, Scene } from "../../context";
import { chartFrame } from "../../parts/chart";
import { deliveryField } from "../shot/delivery";
import { equipmentPanel } from "../shot/equipment-panel";
import { facePanel } from "../shot/face";
import { FURTHER, MAIN } from "../shot/words";
import { caseInWords, casePanel, OWN_FIELDS } from "./case-panel";
import { elementCharts } from "./charts";
import { type DrawnCase, drawnCase } from "./drawn-case";
import "./elements.css";
import { exportButtons, keepSheet, playingMark } from "./export";
import { casesOf, shownCase, wantedImpacts } from "./impacts";
import { type NamedCase, numbersTables } from "./numbers";
import { drawPatches, patchPictures } from "./patch-pictures";
import { momentOf, player, playOn } from "./player";
import { drawShapes, shapePictures } from "./shape-pictures";

export const elementsScene: Scene = {
  view,
  wanted: wantedImpacts,
  drawn(context) {
    const drawn = drawnCases(context, shownCases(context));
    keepSheet(context, drawn);
    drawShapes(context, drawn);
    drawPatches(context, drawn);
    playOn(context, longest(drawn));
  },
};

const LABELS = { first: "First case", second: "Second case" };

function shownCases(context: Context): NamedCase[] {
  const names = casesOf(context);
  return names.map((name) => ({ ...shownCase(context, name), label: names.length > 1 ? LABELS[name] : "" }));
}

/** The case that lasts longest, over whose time the slider goes. */
const longest = (cases: { impact: DrawnCase["impact"] | null }[]): DrawnCase["impact"] | null =>
  cases.reduce<DrawnCase["impact"] | null>((best, { impact }) => {
    const end = (each: DrawnCase["impact"]): number => each.times[each.times.length - 1];
    return impact && (!best || end(impact) > end(best)) ? impact : best;
  }, null);

function drawnCases(context: Context, cases: NamedCase[]): DrawnCase[] {
  const impact = longest(cases);
  if (!impact) return [];
  const moment = momentOf(context, impact);
  return cases.flatMap((each) => (each.impact ? [drawnCase({ ...each, impact: each.impact }, moment)] : []));
}

function view(context: Context): TemplateResult {
  const cases = shownCases(context);
  const drawn = drawnCases(context, cases);
  return html`
    <div class="elements" data-cases=${drawn.length}>
      <div class="controls">
        ${casePanel(context, cases)}
        <details class="strike">
          <summary>Change the strike</summary>
          ${equipmentPanel(context)}
          <section aria-labelledby="delivery">
            <h2 id="delivery">The rest of the delivery</h2>
            ${[...MAIN, ...FURTHER].filter((name) => !OWN_FIELDS.includes(name)).map((name) => deliveryField(context, name))}
          </section>
          ${facePanel(context)}
        </details>
      </div>
      <div class="results">
        ${drawn.length ? results(context, cases, drawn) : html`<p aria-busy="true">The impact is being computed …</p>`}
      </div>
    </div>
  `;
}

function results(context: Context, cases: NamedCase[], drawn: DrawnCase[]): TemplateResult {
  const impact = longest(drawn);
  const mark = impact ? momentOf(context, impact) : 0;
  const charts = drawn.map(({ name, label, impact: each }) => ({ name, label: label || "this case", impact: each }));
  return html`
    <section aria-labelledby="ball-on-face">
      <h2 id="ball-on-face">The ball on the face</h2>
      ${drawn.map(({ label, setup }) => html`<p>${label ? html`<b>${label}:</b> ` : nothing}${caseInWords(context, setup)}.</p>`)}
      ${impact ? player(context, impact) : nothing} ${playingMark(context)} ${shapePictures(context, drawn)}
      ${exportButtons(context, drawn)}
    </section>
    <section aria-labelledby="patch">
      <h2 id="patch">Pressure and shear on the face</h2>
      ${patchPictures(context, drawn)}
    </section>
    <section aria-labelledby="over-time">
      <h2 id="over-time">Over time</h2>
      ${drawn.map((each) => html`<p>${spinInWords(context, each)}</p>`)}
      <div class="charts">
        ${repeat(
          elementCharts(context, charts, mark),
          ({ name }) => name,
          (chart) => chartFrame(context, chart),
        )}
      </div>
    </section>
    <section aria-labelledby="elements-numbers">
      <h2 id="elements-numbers">Numbers</h2>
      ${numbersTables(context, cases)}
    </section>
  `;
}

/** How friction makes spin and takes some of it back. */
function spinInWords({ formatter, state }: Context, { impact, label }: DrawnCase): string {
  const text = (name: string, value: number): string => formatter.text(name, value, state.system);
  const { reversal_time, spin_max, tangential_max, tangential_min } = impact.summary;
  const backspin = impact.launch.backspin ?? impact.thrown.backspin;
  const whose = label ? `${label}: friction` : "Friction";
  if (!Number.isFinite(backspin)) return "";
  if (reversal_time === null || !Number.isFinite(reversal_time))
    return `${whose} makes backspin as long as the ball is on the face, up to ${text("backspin", backspin)}.`;
  return (
    `${whose} makes backspin for ${text("reversal_time", reversal_time)}, with up to ${text("tangential", tangential_max)}. ` +
    `Then the ball springs back along the face, and friction reverses: with up to ${text("tangential", -tangential_min)} it takes ` +
    `back ${text("backspin", spin_max - backspin)} of the ${text("backspin", spin_max)}. The ball leaves with ` +
    `${text("backspin", backspin)}.`
  );
}
