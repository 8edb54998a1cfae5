/** The worker that holds the core: it computes while the page stays free for the hand that moves a slider. */

import { type LoadedCore, load } from "clubface-core";
import { compareModels, computeShot, computeSlopes } from "./compute";
import { fetchFile } from "./fetch-file";
import type { Reply, Request } from "./types";

let core: LoadedCore | undefined;

const reply = (message: Reply): void => postMessage(message);

async function start(wasm: string): Promise<void> {
  const response = await fetchFile(wasm);
  core = await load(await response.arrayBuffer());
  reply({ kind: "ready", description: core.description });
}

function answer(loaded: LoadedCore, request: Exclude<Request, { kind: "start" }>): void {
  const begun = performance.now();
  if (request.kind === "shot") {
    const shot = computeShot(loaded, request.strike);
    reply({ kind: "shot", id: request.id, shot, milliseconds: performance.now() - begun });
  } else if (request.kind === "slopes") {
    reply({ kind: "slopes", id: request.id, slopes: computeSlopes(loaded, request.strike) });
  } else {
    const comparison = compareModels(loaded, request.strikes);
    reply({ kind: "comparison", id: request.id, comparison, milliseconds: performance.now() - begun });
  }
}

addEventListener("message", async ({ data }: MessageEvent<Request>) => {
  try {
    if (data.kind === "start") await start(data.wasm);
    else if (core) answer(core, data);
  } catch (error) {
    reply({ kind: "broken", message: error instanceof Error ? error.message : String(error) });
  }
});
