/** Expressions as MathML, with whatever stands for a name. */

import { mathml, nothing, type TemplateResult } from "lit-html";
import type { Tree } from "./tree";

/** `isBase` is true below a power, where a value with a unit needs brackets. */
export type Leaf = (name: string, isBase: boolean) => TemplateResult;

/** How firmly an operation binds: a weaker one within a stronger one stands in brackets. */
const BINDING: Record<string, number> = { "+": 1, "-": 1, neg: 1, "*": 2, "/": 4, "^": 3 };
const binding = (tree: Tree): number => (Array.isArray(tree) ? (BINDING[tree[0]] ?? 4) : 4);

const SIGNS: Record<string, string> = { "+": "+", "-": "−", "*": "·" };

const part = (template: TemplateResult<3>): TemplateResult => template as TemplateResult;

export function mathOf(tree: Tree, leaf: Leaf): TemplateResult {
  if (typeof tree === "number") return part(mathml`<mn>${tree}</mn>`);
  if (typeof tree === "string") return leaf(tree, false);
  const [operation, first, second] = tree as [string, Tree, Tree];
  const within = (each: Tree, least: number): TemplateResult =>
    binding(each) < least ? bracketed(mathOf(each, leaf)) : mathOf(each, leaf);
  switch (operation) {
    case "/":
      return part(mathml`<mfrac><mrow>${mathOf(first, leaf)}</mrow><mrow>${mathOf(second, leaf)}</mrow></mfrac>`);
    case "^":
      return part(
        mathml`<msup><mrow>${typeof first === "string" ? leaf(first, true) : within(first, 4)}</mrow>${mathOf(second, leaf)}</msup>`,
      );
    case "neg":
      return part(mathml`<mrow><mo form="prefix">−</mo>${within(first, 2)}</mrow>`);
    case "sqrt":
      return part(mathml`<msqrt>${mathOf(first, leaf)}</msqrt>`);
    case "sin":
    case "cos":
      return part(mathml`<mrow><mi>${operation}</mi><mspace width="0.1em"></mspace>${within(first, 4)}</mrow>`);
    case "asin":
      return part(mathml`<mrow><mi>arcsin</mi>${bracketed(mathOf(first, leaf))}</mrow>`);
    case "atan2":
      // The quadrant follows from both signs, which a fraction alone does not have.
      return part(mathml`<mrow><mi>arctan</mi>${bracketed(mathOf(["/", first, second], leaf))}</mrow>`);
    default: {
      const least = BINDING[operation];
      // What is taken away binds more firmly on the right.
      const right = within(second, operation === "-" ? least + 1 : least);
      return part(mathml`<mrow>${within(first, least)}<mo>${SIGNS[operation]}</mo>${right}</mrow>`);
    }
  }
}

const bracketed = (inner: TemplateResult): TemplateResult => part(mathml`<mrow><mo>(</mo>${inner}<mo>)</mo></mrow>`);

/** A symbol and its index, which may be empty. */
export const symbolMath = (letter: string, index: string): TemplateResult =>
  part(index ? mathml`<msub><mi>${letter}</mi><mi>${index}</mi></msub>` : mathml`<mi>${letter}</mi>`);

/** A number with its unit; one below zero stands in brackets, and below a power one with a unit, too. */
export const valueMath = (number: string, unit: string, isBase = false): TemplateResult => {
  const space = unit && !unit.startsWith("°") && unit !== "%";
  const inner = part(
    mathml`<mrow><mn>${number.replace("-", "−")}</mn>${space ? mathml`<mspace width="0.2em"></mspace>` : nothing}${unit ? mathml`<mtext>${unit}</mtext>` : nothing}</mrow>`,
  );
  return /^[-−]/.test(number) || (isBase && unit) ? bracketed(inner) : inner;
};
