/** Styles of a scene come with it and stay: they must not reach what other scenes show. */

import { readdirSync, readFileSync } from "node:fs";
import { join } from "node:path";
import { expect, test } from "vitest";

const SOURCE = join(import.meta.dirname, "../../src");
/** Styles that are loaded with a scene, and the class of the scene's root. */
const LOADED = {
  design: ["scenes/design/design.css", "design"],
  elements: ["scenes/elements/elements.css", "elements"],
  flight: ["style/flight.css", "range"],
  learn: ["scenes/learn/learn.css", "learn"],
  map: ["scenes/map/map.css", "map"],
} as const;

const text = (path: string): string => readFileSync(join(SOURCE, path), "utf8");

/** All classes in the templates of the scenes other than `name`, those of expressions included. */
function classesElsewhere(name: string): Set<string> {
  const files = readdirSync(join(SOURCE, "scenes"), { recursive: true, encoding: "utf8" }).filter(
    (file) => file.endsWith(".ts") && !file.startsWith(`${name}/`),
  );
  const attributes = files.flatMap((file) => text(join("scenes", file)).match(/\bclass=("[^"]*"|\$\{[^}]*\})/g) ?? []);
  const texts = attributes.flatMap((attribute) => attribute.match(/["`][^"`$]*/g) ?? []);
  return new Set(texts.flatMap((each) => each.match(/[\w-]+/g) ?? []));
}

const selectorsOf = (css: string): string[] =>
  [...css.replace(/\/\*[\s\S]*?\*\//g, "").matchAll(/([^{};]+)\{/g)]
    .flatMap(([, selectors]) => selectors.split(","))
    .map((selector) => selector.trim())
    .filter((selector) => !/^(@|:root|from$|to$|\d)/.test(selector));

test.each(Object.entries(LOADED))("the styles of %s reach no other scene", (name, [file, root]) => {
  const elsewhere = classesElsewhere(name);
  expect(elsewhere).not.toContain(root);
  const reaching = selectorsOf(text(file)).filter((selector) => {
    const classes = [...selector.matchAll(/\.([\w-]+)/g)].map(([, each]) => each);
    return !classes.includes(root) && classes.every((each) => elsewhere.has(each));
  });
  expect(reaching).toEqual([]);
});
