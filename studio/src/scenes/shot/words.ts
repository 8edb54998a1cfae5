/** The words and the steps of the delivery that golfers use. */

export interface DeliveryWords {
  label: string;
  /** What a step more of it is called in a what-if. */
  more: string;
  /** The step of a what-if in the unit that people read. */
  step: number;
}

export const DELIVERY: Record<string, DeliveryWords> = {
  speed: { label: "Club speed", more: "more club speed", step: 1 },
  attack: { label: "Attack angle", more: "more attack angle", step: 1 },
  path: { label: "Club path", more: "more path to the right", step: 1 },
  loft: { label: "Dynamic loft", more: "more loft", step: 1 },
  face: { label: "Face angle", more: "more face to the right", step: 1 },
  toe: { label: "Towards the toe", more: "nearer the toe", step: 5 },
  high: { label: "Up the face", more: "higher on the face", step: 5 },
  lie: { label: "Lie tilt", more: "more toe up", step: 1 },
  closure: { label: "Closure rate", more: "faster closing", step: 500 },
  pitch_rate: { label: "Loft rate", more: "faster adding loft", step: 100 },
  lie_rate: { label: "Lie rate", more: "faster toe up", step: 100 },
  ball_backspin: { label: "Backspin before", more: "more backspin before", step: 100 },
  ball_sidespin: { label: "Sidespin before", more: "more sidespin before", step: 100 },
  ball_riflespin: { label: "Rifle spin before", more: "more rifle spin before", step: 100 },
};

export const MAIN = ["speed", "attack", "path", "loft", "face"];
export const IMPACT_POINT = ["toe", "high"];
export const FURTHER = ["lie", "closure", "pitch_rate", "lie_rate", "ball_backspin", "ball_sidespin", "ball_riflespin"];
