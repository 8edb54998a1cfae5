/** The golfer of the file, as `clubface golfer estimate` finds it. */

import { html, nothing, type TemplateResult } from "lit-html";
import type { Context } from "../../context";
import { clubName } from "../../equipment/names";
import { choiceOf } from "../../parts/choice";
import { NOTHING, type ResultDocument, type SessionFile } from "../../state/session";
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

const caption = ({ values: { title, shots } }: ResultDocument): string =>
  `${title}: mean of ${shots} shots, and how much they vary`;

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
          ? html`${summary(context, golfer.value)}
              ${resultTable(context, golfer.value, "delivery", caption(golfer.value))}
              <p><a href=${`${file.value.place}/golfer.toml${query}`} download>Save the golfer</a> for clubface dispersion and clubface optimise.</p>
              ${notesList(context, golfer.value.notes)}`
          : waiting(golfer, "The golfer is being estimated")
      }
    </section>
  `;
}
