// Times the core in WebAssembly as benchmarks/measure.py asks (JSON on stdin), and prints them in s (JSON on stdout).

import { readFileSync } from "node:fs";
import { load } from "../crates/clubface-c/clubface.js";

const asked = JSON.parse(readFileSync(0, "utf8"));
const [core, fem] = await Promise.all(asked.modules.map((path) => load(readFileSync(path))));

/** The shortest time of some runs, and the result of one. */
function shortest(run) {
  const times = [];
  let result;
  for (let sum = 0; times.length < 3 || sum < 1; sum += times.at(-1)) {
    const begun = performance.now();
    result = run();
    times.push((performance.now() - begun) / 1e3);
  }
  return [Math.min(...times), result];
}

const inputs = asked.inputs.map((column) => Float64Array.from(column));
const models = {};
for (const [model, parameters] of Object.entries(asked.models)) {
  const count = asked.shots[model];
  const some = inputs.map((column) => column.subarray(0, count));
  const [time, { outputs }] = shortest(() => core.launches(model, some, parameters, count));
  models[model] = { shot: time / count, ball_speed: outputs[0][0] };
}
const [wall, { text }] = shortest(() => fem.simulate(asked.case));
process.stdout.write(
  JSON.stringify({ node: process.version, models, reference: { wall, steps: text.steps, backspin: text.ball_spin[2] } }),
);
