/** The studio: all scenes over the whole core. */

import shotsUrl from "../generated/clubface.wasm?url";
import elementsUrl from "../generated/clubface-fem.wasm?url";
import { app } from "./app";
import { SCENES, SETTINGS } from "./scenes/scenes";
import { run } from "./studio";
import "./style/page.css";
import "./style/controls.css";
import "./style/pictures.css";
import "./style/sessions.css";
import "./style/shot.css";
import "./style/print.css";

const root = document.querySelector<HTMLElement>("#studio");

/** Where the Python package answers, where it serves the page: `clubface studio` says so in the head of the page. */
const api = document.querySelector<HTMLMetaElement>('meta[name="clubface-api"]')?.content ?? null;

if (root) {
  const files = { shots: shotsUrl, elements: elementsUrl };
  void run(root, { files, scenes: SCENES, settings: SETTINGS, view: app, api });
  if ("serviceWorker" in navigator && location.protocol !== "file:" && import.meta.env.PROD && api === null) {
    void navigator.serviceWorker.register("sw.js");
  }
}
