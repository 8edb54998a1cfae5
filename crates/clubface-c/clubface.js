// clubface in WebAssembly: the C interface on typed arrays. SI units and radians.

const KINDS = [Float64Array, Float32Array, Uint32Array];

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
  const encoder = new TextEncoder();
  const decoder = new TextDecoder();

  /** The text at an address, up to its null byte. */
  function textAt(address) {
    const bytes = new Uint8Array(core.memory.buffer);
    return decoder.decode(bytes.subarray(address, bytes.indexOf(0, address)));
  }

  /** Runs `work` with the addresses of copies of texts and arrays; a number is that many doubles to be written. */
  function lend(values, work) {
    const copies = values.map((value) => (typeof value === "string" ? encoder.encode(`${value}\0`) : value));
    const sizes = copies.map((copy) => (typeof copy === "number" ? copy * 8 : copy.byteLength));
    const places = sizes.map((size) => core.clubface_allocate(size));
    try {
      copies.forEach((copy, i) => {
        if (typeof copy !== "number") new copy.constructor(core.memory.buffer, places[i], copy.length).set(copy);
      });
      return work(places, (i) => new Float64Array(core.memory.buffer, places[i], sizes[i] / 8).slice());
    } finally {
      places.forEach((place, i) => core.clubface_release(place, sizes[i]));
    }
  }

  /** Calls a function of the core: its text, and its arrays by name as {values, shape}. */
  function call(name, ...values) {
    if (!core[name]) throw new Error(`${name} is not in this module; clubface-fem.wasm has the finite elements`);
    const result = core[name](...values);
    try {
      const failure = core.clubface_error(result);
      if (failure) {
        const { input, value, message } = JSON.parse(textAt(failure));
        throw new Error(input ? `${input}: ${value ? `${value}; ` : ""}${message}` : message);
      }
      return { text: JSON.parse(textAt(core.clubface_text(result))), arrays: arraysOf(result) };
    } finally {
      core.clubface_free(result);
    }
  }

  function arraysOf(result) {
    const arrays = {};
    lend([2], ([place]) => {
      for (let i = 0; i < core.clubface_array_count(result); i += 1) {
        const start = core.clubface_array(result, i, place, place + 4);
        const [length, kind] = new Uint32Array(core.memory.buffer, place, 2);
        const shape = [];
        for (let size; (size = core.clubface_array_size(result, i, shape.length)); ) shape.push(size);
        const values = new KINDS[kind](core.memory.buffer, start, length).slice();
        arrays[textAt(core.clubface_array_name(result, i))] = { values, shape };
      }
    });
    return arrays;
  }

  const description = call("clubface_describe").text;

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

  /** Refuses a model that is unknown, or that has another number of parameters. */
  function checkModel(name, parameters) {
    const model = description.models.find((each) => each.name === name);
    const known = description.models.map((each) => each.name).join(", ");
    if (!model) throw new Error(`model: '${name}' is unknown; there are ${known}`);
    const count = model.parameters.length;
    if (count !== parameters.length) throw new Error(`parameters: ${parameters.length} given; ${name} has ${count}`);
  }

  return {
    /** Quantities, units, models, inputs and outputs of impacts and flights: names, units, meanings, bounds. */
    description,

    /**
     * Launches of `rows` shots by a model: {outputs: one array an output, rejects: [{row, input, message}]}.
     * `inputs` are numbers or arrays in the order of the description; `parameters` numbers in the order of the model's.
     * `tolerance` is that of a step of a contact; 0 is the fast setting.
     */
    launches(model, inputs, parameters, rows, tolerance = 0) {
      checkModel(model, parameters);
      const lent = [model, flat(inputs, rows), Float64Array.from(parameters), description.outputs.length * rows];
      return lend(lent, ([name, from, set, to], copy) => {
        const { text: rejects } = call("clubface_launches", name, from, set, rows, tolerance, 1, to);
        return { outputs: split(copy(3), rows), rejects };
      });
    },

    /** Launch of one shot with its derivatives: {values, jacobian: a row an output, by the inputs and then the parameters}. */
    sensitivity(model, inputs, parameters, tolerance = 0) {
      checkModel(model, parameters);
      const width = inputs.length + parameters.length;
      const count = description.outputs.length;
      const lent = [model, Float64Array.from(inputs), Float64Array.from(parameters), count, count * width];
      return lend(lent, ([name, from, set, to, jacobian], copy) => {
        call("clubface_sensitivity", name, from, set, tolerance, to, jacobian);
        return { values: copy(3), jacobian: split(copy(4), width) };
      });
    },

    /**
     * Chosen outputs of `rows` shots and their derivatives by chosen variables:
     * {outputs: one array an output, derivatives: for each output an array a variable, rejects}.
     * `outputs` are places among the outputs of the description, `variables` among its inputs and then the parameters.
     */
    sensitivities(model, inputs, parameters, rows, outputs, variables, tolerance = 0) {
      checkModel(model, parameters);
      const width = 1 + variables.length;
      const chosen = [Uint32Array.from(outputs), Uint32Array.from(variables), outputs.length * width * rows];
      const lent = [model, flat(inputs, rows), Float64Array.from(parameters), ...chosen];
      return lend(lent, ([name, from, set, which, by, to], copy) => {
        const sizes = [rows, which, outputs.length, by, variables.length];
        const { text: rejects } = call("clubface_sensitivities", name, from, set, ...sizes, tolerance, 1, to);
        const columns = split(copy(5), rows);
        const ofEach = outputs.map((_, i) => columns.slice(i * width, (i + 1) * width));
        return { outputs: ofEach.map(([values]) => values), derivatives: ofEach.map((each) => each.slice(1)), rejects };
      });
    },

    /** History of one shot by a contact model: arrays by name as {values, shape}. */
    history(model, inputs, parameters, tolerance = 0) {
      checkModel(model, parameters);
      const lent = [model, Float64Array.from(inputs), Float64Array.from(parameters)];
      return lend(lent, (places) => call("clubface_history", ...places, tolerance).arrays);
    },

    /** Flights of `rows` launches: {outputs: one array an output, rejects}. */
    flights(inputs, rows) {
      return lend([flat(inputs, rows), description.flight_outputs.length * rows], ([from, to], copy) => {
        const { text: rejects } = call("clubface_flights", from, rows, 1, to);
        return { outputs: split(copy(1), rows), rejects };
      });
    },

    /** Pressure of the standard atmosphere at an altitude (Pa, m). */
    pressureAtAltitude: (altitude) => core.clubface_pressure_at_altitude(altitude),

    /** Density of moist air (kg/m3) by temperature (K), pressure (Pa) and relative humidity (0 to 1). */
    airDensity: (temperature, pressure, humidity) => core.clubface_air_density(temperature, pressure, humidity),

    /** One flight with its derivatives: {values, jacobian: a row an output, by the inputs}. */
    flightSensitivity(inputs) {
      const count = description.flight_outputs.length;
      return lend([Float64Array.from(inputs), count, count * inputs.length], ([from, to, jacobian], copy) => {
        call("clubface_flight_sensitivity", from, to, jacobian);
        return { values: copy(1), jacobian: split(copy(2), inputs.length) };
      });
    },

    /** Names of shots by their shape, such as "pull hook", from columns of launches and flights. */
    shotShapes: (azimuth, curve, carry, hand = 1) =>
      lend([azimuth, curve, carry], (places) => call("clubface_shot_shapes", ...places, azimuth.length, hand).text),

    /** Path of one flight: `time`, `position`, `velocity`, `spin` as {values, shape}. */
    trajectory: (inputs) =>
      lend([Float64Array.from(inputs)], ([from]) => call("clubface_trajectory", from).arrays),

    /**
     * `count` shots of a golfer: {text: shots, lost, quantities, ellipses, strokes, lies; arrays: the first `landings`}.
     * `setup` is described with `clubface_dispersion` in the header.
     */
    dispersion: (setup, count, landings = 0) =>
      lend([JSON.stringify(setup)], ([at]) => call("clubface_dispersion", at, count, landings, 1)),

    /** Mesh of a described ball: {text: mass, inertia, ...; arrays: nodes, elements, piece}. */
    ballMesh: (ball) => lend([JSON.stringify(ball)], ([at]) => call("clubface_fem_ball", at)),

    /** A described head that deforms: {text: mass, centre, inertia; arrays: nodes, face}. */
    headMesh: (head) => lend([JSON.stringify(head)], ([at]) => call("clubface_fem_head", at)),

    /**
     * A face struck everywhere: {text: quantities, face_area, centre, best, effective_area, forgiveness;
     * arrays: toe, high, values, inside}. `setup` is described with `clubface_face_map` in the header.
     */
    faceMap: (setup) => lend([JSON.stringify(setup)], ([at]) => call("clubface_face_map", at, 1)),

    /**
     * Smallest margin of `rows` heads in a space, and all margins of the first: {least, rounding, margins}. Below minus
     * `rounding` no body has such numbers. `space` is described with `clubface_buildable` in the header, the columns too.
     */
    buildable: (space, columns, rows) =>
      lend([JSON.stringify(space), flat(columns, rows), rows], ([at, from, to], copy) => {
        const { text } = call("clubface_buildable", at, from, rows, to);
        return { least: copy(2), ...text };
      }),

    /** Impact by finite elements of a described case: {text: summary, arrays}. */
    simulate: (description) => lend([JSON.stringify(description)], ([at]) => call("clubface_fem", at, 0, 0)),
  };
}
