/** The page's side of the workers: each lane is one worker, which starts when it is first needed. */

import type { Input, Kind, Output } from "./computations";
import type { Reply, Request } from "./messages";
import type { Description } from "./types";

/** Files of the core that a worker may hold: shots and all that is quick, or finite elements as well. */
export type CoreFile = "shots" | "elements";

/** Workers: for what follows a slider, for what takes tenths of a second, and for two cases of finite elements. */
export type LaneName = "quick" | "batch" | "elements" | "other-elements";
const FILES: Record<LaneName, CoreFile> = {
  quick: "shots",
  batch: "shots",
  elements: "elements",
  "other-elements": "elements",
};

/** Something that a scene needs computed. */
export interface Wanted<K extends Kind = Kind> {
  kind: K;
  input: Input<K>;
  /** Where the result goes, of which there is one; the name of the computation unless given. */
  slot?: string;
  lane?: LaneName;
}

/** What the page is told. */
export interface Observer {
  /** `isLatest` is false where the same slot already waits for another input. */
  answered(slot: string, kind: Kind, output: Output<Kind>, milliseconds: number, isLatest: boolean): void;
  progressed(slot: string, share: number): void;
  failed(slot: string, kind: Kind, message: string): void;
}

interface Task {
  slot: string;
  kind: Kind;
  input: Input<Kind>;
  /** The input as text, by which a task is known again. */
  key: string;
}

const taskOf = ({ kind, input, slot = kind }: Wanted): Task => ({
  slot,
  kind,
  input,
  key: JSON.stringify([kind, input]),
});

class Lane {
  private worker: Worker | null = null;
  private isReady = false;
  private busy: Task | null = null;
  private waiting: Task[] = [];
  /** The latest input of each slot that was computed. */
  private readonly done = new Map<string, string>();

  constructor(
    private readonly wasm: string,
    private readonly observer: Observer,
    private readonly described: (description: Description) => void = () => undefined,
    private readonly broken: (message: string) => void = () => undefined,
  ) {}

  start(): void {
    const worker = new Worker(new URL("./worker.ts", import.meta.url), { type: "module" });
    this.worker = worker;
    worker.onmessage = ({ data }: MessageEvent<Reply>) => this.receive(data);
    worker.onerror = (event) => this.receive({ kind: "broken", slot: null, message: event.message || "no worker" });
    this.post({ kind: "start", wasm: this.wasm });
  }

  /** Computes what is wanted and not computed yet, in this order; a task that nobody wants any more is ended. */
  want(tasks: Task[]): void {
    const isBusyWith = (task: Task): boolean => this.busy?.slot === task.slot && this.busy.key === task.key;
    if (this.busy && this.endsEarly && !tasks.some(isBusyWith)) this.stop();
    this.waiting = tasks.filter((task) => !isBusyWith(task) && this.done.get(task.slot) !== task.key);
    this.send();
  }

  /** Whether a task takes so long that ending its worker is the quicker way to the next. */
  endsEarly = false;

  private stop(): void {
    this.worker?.terminate();
    this.worker = null;
    this.isReady = false;
    this.busy = null;
  }

  private post(request: Request): void {
    this.worker?.postMessage(request);
  }

  private send(): void {
    if (!this.worker) {
      if (this.waiting.length) this.start();
      return;
    }
    const next = this.isReady && !this.busy ? this.waiting.shift() : undefined;
    if (!next) return;
    this.busy = next;
    this.post({ kind: "compute", slot: next.slot, computation: next.kind, input: next.input });
  }

  private receive(reply: Reply): void {
    if (reply.kind === "ready") {
      this.isReady = true;
      this.described(reply.description);
    } else if (reply.kind === "progress") {
      this.observer.progressed(reply.slot, reply.share);
      return;
    } else {
      const task = this.busy;
      this.busy = null;
      if (task) this.done.set(task.slot, task.key);
      if (reply.kind === "answer") {
        const { slot, computation, output, milliseconds } = reply;
        const isLatest = !this.waiting.some((each) => each.slot === slot);
        this.observer.answered(slot, computation, output, milliseconds, isLatest);
      } else if (task) this.observer.failed(task.slot, task.kind, reply.message);
      else this.broken(reply.message);
    }
    this.send();
  }
}

export class Lanes {
  private readonly lanes = new Map<LaneName, Lane>();

  private constructor(
    private readonly files: Record<CoreFile, string>,
    private readonly observer: Observer,
  ) {}

  /** Starts the first worker and waits for the core's description of itself. */
  static start(
    files: Record<CoreFile, string>,
    observer: Observer,
  ): Promise<{ lanes: Lanes; description: Description }> {
    const lanes = new Lanes(files, observer);
    return new Promise((resolve, reject) => {
      const quick = new Lane(
        files[FILES.quick],
        observer,
        (description) => resolve({ lanes, description }),
        (message) => reject(new Error(message)),
      );
      lanes.lanes.set("quick", quick);
      quick.start();
    });
  }

  /** Has everything computed that the page shows; what is not in the list is not computed any more. */
  want(all: Wanted[]): void {
    for (const name of Object.keys(FILES) as LaneName[]) {
      const tasks = all.filter(({ lane = "quick" }) => lane === name).map(taskOf);
      const lane = this.lanes.get(name) ?? (tasks.length ? this.open(name) : undefined);
      lane?.want(tasks);
    }
  }

  private open(name: LaneName): Lane {
    const lane = new Lane(this.files[FILES[name]], this.observer);
    lane.endsEarly = FILES[name] === "elements";
    this.lanes.set(name, lane);
    return lane;
  }
}
