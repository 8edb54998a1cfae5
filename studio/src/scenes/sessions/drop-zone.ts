/** Where a file is dropped or chosen, how it is to be read where it does not say so, and what was read. */

import { html, nothing, type TemplateResult } from "lit-html";
import type { Context } from "../../context";
import { choiceOf } from "../../parts/choice";
import type { Offers } from "../../state/session";
import { mistakeLine, notesList } from "./answers";
import { readFile } from "./effects";

/** Dimensions whose unit a file may leave out, and the units that monitors use. */
const UNITS: Record<string, [label: string, units: readonly string[]]> = {
  speed: ["Speeds", ["mph", "m/s", "km/h"]],
  length: ["Distances", ["yd", "m", "ft"]],
  angle: ["Angles", ["deg"]],
  spin: ["Spins", ["rpm"]],
};
const ANY = "as the file says";

export function dropZone(context: Context): TemplateResult {
  const { file, offers } = context.model.session;
  return html`
    <section
      class="drop"
      aria-labelledby="drop"
      @dragover=${over}
      @dragleave=${left}
      @drop=${(event: DragEvent) => dropped(context, event)}
    >
      <h2 id="drop">A file of your launch monitor</h2>
      <p>
        <label class="file">
          <span>Choose a file, or drop it here</span>
          <input type="file" name="session" @change=${(event: Event) => chosen(context, event)} />
        </label>
        <small>CSV or Excel from any launch monitor, or a fitting or study for clubface optimise (TOML). Your file stays on this machine.</small>
      </p>
      ${offers.state === "there" ? reading(context, offers.value) : nothing}
      <div role="status">
        ${file.state === "loading" ? html`<p aria-busy="true">The file is being read …</p>` : nothing}
        ${file.state === "refused" ? mistakeLine(file.mistake) : nothing}
        ${
          file.state === "there"
            ? html`<p><b>${file.value.read.title}</b></p>
              ${rejected(file.value.read.tables.rejected?.rows.length ?? 0)} ${notesList(context, file.value.read.notes)}`
            : nothing
        }
      </div>
    </section>
  `;
}

const rejected = (rows: number): TemplateResult | typeof nothing =>
  rows ? html`<p class="remark">${rows} ${rows === 1 ? "row gives" : "rows give"} no shot.</p>` : nothing;

/** What the file may leave open; open itself where the file was refused. */
function reading(context: Context, offers: Offers): TemplateResult {
  const { reading: chosenReading, file, source } = context.model.session;
  const choose = (name: string, value: string): void =>
    context.actions.session((session) => ({ reading: { ...session.reading, [name]: value } }));
  const list = (name: string, label: string, options: readonly string[]): TemplateResult =>
    choiceOf({
      name: `read-${name}`,
      label,
      value: chosenReading[name] ?? "",
      options: [["", ANY], ...options.map((each) => [each, each] as const)],
      choose: (value) => choose(name, value),
    });
  return html`
    <details ?open=${file.state === "refused"}>
      <summary>Units, hand and layout, if the file does not give them</summary>
      <div class="reading">
        ${Object.entries(UNITS).map(([name, [label, units]]) => list(name, label, units))}
        ${list("hand", "Hand", ["right", "left"])} ${list("format", "Layout", offers.formats)}
        <button type="button" ?disabled=${!source} @click=${() => source && readFile(context, source)}>Read it again</button>
      </div>
    </details>
  `;
}

function chosen(context: Context, event: Event): void {
  const input = event.target as HTMLInputElement;
  const file = input.files?.[0];
  if (file) readFile(context, file);
}

function over(event: DragEvent): void {
  event.preventDefault();
  (event.currentTarget as HTMLElement).classList.add("over");
}

const left = (event: DragEvent): void => (event.currentTarget as HTMLElement).classList.remove("over");

function dropped(context: Context, event: DragEvent): void {
  event.preventDefault();
  left(event);
  const files = event.dataTransfer?.files;
  if (!files?.length) return;
  if (files.length > 1) context.actions.notice("Only one file can be read at a time; the first one was used.");
  readFile(context, files[0]);
}
