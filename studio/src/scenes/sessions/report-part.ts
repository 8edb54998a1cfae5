/** The report on the file, as `clubface monitor report` writes it. */

import { html, type TemplateResult } from "lit-html";
import type { Context } from "../../context";
import { noFile, reportFrame, waiting } from "./answers";
import { inUnits } from "./api";

export function reportPart(context: Context): TemplateResult {
  const { model, state } = context;
  const { file, report } = model.session;
  if (file.state !== "there") return html`<section>${noFile()}</section>`;
  return html`
    <section aria-labelledby="report">
      <h2 id="report">Report</h2>
      ${
        report.state === "there"
          ? html`<p><a href=${inUnits(`${file.value.place}/report?save`, state.system)} download>Save the report</a>, one file that any browser shows and prints.</p>
              ${reportFrame(context, report.value, `Report on ${file.value.read.title}`)}`
          : waiting(report, "The report is being written; with many shots that takes some seconds")
      }
    </section>
  `;
}
