/** Answers of the package as they are read: mistakes, notes, values and tables of any result. */

import { html, nothing, type TemplateResult } from "lit-html";
import type { Context } from "../../context";
import { ballName, clubName } from "../../equipment/names";
import { gap, withUnit } from "../../quantities/formatter";
import type {
  Asked,
  ColumnDocument,
  NoteDocument,
  ResultDocument,
  Row,
  ServerMistake,
  TableDocument,
} from "../../state/session";
import type { Theme } from "../../state/state";

export const mistakeLine = ({ where, what }: ServerMistake): TemplateResult =>
  html`<p class="failure" role="alert">${where && !what.startsWith(where) ? `${where}: ` : ""}${what}.</p>`;

/** What stands for something that was asked for and is not there. */
export function waiting<T>(asked: Asked<T>, words: string): TemplateResult | typeof nothing {
  if (asked.state === "refused") return mistakeLine(asked.mistake);
  return asked.state === "loading" ? html`<p aria-busy="true">${words} …</p>` : nothing;
}

/** What stands where a file is needed and none is there. */
export const noFile = (): TemplateResult =>
  html`<p class="remark">Choose the file of a launch monitor above, or drop it on the page.</p>`;

/** A sentence of the package in the words of the page: the titles of golfers for their names, and its sign for degrees. */
function sentence({ equipment }: Pick<Context, "equipment">, { text }: NoteDocument): string {
  const named = text.replace(/\b[a-z0-9]+(?:-[a-z0-9]+)+\b/g, (name) =>
    Object.hasOwn(equipment.golfers, name) ? `“${equipment.golfers[name].title}”` : name,
  );
  return named.replace(/(\d) deg\b/g, "$1°");
}

export const notesList = (
  context: Context,
  notes: readonly NoteDocument[],
  title = "Notes",
): TemplateResult | typeof nothing =>
  notes.length
    ? html`<details ?open=${notes.length < 4}>
        <summary>${title} (${notes.length})</summary>
        <ul>
          ${notes.map((note) => html`<li>${sentence(context, note)}</li>`)}
        </ul>
      </details>`
    : nothing;

/** A column without a unit of its own may have one in each row. */
const UNIT_OF_ROW = "unit";
/** Digits that count of a number whose quantity the core does not know. */
const DIGITS = 3;
/** The quantity whose unit and digits stand for a length of the flight that the package alone knows. */
const LENGTH = "carry";
const NAMELESS = ["quantity", UNIT_OF_ROW];

/** Number and unit in which a value is read: those of its quantity where the core knows it, else those it comes in. */
function reading(context: Context, value: number, quantity: string, unit: string): [string, string] {
  const { formatter, state } = context;
  const known = formatter.knows(quantity) ? quantity : unit === "m" ? LENGTH : null;
  if (!known) return [plain(context, value), formatter.units.symbol(unit)];
  const { unit: shown, digits } = formatter.reading(known, state.system);
  const si = formatter.units.toSi({ value, unit });
  return [formatter.format(formatter.units.fromSi(si, shown), digits), formatter.units.symbol(shown)];
}

/** A number with the digits that count. */
function plain({ formatter }: Context, value: number): string {
  if (Number.isInteger(value)) return formatter.format(value, 0);
  return formatter.format(value, Math.min(6, Math.max(0, DIGITS - 1 - Math.floor(Math.log10(Math.abs(value))))));
}

/** A text of a cell; the key of a quantity, a club or a ball becomes its name. */
const words = ({ formatter, equipment }: Context, text: string): string =>
  formatter.knows(text)
    ? formatter.quantity(text).label
    : Object.hasOwn(equipment.clubs, text) || Object.hasOwn(equipment.balls, text)
      ? ballName({ equipment }, clubName({ equipment }, text))
      : /^[a-z]+(_[a-z]+)+$/.test(text)
        ? text.replaceAll("_", " ")
        : text.replace(/(\d) deg\b/g, "$1°");

/** Columns of values whose sign has a word, unlike spreads and differences. */
const SIDED = ["mean"];

/** A cell as it is read; `unit` is shown where it is not that of the whole column. */
function shown(context: Context, key: string, { columns }: TableDocument, row: Row): string {
  const { formatter, state } = context;
  const [value, column] = [row[key], columns[key]];
  if (value === null) return "–";
  if (typeof value === "boolean") return value ? "yes" : "no";
  if (typeof value === "string") return words(context, value);
  if (column.quantity) return reading(context, value, column.quantity, column.unit ?? "1")[0];
  const unit = row[UNIT_OF_ROW];
  if (typeof unit !== "string" || !unit) return plain(context, value);
  const quantity = String(row.quantity ?? "");
  if (SIDED.includes(key) && formatter.knows(quantity))
    return formatter.text(quantity, formatter.units.toSi({ value, unit }), state.system);
  const [number, symbol] = reading(context, value, quantity, unit);
  return number + gap(symbol) + symbol;
}

/** A table of a result with all its rows. */
export function resultTable(context: Context, result: ResultDocument, name: string, title: string): TemplateResult {
  const { columns, rows } = result.tables[name];
  const isEmpty = (key: string): boolean => rows.every((row) => row[key] === null || row[key] === "");
  const keys = Object.keys(columns).filter((key) => !NAMELESS.includes(key) && !isEmpty(key));
  return html`
    <div class="scroll" tabindex="0" role="region" aria-label=${title}>
      <table>
        <caption>${title}</caption>
        <thead>
          <tr>${keys.map((key) => heading(context, columns[key]))}</tr>
        </thead>
        <tbody>
          ${rows.map(
            (row) => html`<tr>
              ${keys.map((key, place) => {
                const text = shown(context, key, result.tables[name], row);
                return place ? html`<td>${text}</td>` : html`<th scope="row">${text}</th>`;
              })}
            </tr>`,
          )}
        </tbody>
      </table>
    </div>
  `;
}

function heading(context: Context, column: ColumnDocument): TemplateResult {
  const unit = column.quantity ? reading(context, 0, column.quantity, column.unit ?? "1")[1] : "";
  return html`<th scope="col" title=${column.meaning || nothing}>${withUnit(column.label, unit)}</th>`;
}

/** What a result says in sentences. */
export const summary = (context: Context, { summary: [first, ...others] }: ResultDocument): TemplateResult => html`
  ${first ? html`<p class="advice">${sentence(context, first)}</p>` : nothing}
  ${others.length ? html`<p>${others.map((each) => sentence(context, each)).join(" ")}</p>` : nothing}
`;

/** When a report is dark: as the system is, unless a theme was chosen for the page. */
const DARK = "(prefers-color-scheme:dark)";
const IN_THEME: Record<Theme, (report: string) => string> = {
  auto: (report) => report,
  dark: (report) => report.replaceAll(`screen and ${DARK}`, "screen"),
  light: (report) => report.replaceAll(DARK, "(max-width:0)"),
};

/** A report of the package, which runs no script and reads nothing from elsewhere. */
export const reportFrame = ({ state }: Context, page: string, title: string): TemplateResult =>
  html`<iframe class="report" title=${title} sandbox="allow-downloads" .srcdoc=${IN_THEME[state.theme](page)}></iframe>`;
