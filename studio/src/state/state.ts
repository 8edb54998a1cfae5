/** What a link holds: everything that a person chose, and how each choice changes it. */

import type { Chosen, Equipment, Hand } from "../equipment/equipment";
import { setNames } from "../equipment/equipment";
import type { System } from "../quantities/formatter";
import type { Amount } from "../quantities/units";
import { type Settings, type SettingValue, withoutClub } from "./settings";

export const THEMES = ["auto", "light", "dark"] as const;
export type Theme = (typeof THEMES)[number];

export interface State extends Chosen {
  /** Name of the scene that is shown. */
  scene: string;
  system: System;
  theme: Theme;
  /** What was given of the delivery, by the names of the core's inputs. */
  delivery: Record<string, Amount>;
  /** What was chosen in scenes, by the names of their settings, where it is not as usual. */
  settings: Record<string, SettingValue>;
}

export type Change =
  | { kind: "scene"; scene: string }
  | { kind: "settings"; settings: Record<string, SettingValue | null> }
  | { kind: "club"; club: string }
  | { kind: "ball"; ball: string }
  | { kind: "model"; model: string }
  | { kind: "parameters"; parameters: string }
  | { kind: "hand"; hand: Hand }
  | { kind: "system"; system: System }
  | { kind: "theme"; theme: Theme }
  | { kind: "delivery"; amounts: Record<string, Amount | null> }
  | { kind: "all"; state: State };

export function initialState(equipment: Equipment, system: System): State {
  const { club, ball, model } = equipment.defaults;
  return {
    scene: "shot",
    club,
    ball,
    model,
    parameters: "",
    hand: "right",
    system,
    theme: "auto",
    delivery: { speed: { value: 105, unit: "mph" } },
    settings: {},
  };
}

export function changed(state: State, change: Change, equipment: Equipment, settings: Settings = {}): State {
  switch (change.kind) {
    case "all":
      return change.state;
    case "club":
      return withKnownSet(withClub(state, change.club, equipment, settings), equipment);
    case "delivery":
      return { ...state, delivery: withValues(state.delivery, change.amounts) };
    case "settings":
      return { ...state, settings: withValues(state.settings, change.settings) };
    default: {
      const { kind: _, ...rest } = change;
      return withKnownSet({ ...state, ...rest }, equipment);
    }
  }
}

/** Values with some of them changed; null takes one back to what is usual. */
function withValues<T>(values: Record<string, T>, changes: Record<string, T | null>): Record<string, T> {
  const result = { ...values };
  for (const [name, value] of Object.entries(changes)) {
    if (value !== null) result[name] = value;
    else delete result[name];
  }
  return result;
}

/** Another club: its own loft and attack angle, and a speed that changes as the tour's does from club to club. */
function withClub(state: State, club: string, equipment: Equipment, settings: Settings): State {
  const [before, after] = [equipment.clubs[state.club].typical, equipment.clubs[club].typical];
  const { value, unit } = state.delivery.speed ?? { value: before.speed[0], unit: before.speed[1] };
  const speed = Number(((value * after.speed[0]) / before.speed[0]).toFixed(1));
  const { loft: _, high: __, toe: ___, ...delivery } = state.delivery;
  const attack: Amount = { value: after.attack[0], unit: after.attack[1] };
  const kept = withoutClub(state.settings, settings);
  return { ...state, club, delivery: { ...delivery, speed: { value: speed, unit }, attack }, settings: kept };
}

/** The usual parameters where the set that was chosen does not fit. */
function withKnownSet(state: State, equipment: Equipment): State {
  return setNames(equipment, state).includes(state.parameters) ? state : { ...state, parameters: "" };
}
