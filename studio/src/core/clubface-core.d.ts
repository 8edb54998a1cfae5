/** The glue to the core in WebAssembly: crates/clubface-c/clubface.js. */

import type { CoreArray, Description, Dispersion, FaceMapSummary, Margin, Reject, Simulated, Space } from "./types";

export interface Batch {
  outputs: Float64Array[];
  rejects: Reject[];
}

export interface Derivatives {
  values: Float64Array;
  /** A row for each output. */
  jacobian: Float64Array[];
}

type Columns = ArrayLike<number | Float64Array>;

export interface LoadedCore {
  description: Description;
  launches(model: string, inputs: Columns, parameters: number[], rows: number, tolerance?: number): Batch;
  sensitivities(
    model: string,
    inputs: Columns,
    parameters: number[],
    rows: number,
    outputs: number[],
    variables: number[],
    tolerance?: number,
  ): Batch & { derivatives: Float64Array[][] };
  history(model: string, inputs: number[], parameters: number[], tolerance?: number): Record<string, CoreArray>;
  flights(inputs: Columns, rows: number): Batch;
  /** What golfers call shots, such as "pull hook"; "" of one that does not fly. */
  shotShapes(azimuth: Float64Array, curve: Float64Array, carry: Float64Array, hand?: number): string[];
  pressureAtAltitude(altitude: number): number;
  airDensity(temperature: number, pressure: number, humidity: number): number;
  flightSensitivity(inputs: number[]): Derivatives;
  dispersion(setup: object, count: number, landings?: number): { text: Dispersion; arrays: Record<string, CoreArray> };
  ballMesh(ball: object): { arrays: Record<string, CoreArray> };
  headMesh(head: object): { arrays: Record<string, CoreArray> };
  faceMap(setup: object): { text: FaceMapSummary; arrays: Record<string, CoreArray> };
  buildable(space: Space, columns: Columns, rows: number): { least: Float64Array; rounding: number; margins: Margin[] };
  simulate(description: object): { text: Simulated; arrays: Record<string, CoreArray> };
  trajectory(inputs: number[]): Record<string, CoreArray>;
}

export function load(
  source: BufferSource | WebAssembly.Module,
  progress?: (time: number, duration: number) => boolean,
): Promise<LoadedCore>;
