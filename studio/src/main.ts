/** Starts the studio: core, equipment and link first, then one picture of the state after another. */

import { render } from "lit-html";
import wasmUrl from "../generated/clubface.wasm?url";
import equipmentUrl from "../generated/equipment.json?url";
import { app } from "./app";
import { type Context, deliveryOf } from "./context";
import { CoreClient } from "./core/client";
import { fetchFile } from "./core/fetch-file";
import { type Equipment, strikeOf } from "./equipment/equipment";
import { watchKeys } from "./keys";
import { drawCharts } from "./parts/chart";
import { measure, watchWidths } from "./parts/measure";
import { Formatter, type System } from "./quantities/formatter";
import { fromLink, type LinkContext, toLink } from "./state/link";
import { initialState, type State } from "./state/state";
import { type Mistake, type Model, Store } from "./state/store";
import "./style/page.css";
import "./style/controls.css";
import "./style/pictures.css";
import "./style/print.css";

const root = document.querySelector<HTMLElement>("#studio");

/** Milliseconds between two changes of the address, of which browsers allow a hundred in half a minute. */
const ADDRESS_INTERVAL = 300;

/** Yards and miles where golfers use them. */
const usualSystem = (): System => (/-(US|GB|IE|CA)$/.test(navigator.language) ? "golf" : "metric");

async function start(page: HTMLElement): Promise<void> {
  const [client, response] = await Promise.all([CoreClient.start(wasmUrl), fetchFile(equipmentUrl)]);
  const equipment = (await response.json()) as Equipment;
  const { description } = client;
  const formatter = new Formatter(description, navigator.language);
  const usual = initialState(equipment, usualSystem());
  const linked: LinkContext = { equipment, units: formatter.units, inputs: description.inputs, usual };
  const first = fromLink(location.hash, linked);
  let latest = 0;

  const store = new Store(first.state, equipment, (model, isNewState) => {
    draw(model);
    if (!isNewState) return;
    compute(store.state);
    writeAddress();
  });

  page.replaceChildren();

  function draw(model: Model): void {
    const state = model.timeline.present;
    const context: Context = { model, state, description, equipment, formatter, actions };
    document.documentElement.dataset.theme = state.theme;
    render(app(context), page);
    drawCharts(context);
    watchWidths();
  }

  function compute(state: State): void {
    const delivery = deliveryOf({ state, formatter });
    latest += 1;
    const strike = strikeOf(description, equipment, state, delivery);
    client.request({ kind: "shot", id: latest, strike });
    client.request({ kind: "slopes", id: latest, strike });
    if (state.scene !== "models") return;
    const strikes = description.models.map(({ name }) => {
      const parameters = name === state.model ? state.parameters : "";
      return strikeOf(description, equipment, { ...state, model: name, parameters }, delivery);
    });
    client.request({ kind: "compare", id: latest, strikes });
  }

  client.answered = (answer) => {
    if (answer.kind === "comparison") store.note({ comparison: answer.comparison });
    else if (answer.kind === "slopes") store.note({ slopes: answer.slopes });
    else {
      const { shot, milliseconds } = answer;
      store.note({ shot, good: shot.failure ? store.model.good : shot, milliseconds });
      if (answer.id === latest) measure.answered();
    }
  };
  client.failed = (message) => store.note({ notices: [`This shot cannot be computed: ${message}.`] });

  let isWriting = false;
  function writeAddress(): void {
    if (isWriting) return;
    isWriting = true;
    setTimeout(() => {
      isWriting = false;
      const link = toLink(store.state, linked);
      if (link !== location.hash) history.replaceState(null, "", link);
    }, ADDRESS_INTERVAL);
  }

  const actions = {
    change: store.change,
    settle: store.settle,
    undo: store.undo,
    redo: store.redo,
    type: (name: string, text: string): void => store.note({ typing: { name, text } }),
    mistake: (name: string, mistake: Mistake): void =>
      store.note({ mistakes: { ...store.model.mistakes, [name]: mistake }, typing: null }),
    dismiss: (): void => store.note({ notices: [] }),
  };

  addEventListener("hashchange", () => {
    const { state, problems } = fromLink(location.hash, linked);
    if (toLink(state, linked) === toLink(store.state, linked)) return;
    store.change({ kind: "all", state });
    store.note({ notices: problems });
  });
  watchKeys(actions);
  measure.onWidths((widths) => store.note({ widths }));
  store.note({ notices: first.problems });
  compute(first.state);
  writeAddress();
}

if (root) {
  start(root).catch((error: unknown) => {
    root.textContent = `The studio cannot start: ${error instanceof Error ? error.message : String(error)}`;
    root.setAttribute("role", "alert");
  });
  if ("serviceWorker" in navigator && import.meta.env.PROD) {
    void navigator.serviceWorker.register("sw.js");
  }
}
