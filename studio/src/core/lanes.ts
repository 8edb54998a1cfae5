/** Where the core computes: on the page itself, or in lanes of one worker each, which starts when it is first needed. */

import { type LoadedCore, load } from "clubface-core";
import { compute, type Input, type Kind, type Output } from "./computations";
import { fetchFile } from "./fetch-file";
import type { Reply, Request } from "./messages";
import type { Description } from "./types";
import CoreWorker from "./worker?worker";

/** Files of the core that a worker may hold: shots and all that is quick, or finite elements as well. */
export type CoreFile = "shots" | "elements";

/** Workers: for what follows a slider, for what takes tenths of a second, and for two cases of finite elements. */
type WorkerName = "quick" | "batch" | "elements" | "other-elements";
/** "page" is for what takes less time than a worker takes to answer: it is there when the page is drawn. */
export type LaneName = WorkerName | "page";
const FILES: Record<WorkerName, CoreFile> = {
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
  /** How long the input must stay as it is before it is computed [ms], once something was computed for this slot. */
  rest?: number;
}

/** What the page hears of its computations. */
export interface Observer {
  answered(slot: string, kind: Kind, output: Output<Kind>, milliseconds: number): void;
  /** A computation that takes long has begun. */
  begun(slot: string, kind: Kind): void;
  progressed(slot: string, share: number): void;
  failed(slot: string, kind: Kind, message: string): void;
}

interface Task {
  slot: string;
  kind: Kind;
  input: Input<Kind>;
  /** The input as text, by which a task is known again. */
  key: string;
  rest: number;
}

const taskOf = ({ kind, input, slot = kind, rest = 0 }: Wanted): Task => ({
  slot,
  kind,
  input,
  rest,
  key: JSON.stringify([kind, input]),
});

/** The core, compiled while it comes where its server says what it is; browsers keep that for the next visit. */
async function compileFile(address: string): Promise<WebAssembly.Module> {
  const response = await fetchFile(address);
  const isNamed = response.headers.get("content-type")?.startsWith("application/wasm");
  return isNamed ? WebAssembly.compileStreaming(response) : WebAssembly.compile(await response.arrayBuffer());
}

/** Computes on the page, at once. */
class PageLane {
  private readonly done = new Map<string, string>();

  constructor(
    private readonly core: LoadedCore,
    private readonly observer: Observer,
  ) {}

  want(tasks: Task[]): void {
    for (const { slot, kind, input, key } of tasks) {
      if (this.done.get(slot) === key) continue;
      this.done.set(slot, key);
      const begun = performance.now();
      try {
        const output = compute(this.core, kind, input, () => undefined);
        this.observer.answered(slot, kind, output, performance.now() - begun);
      } catch (error) {
        this.observer.failed(slot, kind, error instanceof Error ? error.message : String(error));
      }
    }
  }
}

/** How long a task may go on that nobody wants any more [ms], before its worker is ended for the next one. */
const PATIENCE = 400;
/** How long a worker that has taken much memory is kept without a task [ms]: memory of a core never shrinks. */
const KEPT = 3000;

class WorkerLane {
  private worker: Worker | null = null;
  private isReady = false;
  private busy: Task | null = null;
  private waiting: Task[] = [];
  /** The latest input of each slot that was computed. */
  private readonly done = new Map<string, string>();
  /** The latest input of each slot that rests, and from when on it may be computed [ms]. */
  private readonly due = new Map<string, { key: string; at: number }>();
  private timer: ReturnType<typeof setTimeout> | undefined;
  private idle: ReturnType<typeof setTimeout> | undefined;
  private ending: ReturnType<typeof setTimeout> | undefined;

  constructor(
    private readonly wasm: string | WebAssembly.Module,
    private readonly observer: Observer,
  ) {}

  start(): void {
    const worker = new CoreWorker();
    this.worker = worker;
    worker.onmessage = ({ data }: MessageEvent<Reply>) => this.receive(data);
    worker.onerror = (event) => this.receive({ kind: "broken", slot: null, message: event.message || "no worker" });
    this.post({ kind: "start", wasm: this.wasm });
  }

  /** Computes what is wanted and not computed yet, in this order; a task that nobody wants any more is ended. */
  want(tasks: Task[]): void {
    const isBusyWith = (task: Task): boolean => this.busy?.slot === task.slot && this.busy.key === task.key;
    const isUnwanted = this.busy !== null && !tasks.some(isBusyWith);
    if (!isUnwanted) this.cancelEnding();
    else if (this.endsEarly) this.stop();
    else this.ending ??= setTimeout(() => this.restart(), PATIENCE);
    this.waiting = tasks.filter((task) => !isBusyWith(task) && this.done.get(task.slot) !== task.key);
    const now = performance.now();
    for (const { slot, key, rest } of tasks) {
      const before = this.due.get(slot);
      if (before?.key !== key) this.due.set(slot, { key, at: before ? now + rest : now });
      else if (!rest) before.at = now;
    }
    this.send();
  }

  /** Takes the first task off the list; none where it must rest, after which it is sent. */
  private next(): Task | undefined {
    const wait = (this.due.get(this.waiting[0]?.slot)?.at ?? 0) - performance.now();
    clearTimeout(this.timer);
    if (wait <= 0) return this.waiting.shift();
    this.timer = setTimeout(() => this.send(), wait);
    return undefined;
  }

  /** Whether a task takes so long that ending its worker is the quicker way to the next. */
  endsEarly = false;

  /** Lets the task go on that was to be ended. */
  private cancelEnding(): void {
    clearTimeout(this.ending);
    this.ending = undefined;
  }

  /** Ends the task, and goes on with those that wait. */
  private restart(): void {
    this.stop();
    this.send();
  }

  private stop(): void {
    this.cancelEnding();
    clearTimeout(this.idle);
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
    const next = this.isReady && !this.busy ? this.next() : undefined;
    if (!next) return;
    clearTimeout(this.idle);
    this.busy = next;
    this.post({ kind: "compute", slot: next.slot, computation: next.kind, input: next.input });
    if (this.endsEarly) this.observer.begun(next.slot, next.kind);
  }

  private receive(reply: Reply): void {
    if (reply.kind === "ready") {
      this.isReady = true;
    } else if (reply.kind === "progress") {
      this.observer.progressed(reply.slot, reply.share);
      return;
    } else {
      const task = this.busy;
      this.busy = null;
      this.cancelEnding();
      if (task) this.done.set(task.slot, task.key);
      if (reply.kind === "answer") {
        const { slot, computation, output, milliseconds } = reply;
        this.observer.answered(slot, computation, output, milliseconds);
      } else if (task) this.observer.failed(task.slot, task.kind, reply.message);
      else for (const { slot, kind } of this.waiting) this.observer.failed(slot, kind, reply.message);
    }
    this.send();
    if (this.endsEarly && !this.busy && !this.waiting.length) this.idle = setTimeout(() => this.stop(), KEPT);
  }
}

export class Lanes {
  private readonly workers = new Map<WorkerName, WorkerLane>();

  private constructor(
    private readonly page: PageLane,
    private readonly files: Record<CoreFile, string | WebAssembly.Module>,
    private readonly observer: Observer,
  ) {}

  /** Loads the core of the page, which the workers for shots get as it was compiled. */
  static async start(
    files: Record<CoreFile, string>,
    observer: Observer,
  ): Promise<{ lanes: Lanes; description: Description }> {
    const module = await compileFile(files.shots);
    const core = await load(module);
    const lanes = new Lanes(new PageLane(core, observer), { ...files, shots: module }, observer);
    return { lanes, description: core.description };
  }

  /** Has everything computed that the page shows; what is not in the list is not computed any more. */
  want(all: Wanted[]): void {
    for (const name of Object.keys(FILES) as WorkerName[]) {
      const tasks = all.filter(({ lane = "quick" }) => lane === name).map(taskOf);
      const worker = this.workers.get(name) ?? (tasks.length ? this.open(name) : undefined);
      worker?.want(tasks);
    }
    this.page.want(all.filter(({ lane }) => lane === "page").map(taskOf));
  }

  private open(name: WorkerName): WorkerLane {
    const worker = new WorkerLane(this.files[FILES[name]], this.observer);
    worker.endsEarly = FILES[name] === "elements";
    this.workers.set(name, worker);
    return worker;
  }
}
