/** The live picture of the front page: the shot by a few of its sliders, in a frame as high as what it shows. */

import shotsUrl from "../generated/clubface.wasm?url";
import { liveScene } from "./scenes/live/live-scene";
import { run } from "./studio";
import "./style/page.css";
import "./style/controls.css";
import "./style/pictures.css";
import "./style/shot.css";
import "./style/live.css";

const root = document.querySelector<HTMLElement>("#studio");

if (root) {
  // The page that frames it makes room for it: pages that were opened from files know nothing else of each other.
  new ResizeObserver(() => parent.postMessage({ clubfaceHeight: root.offsetHeight }, "*")).observe(root);
  void run(root, {
    files: { shots: shotsUrl, elements: "" },
    scenes: [{ name: "shot", title: "Shot", load: () => liveScene }],
    settings: {},
    view: (context) => liveScene.view(context),
    api: null,
  });
}
