/** What every view is given: the model to draw, and what a person may do with it. */

import type { Description, Values } from "./core/types";
import { type Equipment, usualValue } from "./equipment/equipment";
import type { Formatter } from "./quantities/formatter";
import type { Change, State } from "./state/state";
import type { Mistake, Model } from "./state/store";

export interface Actions {
  change(change: Change, going?: string | null): void;
  settle(): void;
  undo(): void;
  redo(): void;
  type(name: string, text: string): void;
  mistake(name: string, mistake: Mistake): void;
  dismiss(): void;
}

export interface Context {
  model: Model;
  state: State;
  description: Description;
  equipment: Equipment;
  formatter: Formatter;
  actions: Actions;
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
