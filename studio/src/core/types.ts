/** What the core says of itself, and what passes between the pages and the worker that computes. */

/** The unit in which people read a quantity, and how many digits. */
export type Reading = [unit: string, digits: number];

export interface Quantity {
  name: string;
  symbol: string;
  unit: string;
  metric: Reading;
  golf: Reading;
  label: string;
  meaning: string;
  sign: string;
  /** Words for negative and positive values. */
  sides: [string, string] | null;
}

export interface Unit {
  symbol: string;
  spellings: string[];
  dimension: string;
  numerator: number;
  denominator: number;
  offset: number;
}

export interface Variable {
  name: string;
  unit: string;
  meaning: string;
  group?: string;
  differentiable?: boolean;
  default?: number | null;
  /** From where to where people give it [SI], as the ends of a slider. */
  usual?: readonly [number, number] | null;
}

export interface ModelEntry {
  name: string;
  title: string;
  kind: "impulse" | "contact";
  summary: string;
  reference: string;
  parameters: Variable[];
}

/** Where the names of shots begin: of the start [rad], and of the curve over the carry. */
export interface ShapeLimits {
  straight_start: number;
  straight_curve: number;
  big_curve: number;
}

export interface Description {
  quantities: Quantity[];
  units: Unit[];
  models: ModelEntry[];
  inputs: Variable[];
  outputs: Variable[];
  flight_inputs: Variable[];
  flight_outputs: Variable[];
  shot_shapes: ShapeLimits;
}

export interface CoreArray {
  values: Float64Array;
  shape: number[];
}

export interface Reject {
  row: number;
  input: string;
  message: string;
}

/** Where the shots of a golfer go, as `clubface_dispersion` in the C header describes it. */
export interface Dispersion {
  shots: number;
  lost: number;
  quantities: Record<string, { mean: number; spread: number; percentiles: number[] }>;
  ellipses: { share: number; centre: [number, number]; half_axes: [number, number]; angle: number }[];
  strokes: number | null;
  lies: Record<string, number | null>;
}

/** A point of the face towards the toe and up it [m], and a value there. */
export interface FacePoint {
  toe: number;
  high: number;
  value: number;
}

/** What is known of a face struck everywhere, as `clubface_face_map` in the C header describes it. */
export interface FaceMapSummary {
  quantities: string[];
  face_area: number;
  centre: Values;
  best: Record<string, FacePoint | null>;
  effective_area: number | null;
  forgiveness: { missed: number; mean: Values; deviation: Values; loss: Values } | null;
}

/** One condition on a head that can be built, as `clubface_buildable` in the C header describes it. */
export interface Margin {
  name: string;
  value: number;
  reason: string;
}

/** The space that a head may fill, as `clubface_buildable` takes it. */
export interface Space {
  shape: string;
  centre: number[];
  size: number[];
  head: number[];
  free: number;
}

/** Summary of a simulated impact, as `clubface_fem` in the C header describes it. */
export interface Simulated {
  launch: number[] | null;
  ball_velocity: number[];
  ball_spin: number[];
  /** Directions at first touch, a row each: normal, up the face, towards the toe. */
  axes: number[][];
  /** Rotation from the axes of the nodes to world axes, by rows. */
  attitude: number[][];
  over_edge: boolean;
  stopped: string | null;
  nodes: [ball: number, all: number];
  steps: number;
  step: number;
  wall: number;
  energy_error: number;
  peak_force: number;
  peak_force_time: number;
  contact_time: number;
  tangential_max: number;
  tangential_min: number;
  reversal_time: number;
  spin_max: number;
  contraction: number;
  contraction_time: number;
  f_prime: number;
  f: number;
}

/** Numbers in SI by the names of the description. */
export type Values = Record<string, number>;

/** One strike as the core takes it. */
export interface Strike {
  model: string;
  inputs: number[];
  parameters: number[];
  /** Inputs of the flight that are not as usual, such as wind, in SI by their names; or `altitude` for the pressure. */
  flight: Values;
}

export interface Failure {
  input: string;
  message: string;
}

/** One model's launch and flight. */
export interface Computed {
  model: string;
  values: Values;
  /** What golfers call the shot, such as "pull hook"; "" of one that does not fly. */
  shape: string;
  failure: Failure | null;
}

export interface Shot extends Computed {
  /** Positions of the ball in flight [m], x y z of each moment after one another. */
  path: Float64Array;
  /** The moments [s]. */
  times: Float64Array;
}

/** Derivatives of outputs of launch and flight by inputs of the delivery, by their names. */
export type Slopes = Record<string, Values>;

export interface History {
  model: string;
  arrays: Record<string, CoreArray>;
}

export interface Comparison {
  shots: Computed[];
  histories: History[];
}
