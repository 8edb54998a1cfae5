/** The point of the map that is read: under the mouse, or moved by the arrow keys. */

import type { Context } from "../../context";
import type { Place } from "./field";

const KEPT = "map_cursor";

/** Null where none is pointed at. */
export function cursorOf({ model }: Context): Place | null {
  const [toe, high] = (model.transient[KEPT] ?? "").split(" ");
  return toe && high ? [Number(toe), Number(high)] : null;
}

/** Points at a place; nothing is done where it is pointed at already. */
export function pointAt(context: Context, place: Place | null): void {
  const kept = place?.join(" ") ?? "";
  if (kept !== (context.model.transient[KEPT] ?? "")) context.actions.keep({ [KEPT]: kept });
}
