import { expect, test, vi } from "vitest";
import { CONDITIONS } from "../../src/state/conditions";
import { USED_CLUB } from "../../src/state/used-club";
import { description } from "../described";

test("no two scenes have a setting of the same name, and none is called like an input of the delivery", async () => {
  // Two scenes are loaded with the page and watch the sizes of its pictures.
  vi.stubGlobal("ResizeObserver", class {});
  const { SCENES } = await import("../../src/scenes/scenes");
  const names = [CONDITIONS, USED_CLUB, ...SCENES.map(({ settings = {} }) => settings)].flatMap((each) =>
    Object.keys(each),
  );
  const inputs = description.inputs.filter(({ group }) => group === "delivery").map(({ name }) => name);
  expect(names.filter((name, i) => names.indexOf(name) !== i || inputs.includes(name))).toEqual([]);
});
