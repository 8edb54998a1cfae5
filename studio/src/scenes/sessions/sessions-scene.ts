/** Your shots: files of launch monitors, what follows from them, studies, and live shots, as the Python package answers. */

import { html, nothing, type TemplateResult } from "lit-html";
import { type Context, choiceSetting, type Scene } from "../../context";
import { mistakeLine } from "./answers";
import { dropZone } from "./drop-zone";
import { begin, followUnits, loadGolfer, loadReport } from "./effects";
import { fittingPart } from "./fitting-part";
import { golferPart } from "./golfer-part";
import { livePart } from "./live-part";
import { reportPart } from "./report-part";
import { PARTS, type Part } from "./settings";
import { shotsPart } from "./shots-part";
import { studiesPart } from "./studies-part";

const TITLES: Record<Part, string> = {
  shots: "Shots",
  report: "Report",
  golfer: "Golfer",
  fitting: "Fitting",
  studies: "Studies",
  live: "Live",
};
/** Parts that are of the file. */
const OF_FILES: readonly Part[] = ["shots", "report", "golfer", "fitting"];
const VIEWS: Record<Part, (context: Context) => TemplateResult> = {
  shots: shotsPart,
  report: reportPart,
  golfer: golferPart,
  fitting: fittingPart,
  studies: studiesPart,
  live: livePart,
};

export const sessionsScene: Scene = {
  view,
  drawn: (context) => {
    // What is asked for changes the page, which is being drawn.
    queueMicrotask(() => {
      begin(context);
      followUnits(context);
      const part = partOf(context);
      if (part === "report") loadReport(context);
      if (part === "golfer") loadGolfer(context);
    });
  },
};

const partOf = (context: Context): Part => choiceSetting(context, "part") as Part;

function view(context: Context): TemplateResult {
  const { api, offers } = context.model.session;
  if (api === null) return onStaticSite();
  if (offers.state === "refused") return html`<section class="sessions">${mistakeLine(offers.mistake)}</section>`;
  if (offers.state !== "there") return html`<p aria-busy="true">Asking the package …</p>`;
  const part = partOf(context);
  return html`
    <div class="sessions">
      <nav class="parts" aria-label="Parts of your shots">
        ${PARTS.map(
          (each) => html`
            <button
              type="button"
              aria-current=${each === part ? "true" : nothing}
              @click=${() => context.actions.change({ kind: "settings", settings: { part: each } })}
            >
              ${TITLES[each]}${each === "live" ? liveCount(context) : nothing}
            </button>
          `,
        )}
      </nav>
      ${OF_FILES.includes(part) ? dropZone(context) : nothing} ${VIEWS[part](context)}
    </div>
  `;
}

const liveCount = ({ model }: Context): string => {
  const count = model.session.live?.state?.count ?? 0;
  return count ? ` (${count})` : "";
};

/** What stands in place of the scene on a site that no package serves. */
const onStaticSite = (): TemplateResult => html`
  <section class="sessions" aria-labelledby="sessions">
    <h2 id="sessions">Your shots</h2>
    <p>
      Files of launch monitors, reports, golfers, fittings and live shots are read by the Python package on your own
      machine: <code>pip install "clubface[studio]"</code>, then <code>clubface studio --open</code> shows this page with
      them.
    </p>
  </section>
`;
