/** The moment that is shown: a slider over the shapes, and playing them one after the other. */

import { html, type TemplateResult } from "lit-html";
import { live } from "lit-html/directives/live.js";
import type { Context } from "../../context";
import type { ElementsImpact } from "../../core/elements";
import { isMotionReduced } from "../../parts/measure";
import { given } from "./case";
import { frameAt } from "./shape-fields";

/** Time that a shape stays [ms]; with reduced motion there are few of them, which stay for longer. */
const STAY = 60;
const STILL = { stay: 600, shapes: 8 };
const PLAYING = "elements-playing";

export const isPlaying = ({ model }: Context): boolean => model.transient[PLAYING] === "yes";

/** The moment that was chosen, and otherwise that of the greatest compression [s]. */
export function momentOf(context: Context, impact: ElementsImpact): number {
  const amount = given(context, "impact_moment");
  const last = impact.times[impact.times.length - 1];
  return Math.min(last, amount ? context.formatter.units.toSi(amount) : impact.summary.contraction_time);
}

export function setMoment({ actions, formatter }: Pick<Context, "actions" | "formatter">, moment: number): void {
  const value = Number(formatter.units.fromSi(moment, "us").toFixed(1));
  actions.change({ kind: "settings", settings: { impact_moment: { value, unit: "us" } } }, "impact_moment");
}

/** Ends the movement; the moment at which it ends is a step back as any other. */
export function stopPlaying({ actions }: Context): void {
  actions.settle();
  actions.keep({ [PLAYING]: "" });
}

/** Plays the shapes from the present one, or from the first where that is the last. */
export function startPlaying(context: Context, impact: ElementsImpact, fromStart = false): void {
  const frame = frameAt(impact, momentOf(context, impact));
  if (fromStart || frame === impact.times.length - 1) setMoment(context, 0);
  context.actions.keep({ [PLAYING]: "yes" });
}

let timer: ReturnType<typeof setTimeout> | undefined;

/** Has the next shape follow while it plays; called when the page has been drawn. */
export function playOn(context: Context, impact: ElementsImpact | null): void {
  clearTimeout(timer);
  if (!isPlaying(context) || !impact) return;
  const frame = frameAt(impact, momentOf(context, impact));
  const last = impact.times.length - 1;
  const isStill = isMotionReduced();
  const next = Math.min(last, frame + (isStill ? Math.ceil(last / STILL.shapes) : 1));
  timer = setTimeout(
    () => {
      if (frame === last) stopPlaying(context);
      else setMoment(context, impact.times[next]);
    },
    isStill ? STILL.stay : STAY,
  );
}

export function player(context: Context, impact: ElementsImpact): TemplateResult {
  const { formatter, state } = context;
  const moment = momentOf(context, impact);
  const frame = frameAt(impact, moment);
  const text = (time: number): string => formatter.text("contact_time", time, state.system);
  const last = impact.times.length - 1;
  const playing = isPlaying(context);
  return html`
    <div class="player">
      <button type="button" @click=${() => (playing ? stopPlaying(context) : startPlaying(context, impact))}>
        ${playing ? "Pause" : "Play"}
      </button>
      <input
        type="range"
        aria-label="Moment, slider"
        aria-valuetext=${`${text(impact.times[frame])} of ${text(impact.times[last])}`}
        min="0"
        max=${last}
        step="1"
        .value=${live(String(frame))}
        @input=${(event: Event) => setMoment(context, impact.times[Number((event.target as HTMLInputElement).value)])}
        @change=${context.actions.settle}
      />
      <output><b>${text(impact.times[frame])}</b> since first touch</output>
    </div>
  `;
}
