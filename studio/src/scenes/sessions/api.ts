/** Questions to the package, relative to the page: its answers are results, its mistakes sentences. */

import type { System } from "../../quantities/formatter";
import type { Asked, ServerMistake } from "../../state/session";

/** Where a request went wrong that had no answer. */
const GONE: ServerMistake = {
  where: "",
  what: "The studio's server does not answer. Start clubface studio again and open the address that it prints",
  allowed: null,
};

/** The address of an answer whose sentences are in the units that the page shows. */
export const inUnits = (path: string, system: System): string =>
  system === "golf" ? path : `${path}${path.includes("?") ? "&" : "?"}units=${system}`;

/** The answer to a request, or the mistake. */
export async function ask<T>(
  request: () => Promise<Response>,
  read: (response: Response) => Promise<T>,
): Promise<Asked<T>> {
  let response: Response;
  try {
    response = await request();
  } catch {
    return { state: "refused", mistake: GONE };
  }
  try {
    if (response.ok) return { state: "there", value: await read(response) };
    return { state: "refused", mistake: (await response.json()) as ServerMistake };
  } catch {
    return { state: "refused", mistake: { where: "", what: `The server answered ${response.status}`, allowed: null } };
  }
}

export const askJson = <T>(path: string, options?: RequestInit): Promise<Asked<T>> =>
  ask(
    () => fetch(path, options),
    (response) => response.json() as Promise<T>,
  );

export const askText = (path: string): Promise<Asked<string>> =>
  ask(
    () => fetch(path),
    (response) => response.text(),
  );
