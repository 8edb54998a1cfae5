import { existsSync, readFileSync } from "node:fs";
import { type LoadedCore, load } from "clubface-core";
import { beforeAll, describe, expect, test } from "vitest";
import { computeModel, outputValues } from "../../src/core/compute";
import { thrownOf } from "../../src/core/elements";
import type { Dispersion, FaceMapSummary, Strike, Values } from "../../src/core/types";
import { strikeOf } from "../../src/equipment/equipment";
import { Units } from "../../src/quantities/units";
import { CONDITIONS, flightConditions } from "../../src/state/conditions";
import { fromLink } from "../../src/state/link";
import { initialState } from "../../src/state/state";
import { description, equipment } from "../described";
import { Comparison, dispersions, elements, flights, type GoldenShot, linkOf, maps, shots } from "../golden";

/** Relative difference: the last bits of the conversion to SI. */
const CONVERTED = 1e-15;
const CORE = new URL("../../generated/clubface-fem.wasm", import.meta.url);
/** Finite elements take seconds, of a machine that others share several times as many [ms]. */
const PATIENCE = { timeout: 60e3 };
const units = new Units(description);

/** The strike that a link stands for. */
function strikeOfLink(shot: GoldenShot): Strike {
  const usual = initialState(equipment, "golf");
  const context = { equipment, units, inputs: description.inputs, scenes: ["shot"], settings: CONDITIONS, usual };
  const { state, problems } = fromLink(linkOf(shot), context);
  expect(problems).toEqual([]);
  const given = Object.entries(state.delivery).map(([name, amount]) => [name, units.toSi(amount)]);
  const strike = strikeOf(description, equipment, state, Object.fromEntries(given));
  return { ...strike, flight: flightConditions(state, equipment, units) };
}

test.each([
  ["shots", shots],
  ["flights", flights],
] as const)("links of %s give the inputs and parameters that the package gives for the same options", (_, golden) => {
  const wrong: string[] = [];
  for (const shot of golden.cases) {
    const { model, inputs, parameters } = strikeOfLink(shot);
    const expected = { ...golden.equipment[shot.equipment], ...shot.delivery };
    description.inputs.forEach(({ name }, i) => {
      const value = expected[name] ?? Infinity;
      if (inputs[i] !== value && !(Math.abs(inputs[i] - value) <= CONVERTED * Math.abs(value)))
        wrong.push(`${linkOf(shot)}: ${name} ${inputs[i]}, not ${value}`);
    });
    expect(model).toBe(shot.model);
    expect(parameters).toEqual(golden.parameters[shot.parameters]);
  }
  expect(wrong).toEqual([]);
});

/** The numbers of a face by the names under which they are stored. */
function faceNumbers({ face_area, effective_area, best, forgiveness }: FaceMapSummary): Values {
  const numbers: Values = { face_area, effective_area: effective_area ?? Number.NaN };
  for (const [name, point] of Object.entries(best)) {
    const { toe, high, value } = point ?? { toe: Number.NaN, high: Number.NaN, value: Number.NaN };
    Object.assign(numbers, { [`toe ${name}`]: toe, [`high ${name}`]: high, [`${name} greatest`]: value });
  }
  numbers.missed = forgiveness?.missed ?? Number.NaN;
  for (const kind of ["mean", "deviation", "loss"] as const)
    for (const [name, value] of Object.entries(forgiveness?.[kind] ?? {})) numbers[`${name} ${kind}`] = value;
  return numbers;
}

/** The same of where shots go. */
function dispersionNumbers(dispersion: Dispersion, shares: number[]): Values {
  const { lost, strokes, lies, quantities, ellipses } = dispersion;
  const numbers: Values = { shots: dispersion.shots, lost, strokes: strokes ?? Number.NaN };
  for (const [lie, share] of Object.entries(lies)) numbers[`share ${lie}`] = share ?? Number.NaN;
  for (const [name, { mean, spread, percentiles }] of Object.entries(quantities)) {
    Object.assign(numbers, { [`${name} mean`]: mean, [`${name} spread`]: spread });
    percentiles.forEach((value, i) => {
      numbers[`${name} ${shares[i]}`] = value;
    });
  }
  for (const { share, centre, half_axes, angle } of ellipses) {
    [numbers[`carry centre ${share}`], numbers[`side centre ${share}`]] = centre;
    [numbers[`carry long ${share}`], numbers[`carry short ${share}`]] = half_axes;
    numbers[`azimuth ellipse ${share}`] = angle;
  }
  return numbers;
}

describe.skipIf(!existsSync(CORE))(
  "the core in WebAssembly (made by make studio-build) gives the numbers of",
  PATIENCE,
  () => {
    let core: LoadedCore;

    beforeAll(async () => {
      core = await load(readFileSync(CORE));
    });

    test.each([
      ["shots", shots],
      ["flights", flights],
    ] as const)("%s, from their links", (_, { cases }) => {
      const comparison = new Comparison();
      for (const shot of cases) comparison.addAll(shot, computeModel(core, strikeOfLink(shot)).values, shot.numbers);
      expect(comparison.wrong).toEqual([]);
      expect(comparison.count).toBeGreaterThan(26 * cases.length);
    });

    test("maps of faces", () => {
      const comparison = new Comparison();
      for (const map of maps) {
        const quantity = map.link.map;
        const [first, second] = map.faces.map(({ setup, numbers }) => {
          const { text, arrays } = core.faceMap(setup);
          comparison.addAll(map, faceNumbers(text), numbers);
          const [, rows, columns] = arrays.values.shape;
          const start = text.quantities.indexOf(quantity) * rows * columns;
          for (const axis of ["toe", "high"] as const)
            map[axis].forEach((place, i) => {
              comparison.add(map, axis, arrays[axis].values[i * map.step], place);
            });
          return (row: number, column: number) => arrays.values.values[start + map.step * (row * columns + column)];
        });
        map.values.forEach((row, up) => {
          row.forEach((value, across) => {
            comparison.add(map, quantity, first(up, across) - (second?.(up, across) ?? 0), value);
          });
        });
      }
      expect(comparison.wrong).toEqual([]);
      expect(comparison.count).toBeGreaterThan(80 * maps.length);
    });

    test("shots of golfers", () => {
      const comparison = new Comparison();
      for (const each of dispersions) {
        const { text } = core.dispersion(each.setup, each.count);
        comparison.addAll(each, dispersionNumbers(text, each.setup.percentiles), each.numbers);
      }
      expect(comparison.wrong).toEqual([]);
      expect(comparison.count).toBe(80 * dispersions.length);
    });

    test("the reference case and a drive by finite elements", () => {
      const comparison = new Comparison();
      for (const each of elements) {
        const { text } = core.simulate(each.setup);
        const outcome =
          "plane" in each.setup.face ? thrownOf(text) : outputValues(core.description.outputs, text.launch ?? []);
        comparison.addAll(each, { ...(text as unknown as Values), ...outcome }, each.numbers);
      }
      expect(comparison.wrong).toEqual([]);
      expect(comparison.count).toBeGreaterThan(16 * elements.length);
    });
  },
);
