/** Runs a page on the core: equipment and link first, then one picture of the state after another. */

import { render, type TemplateResult } from "lit-html";
import equipmentUrl from "../generated/equipment.json?url";
import { type Actions, type Context, type Scene, type SceneEntry, strike } from "./context";
import { fetchFile } from "./core/fetch-file";
import { type CoreFile, Lanes, type Observer } from "./core/lanes";
import type { Equipment } from "./equipment/equipment";
import { watchKeys } from "./keys";
import { drawCharts } from "./parts/chart";
import { measure, watchWidths } from "./parts/measure";
import { endStages } from "./parts/stage";
import { Formatter, type System } from "./quantities/formatter";
import { fromLink, type LinkContext, toLink } from "./state/link";
import type { Settings } from "./state/settings";
import { initialState } from "./state/state";
import { type Mistake, type Model, Store } from "./state/store";

/** What a page is made of. */
export interface Parts {
  /** Addresses of the core. */
  files: Record<CoreFile, string>;
  scenes: readonly SceneEntry[];
  settings: Settings;
  /** All that is shown; the scene is null while it is loaded. */
  view(context: Context, scene: Scene | null): TemplateResult;
  /** Where the Python package answers, null where it does not serve the page. */
  api: string | null;
}

/** Milliseconds between two changes of the address, of which browsers allow a hundred in half a minute. */
const ADDRESS_INTERVAL = 300;

/** Yards and miles where golfers use them. */
const usualSystem = (): System => (/-(US|GB|IE|CA)$/.test(navigator.language) ? "golf" : "metric");

/** Fills an element with the page; what keeps it from starting is said there. */
export async function run(page: HTMLElement, parts: Parts): Promise<void> {
  try {
    await start(page, parts);
  } catch (error) {
    page.textContent = `The studio cannot start: ${error instanceof Error ? error.message : String(error)}`;
    page.setAttribute("role", "alert");
  }
}

async function start(page: HTMLElement, { files, scenes, settings, view, api }: Parts): Promise<void> {
  let store: Store | undefined;
  /** Whether drawing waits for what the page is computing. */
  let isHeld = false;
  const observer: Observer = {
    answered(slot, kind, output, milliseconds) {
      store?.receive(slot, kind, { output, failure: "", share: null, milliseconds });
      // What is wanted may follow from what was computed.
      if (store && !isHeld) compute();
    },
    begun(slot, kind) {
      store?.receive(slot, kind, { failure: "", share: null });
    },
    progressed(slot, share) {
      const result = store?.model.results[slot];
      if (result) store?.receive(slot, result.kind, { share });
    },
    failed(slot, kind, message) {
      store?.receive(slot, kind, { failure: message, share: null });
      // The scene of the finite elements says it where it shows how far they are.
      if (kind !== "elements") store?.note({ notices: [`This cannot be computed: ${message}.`] });
    },
  };
  const [{ lanes, description }, response] = await Promise.all([Lanes.start(files, observer), fetchFile(equipmentUrl)]);
  const equipment = (await response.json()) as Equipment;
  const formatter = new Formatter(description, navigator.language, equipment.quantities);
  const linked: LinkContext = {
    equipment,
    units: formatter.units,
    inputs: description.inputs,
    scenes: scenes.map(({ name }) => name),
    settings,
    usual: initialState(equipment, usualSystem()),
  };
  const first = fromLink(location.hash, linked);
  const loaded = new Map<string, Scene>();
  const observe = (model: Model, isNewState: boolean): void => {
    if (isNewState) {
      follow();
      writeAddress();
    } else if (!isHeld) draw(model);
  };
  const made = new Store(first.state, equipment, observe, settings, api);
  store = made;
  page.replaceChildren();

  const contextOf = (model: Model): Context => {
    const state = model.timeline.present;
    return { model, state, description, equipment, formatter, settings, actions };
  };

  /** The scene that is shown; null while it is loaded, after which the page is drawn again. */
  function sceneOf(name: string): Scene | null {
    const before = loaded.get(name);
    if (before) return before;
    const entry = scenes.find((each) => each.name === name) ?? scenes[0];
    const scene = entry.load();
    const isHere = !(scene instanceof Promise);
    if (isHere) loaded.set(name, scene);
    else
      scene.then(
        (each) => {
          loaded.set(name, each);
          follow();
        },
        (error: unknown) => made.note({ notices: [`${entry.title} cannot be loaded: ${String(error)}`] }),
      );
    return isHere ? scene : null;
  }

  function draw(model: Model): void {
    const context = contextOf(model);
    document.documentElement.dataset.theme = context.state.theme;
    const scene = sceneOf(context.state.scene);
    render(view(context, scene), page);
    drawCharts(context);
    scene?.drawn?.(context);
    endStages();
    watchWidths();
  }

  function compute(): void {
    const context = contextOf(made.model);
    const scene = sceneOf(context.state.scene);
    lanes.want([{ kind: "shot", input: strike(context), lane: "page" }, ...(scene?.wanted?.(context) ?? [])]);
  }

  /** Computes what is wanted, and draws once with all that was there at once. */
  function follow(): void {
    isHeld = true;
    try {
      compute();
    } finally {
      isHeld = false;
    }
    draw(made.model);
    measure.answered();
  }

  /** The address that was written or read last: another one has been typed, and is read in a moment. */
  let known = location.hash;
  let isWriting = false;
  function writeAddress(): void {
    if (isWriting) return;
    isWriting = true;
    setTimeout(() => {
      isWriting = false;
      const link = toLink(made.state, linked);
      if (link === known || location.hash !== known) return;
      history.replaceState(null, "", link);
      known = location.hash;
    }, ADDRESS_INTERVAL);
  }

  const actions: Actions = {
    change: made.change,
    settle: made.settle,
    undo: made.undo,
    redo: made.redo,
    type: (name: string, text: string): void => made.note({ typing: { name, text } }),
    mistake: (name: string, mistake: Mistake): void =>
      made.note({ mistakes: { ...made.model.mistakes, [name]: mistake }, typing: null }),
    keep(transient: Record<string, string>): void {
      made.note({ transient: { ...made.model.transient, ...transient } });
      compute();
    },
    dismiss: (): void => made.note({ notices: [] }),
    notice: (text: string): void => made.note({ notices: [...made.model.notices, text] }),
    session: (change): void => made.note({ session: { ...made.model.session, ...change(made.model.session) } }),
  };

  addEventListener("hashchange", () => {
    known = location.hash;
    const { state, problems } = fromLink(known, linked);
    if (toLink(state, linked) === toLink(made.state, linked)) return;
    made.change({ kind: "all", state });
    made.note({ notices: problems });
  });
  watchKeys(actions);
  measure.onWidths((widths) => made.note({ widths }));
  isHeld = true;
  made.note({ notices: first.problems });
  follow();
  writeAddress();
}
