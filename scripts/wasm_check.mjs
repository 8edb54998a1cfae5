// Runs what scripts/wasm_check.py asks for (JSON on stdin) in WebAssembly, and prints what came out (JSON on stdout).

import { readFileSync } from "node:fs";
import { brotliCompressSync } from "node:zlib";
import { load } from "../crates/clubface-c/clubface.js";

const asked = JSON.parse(readFileSync(0, "utf8"));
const bytes = readFileSync(asked.module);
let calls = 0;
const elements = readFileSync(asked.fem);
const core = await load(bytes);
const fem = await load(elements, () => void (calls += 1));

/** The least time of some runs, s, with the result. */
function timed(run, times) {
  let least = Infinity;
  let result;
  for (let i = 0; i < times; i += 1) {
    const start = performance.now();
    result = run();
    least = Math.min(least, performance.now() - start);
  }
  return { ...result, outputs: result.outputs.map((column) => Array.from(column)), seconds: least / 1e3 };
}

const launches = {};
for (const [model, parameters] of Object.entries(asked.models))
  launches[model] = timed(() => core.launches(model, asked.inputs, parameters, asked.inputs[0].length), 3);
const first = asked.inputs.map((column) => column[0]);
const derivatives = {};
for (const [model, parameters] of Object.entries(asked.models)) {
  const { values, jacobian } = core.sensitivity(model, first, parameters);
  derivatives[model] = [Array.from(values), jacobian.map((row) => Array.from(row))];
}
/** Columns of values and of derivatives, one after the other for each output. */
const inRows = ({ outputs, derivatives }) =>
  outputs.flatMap((values, i) => [values, ...derivatives[i]].map((each) => Array.from(each)));
const chosen = {};
for (const [model, parameters] of Object.entries(asked.models)) {
  const { outputs, variables } = asked.chosen;
  chosen[model] = inRows(core.sensitivities(model, asked.inputs, parameters, asked.inputs[0].length, outputs, variables));
}
const inAir = core.flightSensitivity(asked.flights.map((column) => column[0]));
const flights = timed(() => core.flights(asked.flights, asked.flights[0].length), 3);

const at = (variables, columns, name) => columns[variables.findIndex((each) => each.name === name)];
const { flight_outputs: flownBy } = core.description;
const starts = at(core.description.outputs, launches.standard.outputs, "azimuth");
const shapes = core.shotShapes(
  Float64Array.from(starts.filter((_, row) => !Number.isNaN(starts[row]))),
  ...["curve", "carry"].map((name) => Float64Array.from(at(flownBy, flights.outputs, name))),
);

/** Arrays by name as JSON has them. */
const plain = (arrays) =>
  Object.fromEntries(Object.entries(arrays).map(([name, { values, shape }]) => [name, { values: [...values], shape }]));

/** What `core` says of something that it cannot compute. */
const refusals = [
  () => core.launches("no such model", asked.inputs, [], 1),
  () => core.launches("standard", asked.inputs, asked.models.standard, asked.inputs[0].length, 1),
  () => core.simulate(asked.case),
].map((run) => {
  try {
    return String(run());
  } catch (error) {
    return error.message;
  }
});

const dispersion = core.dispersion(asked.dispersion, asked.count, 3);
const { least, margins } = core.buildable(asked.space, asked.heads, asked.heads[0].length);
const path = core.trajectory(asked.flights.map((column) => column[0]));
const history = core.history("rings", first, asked.models.rings);
const reference = fem.simulate(asked.case).text;
const seen = calls;
const { stopped } = (await load(elements, (time) => time < 1e-4)).simulate(asked.case).text;
process.stdout.write(
  JSON.stringify({
    dispersion: { ...dispersion.text, landings: [...dispersion.arrays.landings.values] },
    buildable: { least: [...least], margins },
    description: core.description, launches, derivatives, chosen, flights, shapes, refusals, reference, seen, stopped,
    flight_derivatives: [Array.from(inAir.values), inAir.jacobian.map((row) => Array.from(row))],
    path: plain(path), history: plain(history),
    sizes: [bytes, elements].map((each) => [each.length, brotliCompressSync(each).length]),
  }),
);
