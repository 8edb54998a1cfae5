import { expect, test } from "vitest";
import { setNames, strikeOf } from "../../src/equipment/equipment";
import { DELIVERY } from "../../src/scenes/shot/words";
import { initialState } from "../../src/state/state";
import { description, equipment } from "../described";

const usual = initialState(equipment, "golf");
const input = (inputs: number[], name: string): number =>
  inputs[description.inputs.findIndex((each) => each.name === name)];

test("the inputs stand in the order of the core", () => {
  expect(equipment.inputs).toEqual(description.inputs.map(({ name }) => name));
});

test("every club with every ball and model has a strike of finite numbers, but for flat faces", () => {
  const wrong: string[] = [];
  for (const club of Object.keys(equipment.clubs))
    for (const ball of Object.keys(equipment.balls))
      for (const { name: model, parameters } of description.models) {
        const strike = strikeOf(description, equipment, { ...usual, club, ball, model }, { speed: 40 });
        const mayBeFlat = (at: number): boolean => ["bulge", "roll"].includes(description.inputs[at].name);
        const isFine = strike.inputs.every(
          (value, at) => Number.isFinite(value) || (mayBeFlat(at) && value === Infinity),
        );
        if (!isFine || strike.parameters.length !== parameters.length) wrong.push(`${club}, ${ball}, ${model}`);
      }
  expect(wrong).toEqual([]);
});

test("the loft that is left out is the club's, and the rest 0", () => {
  const { inputs } = strikeOf(description, equipment, usual, { speed: 45 });
  expect(input(inputs, "loft")).toBe(input(inputs, "static_loft"));
  expect(input(inputs, "speed")).toBe(45);
  expect(input(inputs, "face")).toBe(0);
  expect(input(inputs, "hand")).toBe(1);
});

test("a left-handed club is the mirror image by its hand alone", () => {
  const right = strikeOf(description, equipment, usual, { speed: 45 }).inputs;
  const left = strikeOf(description, equipment, { ...usual, hand: "left" }, { speed: 45 }).inputs;
  const changed = description.inputs.filter((_, i) => right[i] !== left[i]).map(({ name }) => name);
  expect(changed).toEqual(["hand"]);
});

test("the usual parameters come first among the sets", () => {
  for (const { name: model } of description.models) expect(setNames(equipment, { ...usual, model })[0]).toBe("");
});

test("the core describes where every input of the delivery usually lies", () => {
  expect(Object.keys(DELIVERY)).not.toHaveLength(0);
  for (const name of Object.keys(DELIVERY)) {
    const [least, most] = description.inputs.find((each) => each.name === name)?.usual ?? [0, 0];
    expect(least, name).toBeLessThan(most);
  }
});
