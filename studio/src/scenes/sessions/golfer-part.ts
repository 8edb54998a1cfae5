/** The golfer of the file, as `clubface golfer estimate` finds it. */

import { html, nothing, type TemplateResult } from "lit-html";
import type { Context } from "../../context";
import { clubName } from "../../equipment/names";
import { choiceOf } from "../../parts/choice";
import { NOTHING, type SessionFile } from "../../state/session";
import { noFile, notesList, resultTable, summary, waiting } from "./answers";

/** The list of clubs of a file that has several: a golfer is one with one club. */
export function clubOfGolfer(context: Context, { shots }: SessionFile): TemplateResult | typeof nothing {
  const { model, actions } = context;
  const names = [...new Set(shots.tables.shots.rows.map(({ club }) => String(club ?? "")))];
  if (names.length < 2) return nothing;
  return choiceOf({
    name: "golfer-club",
    label: "With the club",
    value: model.session.wishes.only,
    options: names.filter(Boolean).map((name) => [name, clubName(context, name)] as const),
    choose: (only) => actions.session(({ wishes }) => ({ wishes: { ...wishes, only }, golfer: NOTHING })),
  });
}

export function golferPart(context: Context): TemplateResult {
  const { file, golfer, wishes } = context.model.session;
  if (file.state !== "there") return html`<section>${noFile()}</section>`;
  const query = wishes.only ? `?${new URLSearchParams({ only: wishes.only })}&save` : "?save";
  return html`
    <section aria-labelledby="golfer">
      <h2 id="golfer">Your golfer: how you deliver the club, and how much that varies</h2>
      <div class="filters">${clubOfGolfer(context, file.value)}</div>
      ${
        golfer.state === "there"
          ? html`${summary(golfer.value)}
              ${resultTable(context, golfer.value, "delivery", golfer.value.title)}
              <p><a href=${`${file.value.place}/golfer.toml${query}`} download>Save the golfer</a> for clubface dispersion and clubface optimise.</p>
              ${notesList(golfer.value.notes)}`
          : waiting(golfer, "The golfer is being estimated")
      }
    </section>
  `;
}
