/** What every view is given: the model to draw, and what a person may do with it. */

import type { TemplateResult } from "lit-html";
import type { Wanted } from "./core/lanes";
import type { Description, Strike, Values } from "./core/types";
import { type Setup, withClub } from "./equipment/design";
import { type Chosen, chosenSet, type Equipment, strikeOf, usualValue } from "./equipment/equipment";
import type { Formatter } from "./quantities/formatter";
import type { Amount } from "./quantities/units";
import { flightConditions } from "./state/conditions";
import type { Session } from "./state/session";
import type { Settings } from "./state/settings";
import type { Change, State } from "./state/state";
import type { Mistake, Model } from "./state/store";
import { usedNumbers } from "./state/used-club";

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
  /** Whether it shows other shots than that of the club in use. */
  hasOwnShots?: boolean;
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

/**
 * The strike of the state in its wind, air and ground; `changes` replace club, ball or model, `values` inputs in SI. With
 * the club as it was designed where that is used.
 */
export function strike(context: Context, changes: Partial<Chosen> = {}, values: Values = {}): Strike {
  const { state } = context;
  const own = ownStrike(context, changes, values);
  const numbers = (changes.club ?? state.club) === state.club ? usedNumbers(context) : {};
  const kept = Object.entries(numbers).filter(([name]) => values[name] === undefined);
  if (!kept.length) return own;
  return withClub(setupOf(context, own, changes), Object.fromEntries(kept)).strike;
}

/** The same with the club's own numbers. */
export function ownStrike(context: Context, changes: Partial<Chosen> = {}, values: Values = {}): Strike {
  const { description, equipment, state, formatter } = context;
  const struck = strikeOf(description, equipment, { ...state, ...changes }, { ...deliveryOf(context), ...values });
  return { ...struck, flight: flightConditions(state, equipment, formatter.units) };
}

/** What belongs to a strike where the numbers of its club change. */
export const setupOf = (context: Context, struck: Strike, changes: Partial<Chosen> = {}): Setup => ({
  strike: struck,
  golfer: null,
  names: context.description.inputs.map(({ name }) => name),
  face: chosenSet(context.equipment, { ...context.state, ...changes }),
  speedExponent: choiceSetting(context, "heavier") === "slower" ? context.equipment.speed_exponent : 0,
});

/** Corners of the face of a club, towards the toe and up the face [m]: as wide and as high as the one that is used. */
export function outlineOf(context: Context, club: string = context.state.club): [number, number][] {
  const { outline, columns } = context.equipment.clubs[club];
  const used = club === context.state.club ? usedNumbers(context) : {};
  const share = (name: string): number => (used[name] === undefined ? 1 : used[name] / (columns[name] ?? Number.NaN));
  const [wide, high] = [share("face_width"), share("face_height")];
  return wide === 1 && high === 1 ? outline : outline.map(([toe, up]) => [toe * wide, up * high]);
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
