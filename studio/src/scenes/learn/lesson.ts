/** What a lesson is, and what it may ask of the strikes that were computed for it. */

import { html, type TemplateResult } from "lit-html";
import { type Context, settingSi } from "../../context";
import type { Case, CaseResult, CasesResult, Curve, CurveResult } from "../../core/lessons";
import type { Strike, Values } from "../../core/types";
import { type Chosen, strikeOf } from "../../equipment/equipment";
import { modelName } from "../../equipment/names";
import { join, sideOf } from "../../quantities/formatter";
import type { Amount } from "../../quantities/units";
import type { Condition } from "../../state/conditions";
import type { LessonName } from "./settings";

export interface Slider {
  /** Its setting in the link. */
  setting: string;
  label: string;
  range: readonly [least: string, most: string];
  /** The input of the delivery that it moves, if it is one. */
  input?: string;
  /** The condition of the flight that it is, if it is one. */
  condition?: Condition;
}

/** A lesson as it stands with its sliders. */
export interface LessonContent {
  text: TemplateResult;
  pictures: TemplateResult[];
  question: TemplateResult;
  /** Where the sliders have come to, in terms of the question. */
  now: TemplateResult;
  isSolved: boolean;
  answer: TemplateResult;
  /** Where published figures of the text are from. */
  sources?: string[];
}

export interface Lesson {
  name: LessonName;
  /** Its claim. */
  title: string;
  chosen: Pick<Chosen, "club" | "ball" | "model">;
  /** The delivery, but for what the sliders move. */
  delivery: Record<string, Amount>;
  sliders: readonly Slider[];
  /** What the Shot scene cannot take over from the lesson. */
  left?: string;
  /** Strikes that are computed while a slider moves. */
  cases(setup: Setup): Record<string, Case>;
  /** Strikes that no slider moves, to compare with; they come a moment later. */
  steady?(setup: Setup): Record<string, Case>;
  /** Curves that come a moment later. */
  curves?(setup: Setup): Record<string, Curve>;
  content(result: LessonResult): LessonContent;
}

/** The replaced parts of a strike: club, ball or model, inputs in SI, and parameters of the model. */
interface Changes {
  chosen?: Partial<Chosen>;
  values?: Values;
  parameters?: Values;
}

/** What strikes are made of. */
export class Setup {
  constructor(
    readonly context: Context,
    readonly lesson: Lesson,
  ) {}

  /** Where a slider stands [SI]. */
  at(setting: string): number {
    return settingSi(this.context, setting);
  }

  /** Where it stands when the lesson begins [SI]. */
  usual(setting: string): number {
    const { usual } = this.context.settings[setting];
    return typeof usual === "string" ? Number.NaN : this.context.formatter.units.toSi(usual);
  }

  /** The delivery in SI. */
  get delivery(): Values {
    const { units } = this.context.formatter;
    const { delivery, sliders } = this.lesson;
    const moved = sliders.flatMap(({ input, setting }) => (input ? [[input, this.at(setting)] as const] : []));
    return {
      ...Object.fromEntries(Object.entries(delivery).map(([name, amount]) => [name, units.toSi(amount)])),
      ...Object.fromEntries(moved),
    };
  }

  /** The lesson's strike by a right-handed golfer. */
  strike({ chosen, values, parameters = {} }: Changes = {}): Strike {
    const { description, equipment } = this.context;
    const all: Chosen = { parameters: "", hand: "right", ...this.lesson.chosen, ...chosen };
    const strike = strikeOf(description, equipment, all, { ...this.delivery, ...values });
    const entry = description.models.find(({ name }) => name === strike.model);
    const names = entry?.parameters.map(({ name }) => name) ?? [];
    return { ...strike, parameters: strike.parameters.map((value, i) => parameters[names[i]] ?? value) };
  }
}

/** What was computed for a lesson, as values and as text. */
export class LessonResult {
  readonly setup: Setup;

  constructor(
    readonly context: Context,
    lesson: Lesson,
    private readonly results: CasesResult,
    private readonly curves: Record<string, CurveResult>,
    private readonly steady: Record<string, CaseResult>,
  ) {
    this.setup = new Setup(context, lesson);
  }

  /** Where a slider stood when this was computed [SI]. */
  at(setting: string): number {
    return this.results.at[setting];
  }

  case(name: string): CaseResult {
    return this.results.cases[name];
  }

  /** A strike that no slider moves. */
  steadyCase(name: string): CaseResult | undefined {
    return this.steady[name];
  }

  /** A model as it is called. */
  model(key: string): TemplateResult {
    return html`<i>${modelName(this.context, key)}</i>`;
  }

  /** A quantity of a strike [SI]. */
  value(name: string, quantity: string): number {
    return this.case(name).values[quantity] ?? Number.NaN;
  }

  curve(name: string): CurveResult | undefined {
    return this.curves[name];
  }

  /** A value in the units of the page as a text. */
  text(quantity: string, si: number): string {
    return this.context.formatter.text(quantity, si, this.context.state.system);
  }

  /** The same with its meaning, and its value in SI behind it. */
  number(quantity: string, si: number): TemplateResult {
    const { meaning, label } = this.context.formatter.quantity(quantity);
    return dataElement(this.text(quantity, si), si, `${label}: ${meaning}`);
  }

  /** The same without the word for its side, where the sentence has it. */
  size(quantity: string, si: number): TemplateResult {
    const { formatter, state } = this.context;
    const { number, unit } = formatter.show(quantity, si, state.system);
    const { meaning, label } = formatter.quantity(quantity);
    return dataElement(join(number, unit), si, `${label}: ${meaning}`);
  }

  /** A place on the face: "15.0 mm towards the toe". */
  towards(si: number): TemplateResult {
    const { formatter, state } = this.context;
    const { number, unit, side } = formatter.show("toe", si, state.system);
    const { meaning, label } = formatter.quantity("toe");
    return dataElement(join(number, unit, side && `towards the ${side}`), si, `${label}: ${meaning}`);
  }

  /** A difference, whose sign is one of two words, such as "less" and "more". */
  difference(quantity: string, si: number, words: readonly [string, string]): TemplateResult {
    const { formatter, state } = this.context;
    const { unit, digits } = formatter.reading(quantity, state.system);
    const value = formatter.units.differenceFromSi(si, unit);
    const number = formatter.format(Math.abs(value), digits);
    return dataElement(
      join(number, formatter.units.symbol(unit), sideOf(words, value, digits)),
      si,
      `difference of ${formatter.quantity(quantity).label}`,
    );
  }

  /** A share in per cent. */
  share(value: number, meaning: string): TemplateResult {
    return dataElement(`${this.context.formatter.format(100 * value, 0)}%`, value, meaning);
  }
}

/** A number that is not there yet is an ellipsis. */
const dataElement = (text: string, value: number, meaning: string): TemplateResult =>
  html`<data value=${String(value)} title=${meaning}>${Number.isFinite(value) ? text : "…"}</data>`;

/** `count` values from the one to the other. */
export const spread = (from: number, to: number, count: number): number[] =>
  Array.from({ length: count }, (_, i) => from + ((to - from) * i) / (count - 1));

/** The first place at which a curve crosses a level, by straight lines between its points; NaN where it does not. */
export function crossing(x: ArrayLike<number>, y: ArrayLike<number>, level = 0): number {
  for (let i = 0; i + 1 < x.length; i += 1) {
    const [before, after] = [y[i] - level, y[i + 1] - level];
    if (before * after <= 0 && before !== after) return x[i] + ((x[i + 1] - x[i]) * before) / (before - after);
  }
  return Number.NaN;
}

/** Place and height of the top of a curve, by a parabola through the three highest points next to each other. */
export function peak(x: ArrayLike<number>, y: ArrayLike<number>): [x: number, y: number] {
  let top = 0;
  for (let i = 1; i < y.length; i += 1) if (y[i] > y[top]) top = i;
  if (top === 0 || top === y.length - 1) return [x[top], y[top]];
  const [before, at, after] = [y[top - 1], y[top], y[top + 1]];
  const shift = (before - after) / (2 * (before - 2 * at + after));
  return [x[top] + shift * (x[top + 1] - x[top]), at - ((before - after) * shift) / 4];
}
