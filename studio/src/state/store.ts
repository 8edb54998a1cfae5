/** The one place that holds what the page shows; whoever changes it, all is drawn anew from it. */

import type { Comparison, Shot, Slopes } from "../core/types";
import type { Equipment } from "../equipment/equipment";
import { type Change, changed, type State } from "./state";
import { begin, redo, settle, step, type Timeline, undo } from "./undo";

export interface Mistake {
  text: string;
  message: string;
}

export interface Model {
  timeline: Timeline<State>;
  shot: Shot | null;
  /** The last shot that could be computed, which stays drawn while another cannot. */
  good: Shot | null;
  /** Derivatives of the last shot that has them. */
  slopes: Slopes;
  comparison: Comparison | null;
  /** Texts that fields cannot take, by the name of the field, and what is wrong with them. */
  mistakes: Record<string, Mistake>;
  /** The text that is being typed into a field, which results that arrive must not replace. */
  typing: { name: string; text: string } | null;
  notices: string[];
  /** Widths of the pictures [px], by name. */
  widths: Record<string, number>;
  /** Time that the core took for the shot [ms]. */
  milliseconds: number;
}

export class Store {
  model: Model;

  constructor(
    state: State,
    private readonly equipment: Equipment,
    private readonly observe: (model: Model, isNewState: boolean) => void,
  ) {
    this.model = {
      timeline: begin(state),
      shot: null,
      good: null,
      slopes: {},
      comparison: null,
      mistakes: {},
      typing: null,
      notices: [],
      widths: {},
      milliseconds: 0,
    };
  }

  get state(): State {
    return this.model.timeline.present;
  }

  /** Makes a change; those of one `going` name follow each other in one step of undo. */
  readonly change = (change: Change, going: string | null = null): void => {
    this.move(step(this.model.timeline, changed(this.state, change, this.equipment), going));
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

  private move(timeline: Timeline<State>): void {
    this.model = { ...this.model, timeline, mistakes: {}, typing: null };
    this.observe(this.model, true);
  }
}
