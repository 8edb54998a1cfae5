/** Head and ball at impact and around it: the picture, from where it is seen, the moment, and what it shows in words. */

import { html, nothing, type TemplateResult } from "lit-html";
import { type Context, choiceSetting, delivered, outlineOf, settingSi, strike } from "../../context";
import type { Shot, Values } from "../../core/types";
import { settingField } from "../../parts/field";
import { isMotionReduced } from "../../parts/measure";
import { setStage, stageFrame } from "../../parts/stage";
import { drawHead } from "./head-picture";
import { VIEWS } from "./settings";

/** How far the picture goes back before first touch and on after it [s]. */
const REACH = 3e-3;
/** Time in which a moment of that passes when it is played [s], and between its steps without motion. */
const SLOWED = 3.5;
const STEP = 1.2;

/** Moments are given to a microsecond [s]. */
const ROUNDED = 1e-6;

interface Direction {
  kind: string;
  text: string;
}

export function atImpact(context: Context): TemplateResult {
  const shot = context.model.good;
  if (!shot) return html``;
  const seen = choiceSetting(context, "head_view");
  const moment = settingSi(context, "moment");
  const directions = directionsOf(context, shot);
  const [, title = ""] = VIEWS.find(([view]) => view === seen) ?? [];
  const { label } = context.equipment.clubs[context.state.club];
  const name =
    `The ${label} meets the ball, seen ${title.toLowerCase()}, ${momentWords(shot, moment)}: ` +
    `${directions.map(({ text }) => text).join("; ")}.`;
  return html`
    <section class="head" aria-labelledby="at-impact">
      <h2 id="at-impact">At impact</h2>
      ${stageFrame("head", name)}
      <ul class="legend" aria-label="Arrows at impact">
        ${directions.map(({ kind, text }) => html`<li><i class=${`direction ${kind}`}></i>${text}</li>`)}
      </ul>
      <div class="buttons" role="group" aria-label="Seen from">
        ${VIEWS.map(
          ([view, text]) => html`<button
            type="button"
            aria-pressed=${view === seen}
            @click=${() => context.actions.change({ kind: "settings", settings: { head_view: view } })}
          >
            ${text}
          </button>`,
        )}
      </div>
      ${settingField(context, { name: "moment", label: "Moment", range: [-REACH, REACH], remark: momentWords(shot, moment) })}
      <div class="buttons" role="group" aria-label="Moments">
        ${momentsOf(shot).map(
          ([text, time]) => html`<button type="button" @click=${() => goTo(context, time, null)}>${text}</button>`,
        )}
        <button type="button" @click=${() => play(context, shot)}>Play</button>
      </div>
      <p class="remark">
        Face, ball and motion are to scale; the body behind the face only shows the kind of
        club.${contactTime(shot) ? " Between first touch and separation the motion is interpolated." : nothing}
      </p>
    </section>
  `;
}

const contactTime = ({ values }: Shot): number => (Number.isFinite(values.contact_time) ? values.contact_time : 0);

function directionsOf(context: Context, { values }: Shot): Direction[] {
  const { formatter, state } = context;
  const text = (name: string): string =>
    `${formatter.quantity(name).label} ${formatter.text(name, values[name] ?? delivered(context, name), state.system)}`;
  return [
    { kind: "path", text: `${text("path")}, ${text("attack")}` },
    { kind: "face-line", text: `${text("face")}, ${text("loft")}` },
    { kind: "start", text: `${text("azimuth")}, ${text("launch")}` },
  ];
}

/** The moments that have a name. */
function momentsOf(shot: Shot): [name: string, time: number][] {
  const contact = contactTime(shot);
  const end: [string, number][] = contact ? [["Separation", contact]] : [];
  return [["Before", -REACH], ["First touch", 0], ...end, ["After", REACH]];
}

function momentWords(shot: Shot, moment: number): string {
  const contact = contactTime(shot);
  if (moment < 0) return "before first touch";
  if (moment === 0) return "at first touch";
  if (Math.abs(moment - contact) < ROUNDED) return "at separation";
  return moment < contact ? "in contact" : "after the ball has left";
}

function goTo({ formatter, actions }: Context, time: number, going: string | null): void {
  const value = Number(formatter.units.fromSi(time, "us").toFixed(0));
  actions.change({ kind: "settings", settings: { moment: value === 0 ? null : { value, unit: "us" } } }, going);
}

let playing = 0;

/** Goes through the whole impact in slow motion, or from moment to moment where less motion is wanted. */
function play(context: Context, shot: Shot): void {
  const begun = performance.now();
  playing += 1;
  const own = playing;
  const moments = momentsOf(shot);
  const isStill = isMotionReduced();
  let shown = -1;
  const next = (now: number): void => {
    if (own !== playing || !document.querySelector('[data-stage="head"]')) return;
    const passed = Math.max(0, now - begun) / 1e3;
    const step = Math.min(Math.floor(passed / STEP), moments.length - 1);
    const share = Math.min(passed / SLOWED, 1);
    if (!isStill) goTo(context, (2 * share - 1) * REACH, "moment");
    else if (step !== shown) goTo(context, moments[step][1], "moment");
    shown = step;
    if (isStill ? step < moments.length - 1 : share < 1) requestAnimationFrame(next);
    else context.actions.settle();
  };
  requestAnimationFrame(next);
}

/** Draws the picture when the page has been drawn. */
export function setHead(context: Context): void {
  const { model, state, equipment, description } = context;
  const shot = model.good;
  if (!shot) return;
  const club = equipment.clubs[state.club];
  const { inputs } = strike(context);
  const moment = settingSi(context, "moment");
  const view = choiceSetting(context, "head_view");
  const values: Values = Object.fromEntries(description.inputs.map(({ name }, i) => [name, inputs[i]]));
  setStage("head", [shot, state.club, state.hand, moment, view, ...inputs], (stage) =>
    drawHead(stage, {
      club: state.club,
      kind: club.kind,
      outline: outlineOf(context),
      inputs: values,
      outputs: shot.values,
      moment,
      view,
    }),
  );
}
