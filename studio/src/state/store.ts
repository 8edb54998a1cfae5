/** The one place that holds what the page shows; whoever changes it, all is drawn anew from it. */

import type { Kind, Output } from "../core/computations";
import type { Shot } from "../core/types";
import type { Equipment } from "../equipment/equipment";
import { initialSession, type Session } from "./session";
import type { Settings } from "./settings";
import { type Change, changed, type State } from "./state";
import { begin, redo, settle, step, type Timeline, undo } from "./undo";

export interface Mistake {
  text: string;
  message: string;
}

/** What was computed for a slot, or is being computed. */
export interface Result<K extends Kind = Kind> {
  kind: K;
  /** The latest output, which stays while the next is computed. */
  output: Output<K> | null;
  /** Why the latest input could not be computed, "" where it could. */
  failure: string;
  /** The share of the next output that is done, null where it is not known. */
  share: number | null;
  /** Time that the core took [ms]. */
  milliseconds: number;
}

export interface Model {
  timeline: Timeline<State>;
  /** Results by their slots. */
  results: Record<string, Result>;
  /** The last shot that could be computed, which stays drawn while another cannot. */
  good: Shot | null;
  /** Texts that fields cannot take, by the name of the field, and what is wrong with them. */
  mistakes: Record<string, Mistake>;
  /** The text that is being typed into a field, which results that arrive must not replace. */
  typing: { name: string; text: string } | null;
  /** What a scene keeps for the moment, such as a picture that moves: in no link and no step back. */
  transient: Record<string, string>;
  notices: string[];
  /** Widths of the pictures [px], by name. */
  widths: Record<string, number>;
  /** What the Python package has answered, where it serves the page. */
  session: Session;
}

/** The latest output of a computation; `slot` is its kind unless it was wanted under another name. */
export function outputOf<K extends Kind>(
  { results }: Pick<Model, "results">,
  kind: K,
  slot: string = kind,
): Output<K> | null {
  const result = results[slot];
  return result?.kind === kind ? (result.output as Output<K> | null) : null;
}

export class Store {
  model: Model;

  constructor(
    state: State,
    private readonly equipment: Equipment,
    private readonly observe: (model: Model, isNewState: boolean) => void,
    private readonly settings: Settings = {},
    api: string | null = null,
  ) {
    this.model = {
      timeline: begin(state),
      results: {},
      good: null,
      mistakes: {},
      typing: null,
      transient: {},
      notices: [],
      widths: {},
      session: initialSession(api),
    };
  }

  get state(): State {
    return this.model.timeline.present;
  }

  /** Makes a change; those of one `going` name follow each other in one step of undo. */
  readonly change = (change: Change, going: string | null = null): void => {
    this.move(step(this.model.timeline, changed(this.state, change, this.equipment, this.settings), going));
  };

  readonly settle = (): void => {
    this.model = { ...this.model, timeline: settle(this.model.timeline) };
  };

  readonly undo = (): void => this.move(undo(this.model.timeline));
  readonly redo = (): void => this.move(redo(this.model.timeline));

  /** Sets what is no choice of a person: results, notices, widths. */
  readonly note = (part: Partial<Omit<Model, "timeline">>): void => {
    this.model = { ...this.model, ...part };
    this.observe(this.model, false);
  };

  /** Sets a part of the result of a slot. */
  readonly receive = <K extends Kind>(slot: string, kind: K, part: Partial<Result<K>>): void => {
    const before = this.model.results[slot] ?? { kind, output: null, failure: "", share: null, milliseconds: 0 };
    const results = { ...this.model.results, [slot]: { ...before, ...part } };
    const shot = outputOf({ results }, "shot");
    this.note({ results, good: shot && !shot.failure ? shot : this.model.good });
  };

  private move(timeline: Timeline<State>): void {
    this.model = { ...this.model, timeline, mistakes: {}, typing: null };
    this.observe(this.model, true);
  }
}
