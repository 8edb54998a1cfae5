/** Studies of the folder that was named at the start, each with its summary. */

import { html, nothing, type TemplateResult } from "lit-html";
import type { Context } from "../../context";
import { reportFrame, waiting } from "./answers";
import { openStudy } from "./effects";

export function studiesPart(context: Context): TemplateResult {
  const { offers, studies, study } = context.model.session;
  const isOffered = offers.state === "there" && offers.value.studies;
  const rows = studies.state === "there" ? studies.value.tables.studies.rows : [];
  return html`
    <section aria-labelledby="studies">
      <h2 id="studies">Studies</h2>
      ${isOffered ? waiting(studies, "The studies are being looked up") : html`<p class="remark"><code>clubface studio --studies FOLDER</code> shows the studies whose parts lie in a folder.</p>`}
      ${isOffered && studies.state === "there" && !rows.length ? html`<p class="remark">The folder holds no study.</p>` : nothing}
      <ul class="studies">
        ${rows.map(
          (row) => html`<li>
            <button
              type="button"
              aria-pressed=${study?.name === row.store}
              @click=${() => openStudy(context, String(row.store))}
            >
              ${row.name}
            </button>
            <span>${row.tasks} tasks, ${row.done === row.chunks ? "complete" : `${row.done} of ${row.chunks} parts done`}</span>
          </li>`,
        )}
      </ul>
      ${
        study
          ? study.report.state === "there"
            ? reportFrame(context, study.report.value, `Summary of ${study.name}`)
            : waiting(study.report, "The study is being summed up")
          : nothing
      }
    </section>
  `;
}
