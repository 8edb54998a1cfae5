/** The page's side of the worker: one request is computed at a time, and of each kind that waits only the newest. */

import type { Description, Reply, Request } from "./types";

type Work = Exclude<Request, { kind: "start" }>;
/** What is computed first when several wait. */
const ORDER: Work["kind"][] = ["shot", "slopes", "compare"];

export type Answer = Exclude<Reply, { kind: "ready" | "broken" }>;

export class CoreClient {
  private busy = false;
  /** Take what comes back; set once, before the first request. */
  answered: (answer: Answer) => void = () => undefined;
  failed: (message: string) => void = () => undefined;
  private readonly waiting = new Map<Work["kind"], Work>();

  private constructor(
    private readonly worker: Worker,
    readonly description: Description,
  ) {
    worker.onmessage = ({ data }: MessageEvent<Reply>) => this.receive(data);
  }

  /** Starts the worker and waits for the core's description of itself. */
  static start(wasm: string): Promise<CoreClient> {
    const worker = new Worker(new URL("./worker.ts", import.meta.url), { type: "module" });
    const first: Request = { kind: "start", wasm };
    return new Promise((resolve, reject) => {
      worker.onerror = (event) => reject(new Error(event.message || "the worker did not start"));
      worker.onmessage = ({ data }: MessageEvent<Reply>) => {
        if (data.kind === "ready") resolve(new CoreClient(worker, data.description));
        else if (data.kind === "broken") reject(new Error(data.message));
      };
      worker.postMessage(first);
    });
  }

  request(work: Work): void {
    this.waiting.set(work.kind, work);
    this.send();
  }

  private send(): void {
    const kind = this.busy ? undefined : ORDER.find((each) => this.waiting.has(each));
    const next = kind && this.waiting.get(kind);
    if (!next) return;
    this.waiting.delete(next.kind);
    this.busy = true;
    this.worker.postMessage(next);
  }

  private receive(reply: Reply): void {
    this.busy = false;
    if (reply.kind === "broken") this.failed(reply.message);
    else if (reply.kind !== "ready") this.answered(reply);
    this.send();
  }
}
