/** What the worker computes: a strike and the flight that follows it. */

import type { LoadedCore } from "clubface-core";
import type { Comparison, Computed, Failure, History, Shot, Slopes, Strike, Values, Variable } from "./types";

/** Tolerance of a step in histories that are drawn: close enough for a smooth line. */
export const DRAWN = 1e-8;

export function computeShot(core: LoadedCore, strike: Strike): Shot {
  const computed = computeModel(core, strike);
  if (computed.failure) return { ...computed, path: new Float64Array(), times: new Float64Array() };
  const { position, time } = core.trajectory(flightInputs(core, strike, computed.values));
  return { ...computed, path: position.values, times: time.values };
}

export function compareModels(core: LoadedCore, strikes: Strike[]): Comparison {
  const shots = strikes.map((strike) => computeModel(core, strike));
  const histories: History[] = [];
  strikes.forEach((strike, i) => {
    const { kind } = core.description.models.find(({ name }) => name === strike.model) ?? {};
    if (kind !== "contact" || shots[i].failure) return;
    histories.push({
      model: strike.model,
      arrays: core.history(strike.model, strike.inputs, strike.parameters, DRAWN),
    });
  });
  return { shots, histories };
}

/** Launch and flight of one strike, and why there is none. */
export function computeModel(core: LoadedCore, strike: Strike): Computed {
  const { model } = strike;
  const launch = core.launches(model, strike.inputs, strike.parameters, 1);
  if (launch.rejects.length) return { model, values: {}, shape: "", failure: failure(launch.rejects[0]) };
  const launched = byName(core.description.outputs, launch.outputs);
  const flight = core.flights(flightInputs(core, strike, launched), 1);
  if (flight.rejects.length) return { model, values: launched, shape: "", failure: failure(flight.rejects[0]) };
  const values = { ...launched, ...byName(core.description.flight_outputs, flight.outputs) };
  return { model, values, shape: shapeOf(core, strike, values), failure: null };
}

/** What golfers call a shot, by its start and its curve. */
function shapeOf(core: LoadedCore, strike: Strike, values: Values): string {
  const [azimuth, curve, carry] = [values.azimuth, values.curve, values.carry].map((value) => Float64Array.of(value));
  const hand = core.description.inputs.findIndex(({ name }) => name === "hand");
  return core.shotShapes(azimuth, curve, carry, strike.inputs[hand])[0];
}

const failure = ({ input, message }: Failure): Failure => ({ input, message });

/** Values of one shot by the names of its outputs. */
export const outputValues = (variables: Variable[], values: ArrayLike<number>): Values =>
  Object.fromEntries(variables.map(({ name }, i) => [name, values[i]]));

const byName = (variables: Variable[], columns: Float64Array[]): Values =>
  Object.fromEntries(variables.map(({ name }, i) => [name, columns[i][0]]));

/** Air, wind and ground as the core takes them: an altitude becomes the pressure there. */
export function conditionsOf(core: LoadedCore, { altitude, ...given }: Values): Values {
  return altitude === undefined ? given : { pressure: core.pressureAtAltitude(altitude), ...given };
}

/** The inputs of the flight: the launch, the ball of the strike, and what its air and ground are. */
export function flightInputs(core: LoadedCore, strike: Pick<Strike, "inputs" | "flight">, launch: Values): number[] {
  const struck = core.description.inputs.map(({ name }) => name);
  const conditions = conditionsOf(core, strike.flight);
  return core.description.flight_inputs.map((input) => {
    if (input.name in conditions) return conditions[input.name];
    if (input.name in launch) return launch[input.name];
    const place = struck.indexOf(input.name);
    return place >= 0 ? strike.inputs[place] : (input.default ?? Number.NaN);
  });
}

/** A launch that was computed before, by the names of its outputs, with the ball of a strike and its conditions. */
export interface Launched extends Pick<Strike, "inputs" | "flight"> {
  launch: Values;
}

/** The flight of a launch; empty where it cannot be computed. */
export function computeFlight(core: LoadedCore, { launch, ...strike }: Launched): Values {
  const flight = core.flights(flightInputs(core, strike, launch), 1);
  return flight.rejects.length ? {} : byName(core.description.flight_outputs, flight.outputs);
}

/** Derivatives of launch and flight by the inputs of the delivery; none where there is no shot. */
export const computeSlopes = (core: LoadedCore, strike: Strike): Slopes => slopesAndValues(core, strike)?.slopes ?? {};

/** The inputs of a delivery. */
const deliveredInputs = ({ description }: LoadedCore): number[] =>
  description.inputs.flatMap(({ group }, place) => (group === "delivery" ? [place] : []));

/** The same by any inputs, and launch and flight; those of the flight are those by the launch times those of the launch. */
export function slopesAndValues(
  core: LoadedCore,
  strike: Strike,
  by: number[] = deliveredInputs(core),
): { slopes: Slopes; values: Values } | null {
  const { inputs, outputs, flight_inputs, flight_outputs } = core.description;
  const all = outputs.map((_, place) => place);
  const launch = core.sensitivities(strike.model, strike.inputs, strike.parameters, 1, all, by);
  if (launch.rejects.length) return null;
  const values = byName(outputs, launch.outputs);
  const flown = core.flightSensitivity(flightInputs(core, strike, values));
  const passedOn = flight_inputs.flatMap(({ name }, column) => {
    const place = outputs.findIndex((output) => output.name === name);
    return place < 0 ? [] : [{ column, place }];
  });
  const chained = (row: Float64Array, j: number): number =>
    passedOn.reduce((sum, { column, place }) => sum + row[column] * launch.derivatives[place][j][0], 0);
  const slopesOf = (slope: (j: number) => number): Values =>
    Object.fromEntries(by.map((place, j) => [inputs[place].name, slope(j)]));
  const slopes: Slopes = Object.fromEntries([
    ...outputs.map(({ name }, i) => [name, slopesOf((j) => launch.derivatives[i][j][0])]),
    ...flight_outputs.map(({ name }, i) => [name, slopesOf((j) => chained(flown.jacobian[i], j))]),
  ]);
  flight_outputs.forEach(({ name }, i) => {
    values[name] = flown.values[i];
  });
  return { slopes, values };
}
