import { expect, test } from "vitest";
import { strikeOf } from "../../src/equipment/equipment";
import { Units } from "../../src/quantities/units";
import { fromLink } from "../../src/state/link";
import { initialState } from "../../src/state/state";
import { description, equipment } from "../described";
import { golden, linkOf } from "../golden";

/** Relative difference: the last bits of the conversion to SI. */
const SAME = 1e-15;

test("a link gives the inputs and parameters that the package gives for the same options", () => {
  const units = new Units(description);
  const usual = initialState(equipment, "golf");
  const wrong: string[] = [];
  for (const shot of golden.shots) {
    const context = { equipment, units, inputs: description.inputs, scenes: ["shot"], settings: {}, usual };
    const { state, problems } = fromLink(linkOf(shot), context);
    expect(problems).toEqual([]);
    const given = Object.entries(state.delivery).map(([name, amount]) => [name, units.toSi(amount)]);
    const { model, inputs, parameters } = strikeOf(description, equipment, state, Object.fromEntries(given));
    const expected = { ...golden.equipment[shot.equipment], ...shot.delivery };
    description.inputs.forEach(({ name }, i) => {
      const value = expected[name] ?? Infinity;
      if (inputs[i] !== value && !(Math.abs(inputs[i] - value) <= SAME * Math.abs(value)))
        wrong.push(`${linkOf(shot)}: ${name} ${inputs[i]}, not ${value}`);
    });
    expect(model).toBe(shot.link.model);
    expect(parameters).toEqual(golden.parameters[shot.parameters]);
  }
  expect(wrong).toEqual([]);
});
