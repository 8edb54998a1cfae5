/** Colours of the page for canvases, which need them worked out for the theme. */

/** Variables whose values the browser resolves, since it knows that they are colours. */
const typed = new Set<string>();

/** Reads colours of the page, such as `--ink`, as they are where an element stands. */
export function colourReader(element: Element): (variable: string) => string {
  const style = getComputedStyle(element);
  return (variable) => {
    if (!typed.has(variable)) {
      typed.add(variable);
      CSS.registerProperty({ name: variable, syntax: "<color>", inherits: true, initialValue: "gray" });
    }
    return style.getPropertyValue(variable);
  };
}
