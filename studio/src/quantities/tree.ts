/** Expressions as `data.py` writes them: what is drawn is what is computed. */

import type { Values } from "../core/types";

/** A number, a name, or an operator or function and what it is of. */
export type Tree = number | string | Branch;

/** Its parts are expressions. */
interface Branch extends Array<Tree> {
  0: string;
}

type Operation = (...values: number[]) => number;

const OPERATIONS: Record<string, Operation> = {
  "+": (a, b) => a + b,
  "-": (a, b) => a - b,
  "*": (a, b) => a * b,
  "/": (a, b) => a / b,
  "^": (a, b) => a ** b,
  neg: (a) => -a,
  sqrt: Math.sqrt,
  sin: Math.sin,
  cos: Math.cos,
  asin: Math.asin,
  atan2: Math.atan2,
};

/** The value of an expression [SI]; NaN where a name has none. */
export function evaluate(tree: Tree, values: Values): number {
  if (typeof tree === "number") return tree;
  if (typeof tree === "string") return values[tree] ?? Number.NaN;
  const [operation, ...of] = tree as [string, ...Tree[]];
  return OPERATIONS[operation](...of.map((each) => evaluate(each, values)));
}

/** The names in an expression, each once. */
export function namesIn(tree: Tree): string[] {
  if (typeof tree === "number") return [];
  if (typeof tree === "string") return [tree];
  const [, ...of] = tree as [string, ...Tree[]];
  return [...new Set(of.flatMap(namesIn))];
}
