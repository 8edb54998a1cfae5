/** The club as a file: saved for the command line, opened by dropping or choosing it. */

import { html, type TemplateResult } from "lit-html";
import type { Context } from "../../context";
import { download } from "../../parts/download";
import type { Amount } from "../../quantities/units";
import type { State } from "../../state/state";
import { asChanges, exactAmount, nameOf, readClub, writeClub } from "./club-file";
import { given, setups } from "./designed";
import { DESIGN_SETTINGS, VARIABLES } from "./settings";

/** Name of the mistake about a file that cannot be read. */
export const FILE = "club-file";
/** A club's file has some kilobytes. */
const LARGEST = 100_000;

export function filePanel(context: Context): TemplateResult {
  const { state, model } = context;
  const mistake = model.mistakes[FILE];
  const choose = (event: Event): void => {
    const chosen = event.target as HTMLInputElement;
    const [file] = chosen.files ?? [];
    if (file) void openFile(context, file).then(() => (chosen.value = ""));
  };
  return html`
    <section aria-labelledby="file" class="club-file">
      <h2 id="file">The club as a file</h2>
      <p>
        <button type="button" @click=${() => save(context)}>Save ${nameOf(state.club)}.toml</button>
        <label class="open">
          <span>Open a club's file, or drop it anywhere here</span>
          <input type="file" accept=".toml" name="club-file" @change=${choose} />
        </label>
      </p>
      <p class="failure" role="alert">${mistake ? `${mistake.text}: ${mistake.message}.` : ""}</p>
      <p class="remark">The same strike by the command line:</p>
      <div class="scroll" tabindex="0" role="region" aria-label="Command"><code data-command>${command(context)}</code></div>
    </section>
  `;
}

/** The amounts that stand in the place of the club's own. */
function amounts(context: Context): Record<string, Amount> {
  const entries = VARIABLES.map(({ name }) => [name, given(context, name)] as const);
  return Object.fromEntries(entries.filter((entry): entry is [string, Amount] => entry[1] !== undefined));
}

export function clubText(context: Context): string {
  const { equipment, formatter, state } = context;
  return writeClub(equipment, formatter.units, state, amounts(context));
}

const save = (context: Context): void =>
  download(new Blob([clubText(context)], { type: "application/toml" }), `${nameOf(context.state.club)}.toml`);

/** How the strike with the saved club is typed in the command line. */
export function command(context: Context): string {
  const { state, equipment, formatter } = context;
  const { designed } = setups(context);
  const delivery = { ...state.delivery };
  // A delivery that is given is that of the club with its own numbers.
  for (const name of ["speed", "loft"]) {
    if (!delivery[name]) continue;
    const si = designed.strike.inputs[designed.names.indexOf(name)];
    if (si === formatter.units.toSi(delivery[name])) continue;
    const { unit } = delivery[name];
    const exact = exactAmount(formatter.units, si, unit);
    delivery[name] = exact.unit ? exact : { value: formatter.units.fromSi(si, unit), unit };
  }
  const { ball, model } = equipment.defaults;
  const options = [
    ...Object.entries(delivery).map(([name, { value, unit }]) => `--${name.replaceAll("_", "-")}="${value} ${unit}"`),
    ...(state.ball === ball ? [] : [`--ball=${state.ball}`]),
    ...(state.model === model ? [] : [`--model=${state.model}`]),
    ...(state.parameters ? [`--parameters=${state.parameters}`] : []),
  ];
  return `clubface shot ${nameOf(state.club)}.toml ${options.join(" ")}`;
}

/** Reads a file and shows its club; one that cannot be read is named with what is wrong. */
export async function openFile(context: Context, file: File): Promise<void> {
  const { equipment, formatter, description, actions, state } = context;
  try {
    if (file.size > LARGEST) throw new Error("it is too large for the file of a club");
    const club = await readClub(await file.text(), equipment, description);
    actions.change({ kind: "all", state: opened(context, asChanges(club, equipment, formatter.units), club.hand) });
  } catch (error) {
    const message = error instanceof Error ? error.message : String(error);
    actions.mistake(FILE, { text: file.name || state.club, message });
  }
}

/** The state with the club of a file: the delivery stays, but for a loft that was that of another club. */
function opened(context: Context, { club, changes }: ReturnType<typeof asChanges>, hand: string): State {
  const { state } = context;
  const others = Object.entries(state.settings).filter(([name]) => DESIGN_SETTINGS[name]?.kind !== "of-club");
  return {
    ...state,
    club,
    hand: hand === "left" ? "left" : "right",
    settings: { ...Object.fromEntries(others), ...changes },
  };
}

/** What the scene's element does with files that are dragged over it. */
export const dropHandlers = (context: Context): { over(event: DragEvent): void; drop(event: DragEvent): void } => ({
  over: (event) => {
    if (event.dataTransfer?.types.includes("Files")) event.preventDefault();
  },
  drop: (event) => {
    const [file] = event.dataTransfer?.files ?? [];
    if (!file) return;
    event.preventDefault();
    void openFile(context, file);
  },
});
