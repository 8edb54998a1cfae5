/** A club as a file of the package: written from the numbers of the page, and read back from what a person drops. */

import type { Description, Values } from "../../core/types";
import type { Equipment, FileField } from "../../equipment/equipment";
import { type Amount, Units } from "../../quantities/units";

export interface ClubFile {
  name: string;
  kind: string;
  parameters: string;
  hand: string;
  description: string;
  /** Numbers as they are given, by the inputs of the core; Infinity for a flat face. */
  amounts: Record<string, Amount>;
}

/** The shortest number in a unit that stands for exactly this value [SI]; the value itself where there is none. */
export function exactAmount(units: Units, si: number, unit: string): Amount {
  const value = units.fromSi(si, unit);
  for (let digits = 1; digits <= 17; digits += 1) {
    const short = Number(value.toPrecision(digits));
    if (units.toSi({ value: short, unit }) === si) return { value: short, unit };
  }
  return { value: si, unit: "" };
}

const quoted = (text: string): string => JSON.stringify(text);

/** The file of a club; `given` are amounts in the place of the base's own, `sources` say where the numbers are from. */
export function writeClub(
  equipment: Equipment,
  units: Units,
  base: { club: string; hand: string },
  given: Record<string, Amount>,
): string {
  const { kind, parameters, columns } = equipment.clubs[base.club];
  const number = ({ column, unit, infinite }: FileField): string => {
    const own = columns[column];
    if (!given[column] && own === null) return quoted(infinite ?? "");
    const amount = given[column] ?? exactAmount(units, own ?? 0, unit);
    return amount.unit ? quoted(`${amount.value} ${amount.unit}`) : String(amount.value);
  };
  const { fields } = equipment.club_file;
  const origin = `${base.club}, clubface ${equipment.version}`;
  return [
    "# Made by the studio of clubface. Axes: x to the target, y up, z to the right of the target line (the toe side).",
    `name = ${quoted(nameOf(base.club))}`,
    `kind = ${quoted(kind)}`,
    ...(base.hand === "left" ? ['hand = "left"'] : []),
    `parameters = ${quoted(parameters)}`,
    `description = ${quoted(`${base.club} as changed in the studio`)}`,
    "",
    ...fields.map((field) => `${field.key} = ${number(field)}`),
    "",
    "[sources]",
    ...fields.map(({ key, column }) => `${key} = ${quoted(given[column] ? "changed in the studio" : origin)}`),
    "",
  ].join("\n");
}

/** What a changed club is called: its base is known by it again. */
const CHANGED = "-changed";
export const nameOf = (club: string): string => club + CHANGED;

/** Reads a file; an error says what is wrong with it. */
export async function readClub(text: string, equipment: Equipment, description: Description): Promise<ClubFile> {
  const { parse, TomlError } = await import("smol-toml");
  let document: Record<string, unknown>;
  try {
    document = parse(text);
  } catch (error) {
    if (!(error instanceof TomlError)) throw error;
    const [why] = error.message.replace(/^Invalid TOML document: /, "").split("\n");
    throw new Error(`line ${error.line} is not valid TOML: ${why}`);
  }
  const { fields, keys, kinds } = equipment.club_file;
  const word = (key: string, known?: readonly string[]): string => {
    const value = document[key] ?? "";
    if (typeof value !== "string" || (known && !known.includes(value)))
      throw new Error(
        `${key} is ${JSON.stringify(value)}; ${known ? `it must be ${known.join(", ")}` : "it must be text"}`,
      );
    return value;
  };
  const unknown = Object.keys(document).find((key) => !keys.includes(key));
  if (unknown !== undefined)
    throw new Error(`${unknown} is not a property of a club; files of meshed heads cannot be opened here`);
  if (document["cor"] !== undefined)
    throw new Error("cor is given, but this page needs characteristic_time; “clubface club check FILE” prints it");
  const kind = word("kind", kinds);
  const units = new Units(description);
  const amounts: ClubFile["amounts"] = {};
  for (const field of fields) {
    const value = document[field.key];
    if (value === undefined && !field.needed) amounts[field.column] = { value: 0, unit: field.unit };
    else amounts[field.column] = amountOf(units, field, value);
  }
  const name = word("name");
  if (!name) throw new Error("name is missing");
  return {
    name,
    kind,
    parameters: word("parameters") || usualFamily(equipment, kind),
    hand: document["hand"] === undefined ? "right" : word("hand", ["right", "left"]),
    description: word("description"),
    amounts,
  };
}

/** The family of the clubs of a kind. */
const usualFamily = (equipment: Equipment, kind: string): string =>
  Object.values(equipment.clubs).find((each) => each.kind === kind)?.parameters ?? "";

function amountOf(units: Units, { key, unit, least, most, infinite }: FileField, value: unknown): Amount {
  const wanted = `${key} must be text with its unit, such as "1 ${unit}"${infinite ? `, or "${infinite}"` : ""}`;
  if (value === undefined) throw new Error(`${key} is missing: ${wanted}`);
  if (infinite !== null && value === infinite) return { value: Infinity, unit };
  let amount: Amount;
  if (typeof value === "number" && Number.isFinite(value)) amount = exactAmount(units, value, unit);
  else if (typeof value === "string" && /[a-z]/i.test(value)) {
    try {
      amount = units.parse(value, unit);
    } catch (error) {
      throw new Error(`${key} is ${JSON.stringify(value)}: ${error instanceof Error ? error.message : wanted}`);
    }
  } else throw new Error(`${key} is ${JSON.stringify(value)}; ${wanted}`);
  const shown = units.fromSi(amount.unit ? units.toSi(amount) : amount.value, unit);
  if ((least !== null && shown < least) || (most !== null && shown > most))
    throw new Error(`${key} is ${JSON.stringify(value)}; it must be from ${least} to ${most} ${unit}`);
  return amount.unit ? amount : { value: shown, unit };
}

/** The club of the page that a file changes, and what differs from it. */
export function asChanges(
  file: ClubFile,
  equipment: Equipment,
  units: Units,
): { club: string; changes: Record<string, Amount> } {
  const values: Values = Object.fromEntries(
    Object.entries(file.amounts).map(([column, amount]) => [
      column,
      amount.value === Infinity ? Infinity : units.toSi(amount),
    ]),
  );
  const isFlat = (column: string): boolean => values[column] === Infinity;
  const fits = ([, { kind, parameters, columns }]: (typeof all)[number]): boolean =>
    kind === file.kind &&
    parameters === file.parameters &&
    ["bulge", "roll"].every((column) => !isFlat(column) || columns[column] === null);
  const all = Object.entries(equipment.clubs);
  const fitting = all.filter(fits);
  if (!fitting.length)
    throw new Error(`no club of the page is a ${file.kind} with parameters of ${file.parameters} and such a face`);
  const named = fitting.find(([name]) => file.name === name || file.name === nameOf(name));
  const away = ([, { columns }]: (typeof all)[number]): number =>
    Math.abs((columns.static_loft ?? 0) - values.static_loft);
  const [club, { columns }] = named ?? fitting.reduce((one, other) => (away(other) < away(one) ? other : one));
  const changes = Object.entries(file.amounts).filter(([column]) => values[column] !== (columns[column] ?? Infinity));
  return { club, changes: Object.fromEntries(changes) };
}
