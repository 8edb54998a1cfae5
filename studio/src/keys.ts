/** Keys that work anywhere on the page. */

import type { Actions } from "./context";

/** Ctrl+Z undoes; Ctrl+Shift+Z and Ctrl+Y redo. In a text that is being typed they belong to the text. */
export function watchKeys({ undo, redo }: Pick<Actions, "undo" | "redo">): void {
  addEventListener("keydown", (event) => {
    if (!(event.ctrlKey || event.metaKey) || event.altKey || isTyping(event.target)) return;
    const key = event.key.toLowerCase();
    if (key !== "z" && key !== "y") return;
    event.preventDefault();
    if (key === "y" || event.shiftKey) redo();
    else undo();
  });
}

/** Whether a field holds a text that was not taken yet. */
const isTyping = (target: EventTarget | null): boolean =>
  target instanceof HTMLInputElement && target.type === "text" && target.dataset.shown !== target.value;
