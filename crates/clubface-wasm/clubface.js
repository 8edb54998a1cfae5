// clubface in WebAssembly: launches, flights and the reference case of the finite elements, on typed arrays. SI and radians.

/**
 * @param {BufferSource | WebAssembly.Module} source the compiled module
 * @param {(time: number, duration: number) => boolean | void} progress sees a simulation go on (s); false stops it
 */
export async function load(source, progress = () => true) {
  const imports = {
    clubface: {
      now: () => performance.now() / 1e3,
      progress: (time, duration) => (progress(time, duration) === false ? 0 : 1),
    },
  };
  const compiled = await WebAssembly.instantiate(source, imports);
  const core = (compiled.instance ?? compiled).exports;
  const decoder = new TextDecoder();

  const text = () =>
    JSON.parse(decoder.decode(new Uint8Array(core.memory.buffer, core.text_at(), core.text_length())));

  function call(name, ...values) {
    const failed = core[name](...values);
    const result = text();
    if (failed) throw new Error(result.input ? `${result.input}: ${result.message}` : result.message);
    return result;
  }

  /** Runs `work` with memory of the module for each array or count given; a view is valid until the module runs again. */
  function lend(arrays, work) {
    const counts = arrays.map((array) => (typeof array === "number" ? array : array.length));
    const places = counts.map((count) => core.allocate(count));
    const view = (i) => new Float64Array(core.memory.buffer, places[i], counts[i]);
    try {
      arrays.forEach((array, i) => typeof array === "number" || view(i).set(array));
      return work(places, view);
    } finally {
      places.forEach((place, i) => core.release(place, counts[i]));
    }
  }

  const description = call("describe");

  /** Number of a model that has as many parameters. */
  function numberOf(model, parameters) {
    const index = description.models.findIndex(({ name }) => name === model);
    if (parameters.length === description.models[index]?.parameters.length) return index;
    throw new Error(`model: '${model}' is unknown, or has another number of parameters`);
  }

  /** Columns, or one number for all rows, one after the other. */
  function flat(columns, rows) {
    const all = new Float64Array(columns.length * rows);
    columns.forEach((column, i) => {
      if (typeof column === "number") all.fill(column, i * rows, (i + 1) * rows);
      else all.set(column, i * rows);
    });
    return all;
  }

  const split = (all, rows) =>
    Array.from({ length: all.length / rows }, (_, i) => all.slice(i * rows, (i + 1) * rows));

  return {
    /** Models, inputs and outputs of impacts and flights: names, units, meanings, bounds. */
    description,

    /**
     * Launches of `rows` shots by a model: {outputs: one array an output, rejects: [{row, input, message}]}.
     * `inputs` are numbers or arrays in the order of the description; `parameters` numbers in the order of the model's.
     * `tolerance` is that of a step of a contact; 0 is the fast setting.
     */
    launches(model, inputs, parameters, rows, tolerance = 0) {
      const index = numberOf(model, parameters);
      const arrays = [flat(inputs, rows), Float64Array.from(parameters), description.outputs.length * rows];
      return lend(arrays, ([from, set, to], view) => {
        const rejects = call("launches", index, from, set, rows, tolerance, to);
        return { outputs: split(view(2), rows), rejects };
      });
    },

    /** Launch of one shot with its derivatives: {values, jacobian: a row an output, by the inputs and then the parameters}. */
    sensitivity(model, inputs, parameters, tolerance = 0) {
      const index = numberOf(model, parameters);
      const width = inputs.length + parameters.length;
      const count = description.outputs.length;
      const arrays = [Float64Array.from(inputs), Float64Array.from(parameters), count, count * width];
      return lend(arrays, ([from, set, to, jacobian], view) => {
        call("sensitivity", index, from, set, tolerance, to, jacobian);
        return { values: view(2).slice(), jacobian: split(view(3), width) };
      });
    },

    /** Flights of `rows` launches, likewise. */
    flights(inputs, rows) {
      const arrays = [flat(inputs, rows), description.flight_outputs.length * rows];
      return lend(arrays, ([from, to], view) => {
        const rejects = call("flights", from, rows, to);
        return { outputs: split(view(1), rows), rejects };
      });
    },

    /** Throws the reference ball at a rigid plane: speed (m/s), angle from its normal (rad), friction, fineness of the mesh. */
    referenceCase: ({ speed = 35, angle = (11.5 * Math.PI) / 180, friction = 0.35, refine = 1 } = {}) =>
      call("reference_case", speed, angle, friction, refine),
  };
}
