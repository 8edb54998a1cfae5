/** The state as readable text in the address: `#club=driver&speed=105mph&face=2deg`. */

import type { Variable } from "../core/types";
import { type Equipment, HANDS, setNames } from "../equipment/equipment";
import { SYSTEMS } from "../quantities/formatter";
import type { Amount, Units } from "../quantities/units";
import { optionsOf, type Settings, type SettingValue, wordsOf } from "./settings";
import { type State, THEMES } from "./state";

export interface LinkContext {
  equipment: Equipment;
  units: Units;
  /** The core's inputs of a strike. */
  inputs: Variable[];
  /** Names of the scenes, and their settings. */
  scenes: readonly string[];
  settings: Settings;
  /** What stands for all that the link leaves out. */
  usual: State;
}

/** Club, ball, model and delivery always; the rest where it is not as usual. */
export function toLink(state: State, { usual }: Pick<LinkContext, "usual">): string {
  const entries: [string, string][] = [];
  if (state.scene !== usual.scene) entries.push(["scene", state.scene]);
  entries.push(["club", state.club]);
  if (state.ball !== usual.ball) entries.push(["ball", state.ball]);
  if (state.model !== usual.model) entries.push(["model", state.model]);
  if (state.parameters) entries.push(["parameters", state.parameters]);
  if (state.hand !== usual.hand) entries.push(["hand", state.hand]);
  for (const [name, amount] of Object.entries(state.delivery)) entries.push([name, written(amount)]);
  for (const [name, value] of Object.entries(state.settings))
    entries.push([name, typeof value === "string" ? value : written(value)]);
  if (state.system !== usual.system) entries.push(["units", state.system]);
  if (state.theme !== usual.theme) entries.push(["theme", state.theme]);
  return `#${entries.map(([key, value]) => `${key}=${escaped(value)}`).join("&")}`;
}

/** An amount with its unit; a plain number has none. */
const written = ({ value, unit }: Amount): string => `${value}${unit === "1" ? "" : unit}`;

/** A slash and a comma may stand in a fragment as they are. */
const escaped = (text: string): string => encodeURIComponent(text).replace(/%2F/g, "/").replace(/%2C/g, ",");

/** The state of a link, and a sentence for each part of it that could not be read. */
export function fromLink(link: string, context: LinkContext): { state: State; problems: string[] } {
  const { equipment, inputs, settings, usual } = context;
  const state: State = { ...usual, delivery: {}, settings: {} };
  const problems: string[] = [];
  const choose = <T extends string>(key: string, value: string, known: readonly T[], set: (value: T) => void): void => {
    const fitting = known.find((each) => each === value);
    if (fitting === undefined) problems.push(`The link's ${key} "${value}" is unknown; there are ${known.join(", ")}.`);
    else set(fitting);
  };
  const read = (key: string, value: string, set: () => void): void => {
    try {
      set();
    } catch (error) {
      const why = error instanceof Error ? error.message : String(error);
      problems.push(`The link's ${key} "${value}" cannot be read: ${why}.`);
    }
  };
  let parameters = "";
  for (const part of link.replace(/^#/, "").split("&").filter(Boolean)) {
    const [key, value] = split(part);
    const delivered = inputs.find(({ name, group }) => name === key && group === "delivery");
    if (key === "scene") choose(key, value, context.scenes, (scene) => Object.assign(state, { scene }));
    else if (key === "club") choose(key, value, Object.keys(equipment.clubs), (club) => Object.assign(state, { club }));
    else if (key === "ball") choose(key, value, Object.keys(equipment.balls), (ball) => Object.assign(state, { ball }));
    else if (key === "model")
      choose(key, value, Object.keys(equipment.choices), (model) => Object.assign(state, { model }));
    else if (key === "hand") choose(key, value, HANDS, (hand) => Object.assign(state, { hand }));
    else if (key === "units") choose(key, value, SYSTEMS, (system) => Object.assign(state, { system }));
    else if (key === "theme") choose(key, value, THEMES, (theme) => Object.assign(state, { theme }));
    else if (key === "parameters") parameters = value;
    else if (delivered) read(key, value, () => (state.delivery[key] = amountOf(context, value, delivered.unit)));
    else if (Object.hasOwn(settings, key))
      read(key, value, () => (state.settings[key] = settingOf(context, key, value)));
    else problems.push(`The link's "${key}" is unknown.`);
  }
  if (!state.delivery.speed) state.delivery = { speed: usual.delivery.speed, ...state.delivery };
  if (parameters) {
    choose("parameters", parameters, setNames(equipment, state), (name) => Object.assign(state, { parameters: name }));
  }
  return { state, problems };
}

/** An amount of a link, which has a unit unless it is 0. */
function amountOf({ units }: LinkContext, text: string, unit: string): Amount {
  const amount = units.parse(text, unit);
  if (amount.value !== 0 && units.unit(unit).symbol !== "1" && /^[-\d.,e\s]*$/i.test(text))
    throw new Error("give it with its unit");
  return amount;
}

function settingOf(context: LinkContext, name: string, text: string): SettingValue {
  const setting = context.settings[name];
  if (setting.kind === "amount" || setting.kind === "of-club") return amountOf(context, text, setting.usual.unit);
  const options = optionsOf(setting, context.equipment);
  const words = setting.kind === "several" ? wordsOf(text) : [text];
  const unknown = words.find((word) => !options.includes(word));
  if (unknown !== undefined) throw new Error(`${unknown} is unknown; there are ${options.join(", ")}`);
  return text;
}

function split(part: string): [string, string] {
  const [key, ...rest] = part.split("=");
  const text = rest.join("=").replace(/\+/g, " ");
  try {
    return [key, decodeURIComponent(text)];
  } catch {
    return [key, text];
  }
}
