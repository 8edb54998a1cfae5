/** What every view is given: the model to draw, and what a person may do with it. */

import type { TemplateResult } from "lit-html";
import type { Wanted } from "./core/lanes";
import type { Description, Strike, Values } from "./core/types";
import { type Chosen, type Equipment, strikeOf, usualValue } from "./equipment/equipment";
import type { Formatter } from "./quantities/formatter";
import type { Amount } from "./quantities/units";
import { flightConditions } from "./state/conditions";
import type { Session } from "./state/session";
import type { Settings } from "./state/settings";
import type { Change, State } from "./state/state";
import type { Mistake, Model } from "./state/store";

export interface Actions {
  change(change: Change, going?: string | null): void;
  settle(): void;
  undo(): void;
  redo(): void;
  type(name: string, text: string): void;
  mistake(name: string, mistake: Mistake): void;
  /** Keeps something for the moment; see the model. */
  keep(transient: Record<string, string>): void;
  dismiss(): void;
  /** Says a sentence at the head of the page. */
  notice(text: string): void;
  /** Changes what the package has answered. */
  session(change: (session: Session) => Partial<Session>): void;
}

export interface Context {
  model: Model;
  state: State;
  description: Description;
  equipment: Equipment;
  formatter: Formatter;
  settings: Settings;
  actions: Actions;
}

/** A view of a scene, and what it does with its canvases when the page has been drawn. */
export interface Scene {
  view(context: Context): TemplateResult;
  /** What it needs computed, beyond the shot. */
  wanted?(context: Context): Wanted[];
  drawn?(context: Context): void;
}

/** How a scene is known: its parts are loaded when it is first shown. */
export interface SceneEntry {
  /** Name in the link. */
  name: string;
  title: string;
  settings?: Settings;
  load(): Scene | Promise<Scene>;
}

/** The delivery in SI as it was given. */
export const deliveryOf = ({ state, formatter }: Pick<Context, "state" | "formatter">): Values =>
  Object.fromEntries(Object.entries(state.delivery).map(([name, amount]) => [name, formatter.units.toSi(amount)]));

/** The value of an input of the delivery in SI, as it was given or what stands for it. */
export function delivered(context: Context, name: string): number {
  const { state, equipment, formatter } = context;
  const amount = state.delivery[name];
  return amount ? formatter.units.toSi(amount) : usualValue(equipment, state, name);
}

/** The strike of the state in its wind, air and ground; `changes` replace club, ball or model, `values` inputs in SI. */
export function strike(context: Context, changes: Partial<Chosen> = {}, values: Values = {}): Strike {
  const { description, equipment, state, formatter } = context;
  const struck = strikeOf(description, equipment, { ...state, ...changes }, { ...deliveryOf(context), ...values });
  return { ...struck, flight: flightConditions(state, equipment, formatter.units) };
}

/** The words that were chosen for a setting, or are usual. */
export function choiceSetting({ state, settings }: Context, name: string): string {
  const value = state.settings[name] ?? settings[name].usual;
  if (typeof value !== "string") throw new Error(`${name} is an amount`);
  return value;
}

/** The amount that was given for a setting, or is usual. */
export function amountSetting({ state, settings }: Context, name: string): Amount {
  const value = state.settings[name] ?? settings[name].usual;
  if (typeof value === "string") throw new Error(`${name} is no amount`);
  return value;
}

/** The same in SI. */
export const settingSi = (context: Context, name: string): number =>
  context.formatter.units.toSi(amountSetting(context, name));
