/** The shots of the file: filters, the range, the table. */

import { html, nothing, type TemplateResult } from "lit-html";
import { type Context, choiceSetting } from "../../context";
import { clubName } from "../../equipment/names";
import { choiceOf, settingChoice } from "../../parts/choice";
import type { Units } from "../../quantities/units";
import type { SessionFile } from "../../state/session";
import { noFile, notesList } from "./answers";
import { rangePicture } from "./range-picture";
import { clubsOf, type ShotRow, shotRows } from "./shot-rows";
import { shotTable } from "./shot-table";

/** The rows of a file, which are made once. */
const rowsOfFile = new WeakMap<SessionFile, ShotRow[]>();

function rowsOf(file: SessionFile, units: Units): ShotRow[] {
  const rows = rowsOfFile.get(file) ?? shotRows(units, file.shots.tables.shots, file.shots.tables.paths);
  rowsOfFile.set(file, rows);
  return rows;
}

export function shotsPart(context: Context): TemplateResult {
  const { file, club } = context.model.session;
  if (file.state !== "there") return html`<section>${file.state === "none" ? noFile() : nothing}</section>`;
  const rows = rowsOf(file.value, context.formatter.units);
  const isHidden = choiceSetting(context, "mishits") === "hidden";
  const chosen = rows.filter((row) => (!club || row.club === club) && !(isHidden && row.mishit));
  const mishits = rows.filter(({ mishit }) => mishit).length;
  const clubs = clubsOf(rows);
  return html`
    <section aria-labelledby="range">
      <h2 id="range">The shots on a range</h2>
      <div class="filters">
        ${
          clubs.length > 1
            ? choiceOf({
                name: "club-of-file",
                label: "Club",
                value: club,
                options: [
                  ["", `all, ${rows.length}`],
                  ...clubs.map(
                    ([each, count]) => [each, `${clubName(context, each) || "without a name"}, ${count}`] as const,
                  ),
                ],
                choose: (value) => context.actions.session(() => ({ club: value, marked: null })),
              })
            : nothing
        }
        ${
          mishits
            ? settingChoice(context, {
                name: "mishits",
                label: `Mishits (${mishits})`,
                options: [
                  ["shown", "shown"],
                  ["hidden", "left out"],
                ],
              })
            : nothing
        }
        <output>${chosen.length === rows.length ? `${rows.length} shots` : `${chosen.length} of ${rows.length} shots`}</output>
      </div>
      ${rangePicture(context, "range", chosen)} ${notesList(context, file.value.shots.notes.slice(0, ownNotes(file.value)), "How the flight paths were computed")}
    </section>
    <section aria-labelledby="all-shots">
      <h2 id="all-shots">The shots in numbers</h2>
      ${shotTable(context, file.value.shots.tables.shots, chosen, `Shots of ${file.value.source.name}`)}
    </section>
  `;
}

/** The notes on flight paths come before those of the file, which stand with the file. */
const ownNotes = ({ shots, read }: SessionFile): number => {
  const known = new Set(read.notes.map(({ text }) => text));
  return shots.notes.findIndex(({ text }) => known.has(text)) < 0
    ? shots.notes.length
    : shots.notes.findIndex(({ text }) => known.has(text));
};
