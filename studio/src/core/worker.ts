/** A worker that holds a core: it computes while the page stays free for the hand that moves a slider. */

import { type LoadedCore, load } from "clubface-core";
import { compute } from "./computations";
import { fetchFile } from "./fetch-file";
import type { Reply, Request } from "./messages";

/** Least time between two reports of what is done [ms]. */
const REPORTED = 50;

let core: LoadedCore | undefined;
let report: (share: number) => void = () => undefined;

const reply = (message: Reply): void => postMessage(message);

async function start(wasm: string | WebAssembly.Module): Promise<void> {
  const source = typeof wasm === "string" ? await (await fetchFile(wasm)).arrayBuffer() : wasm;
  core = await load(source, (time, duration) => {
    report(duration > 0 ? time / duration : 0);
    return true;
  });
  reply({ kind: "ready" });
}

function answer(loaded: LoadedCore, { slot, computation, input }: Extract<Request, { kind: "compute" }>): void {
  const begun = performance.now();
  let reported = begun;
  report = (share) => {
    if (performance.now() - reported < REPORTED) return;
    reported = performance.now();
    reply({ kind: "progress", slot, share });
  };
  const output = compute(loaded, computation, input, report);
  reply({ kind: "answer", slot, computation, output, milliseconds: performance.now() - begun });
}

addEventListener("message", async ({ data }: MessageEvent<Request>) => {
  try {
    if (data.kind === "start") await start(data.wasm);
    else if (core) answer(core, data);
  } catch (error) {
    const slot = data.kind === "compute" ? data.slot : null;
    reply({ kind: "broken", slot, message: error instanceof Error ? error.message : String(error) });
  }
});
