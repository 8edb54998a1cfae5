/** A fitting for the golfer of the file: what may change, how far it is, what to do. */

import { html, nothing, type TemplateResult } from "lit-html";
import type { Context } from "../../context";
import { ballName, clubName } from "../../equipment/names";
import { choiceOf } from "../../parts/choice";
import type { Job, Session } from "../../state/session";
import { mistakeLine, noFile, notesList, resultTable, summary, waiting } from "./answers";
import { inUnits } from "./api";
import { cancelFitting, startFitting } from "./effects";
import { clubOfGolfer } from "./golfer-part";

/** How far the loft may be turned either way. */
const LOFTS = ["", "1 deg", "2 deg", "3 deg"];
/** What may count, where its name does not say it. */
const OBJECTIVES: Record<string, string> = {
  total: "total distance",
  side_spread: "spread to the side",
  ellipse: "area of the landings",
};
/** Tables of a fitting that say what was compared. */
const TABLES: Record<string, string> = {
  combinations: "All combinations, the best first",
  differences: "Differences from the present club",
  effects: "What makes a difference",
};

export function fittingPart(context: Context): TemplateResult {
  const { file, fitting } = context.model.session;
  return html`
    <section aria-labelledby="fitting">
      <h2 id="fitting">Which club, ball and loft for this golfer?</h2>
      ${file.state === "there" ? wishesForm(context) : noFile()}
      <div role="status">${fitting.state === "there" ? progress(context, fitting.value) : waiting(fitting, "The fitting begins")}</div>
      ${fitting.state === "there" && fitting.value.result ? fittingResult(context, fitting.value) : nothing}
    </section>
  `;
}

function wishesForm(context: Context): TemplateResult {
  const { wishes, offers, fitting, file } = context.model.session;
  if (offers.state !== "there" || file.state !== "there") return html``;
  const set = (part: Partial<Session["wishes"]>): void =>
    context.actions.session((session) => ({ wishes: { ...session.wishes, ...part } }));
  const isRunning = fitting.state === "loading" || (fitting.state === "there" && fitting.value.state === "running");
  return html`
    <div class="filters">
      ${clubOfGolfer(context, file.value)}
      ${choiceOf({
        name: "objective",
        label: "What counts",
        value: wishes.objective,
        options: offers.value.objectives.map((each) => [each, OBJECTIVES[each] ?? each.replaceAll("_", " ")] as const),
        choose: (objective) => set({ objective }),
      })}
      ${choiceOf({
        name: "loft-range",
        label: "Loft",
        value: wishes.loft,
        options: LOFTS.map((each) => [each, each ? `up to ± ${each.replace(" deg", "°")}` : "as it is"] as const),
        choose: (loft) => set({ loft }),
      })}
    </div>
    ${several(
      "Balls",
      named(offers.value.balls, (name) => ballName(context, name)),
      wishes.balls,
      (balls) => set({ balls }),
    )}
    <details>
      <summary>Other heads to compare with (${wishes.clubs.length})</summary>
      ${several(
        "Heads",
        named(offers.value.clubs, (name) => clubName(context, name)),
        wishes.clubs,
        (clubs) => set({ clubs }),
      )}
    </details>
    <p>
      <button type="button" class="main" ?disabled=${isRunning} @click=${() => startFitting(context)}>Start the fitting</button>
    </p>
  `;
}

const named = (keys: readonly string[], nameOf: (key: string) => string): (readonly [key: string, name: string])[] =>
  keys.map((key) => [key, nameOf(key)]);

const several = (
  label: string,
  options: readonly (readonly [key: string, name: string])[],
  chosen: readonly string[],
  choose: (keys: string[]) => void,
): TemplateResult => html`
  <fieldset class="several">
    <legend>${label}</legend>
    ${options.map(
      ([key, name]) => html`<label>
        <input
          type="checkbox"
          .checked=${chosen.includes(key)}
          @change=${(event: Event) =>
            choose(
              (event.target as HTMLInputElement).checked ? [...chosen, key] : chosen.filter((each) => each !== key),
            )}
        />
        ${name}
      </label>`,
    )}
  </fieldset>
`;

const STATES: Record<Job["state"], string> = {
  running: "The fitting is being computed",
  done: "The fitting is done",
  failed: "The fitting could not be computed",
  cancelled: "The fitting was cancelled",
};

function progress(context: Context, { state, done, whole, step, mistake }: Job): TemplateResult {
  const count = whole ? `: ${done} of ${whole}${step ? `, ${step}` : " combinations"}` : "";
  return html`
    <p>${STATES[state]}${state === "running" || state === "cancelled" ? count : ""}.</p>
    ${
      state === "running"
        ? html`<p class="progress">
            <progress aria-label="Progress of the fitting" max=${Math.max(whole, 1)} value=${done}></progress>
            <button type="button" @click=${() => cancelFitting(context)}>Cancel</button>
          </p>`
        : nothing
    }
    ${mistake ? mistakeLine(mistake) : nothing}
  `;
}

function fittingResult(context: Context, { job, result }: Job): TemplateResult {
  if (!result) return html``;
  return html`
    ${summary(context, result)}
    ${Object.entries(TABLES)
      .filter(([name]) => result.tables[name]?.rows.length)
      .map(([name, title]) => resultTable(context, result, name, title))}
    <p><a href=${inUnits(`${context.model.session.api}jobs/${job}/report?save`, context.state.system)} download>Save the report</a> with its pictures.</p>
    ${notesList(context, result.notes)}
  `;
}
