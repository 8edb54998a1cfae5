/** The words and the steps of the delivery that golfers use, and how far its sliders reach. */

export interface DeliveryWords {
  label: string;
  /** What a step more of it is called in a what-if. */
  more: string;
  /** The step of a what-if in the unit that people read. */
  step: number;
  /** Ends of the slider, as a person writes them; the impact point goes to the edge of the face. */
  range: readonly [string, string];
}

const ANGLE = ["-15 deg", "15 deg"] as const;
const SPIN = ["-3000 rpm", "3000 rpm"] as const;

export const DELIVERY: Record<string, DeliveryWords> = {
  speed: { label: "Club speed", more: "more club speed", step: 1, range: ["20 mph", "140 mph"] },
  attack: { label: "Attack angle", more: "more attack angle", step: 1, range: ANGLE },
  path: { label: "Club path", more: "more path to the right", step: 1, range: ANGLE },
  loft: { label: "Dynamic loft", more: "more loft", step: 1, range: ["-5 deg", "75 deg"] },
  face: { label: "Face angle", more: "more face to the right", step: 1, range: ANGLE },
  toe: { label: "Towards the toe", more: "nearer the toe", step: 5, range: ["-40 mm", "40 mm"] },
  high: { label: "Up the face", more: "higher on the face", step: 5, range: ["-25 mm", "25 mm"] },
  lie: { label: "Lie tilt", more: "more toe up", step: 1, range: ANGLE },
  closure: { label: "Closure rate", more: "faster closing", step: 500, range: ["-1000 deg/s", "5000 deg/s"] },
  pitch_rate: { label: "Loft rate", more: "faster adding loft", step: 100, range: ["-2000 deg/s", "2000 deg/s"] },
  lie_rate: { label: "Lie rate", more: "faster toe up", step: 100, range: ["-2000 deg/s", "2000 deg/s"] },
  ball_backspin: { label: "Backspin before", more: "more backspin before", step: 100, range: SPIN },
  ball_sidespin: { label: "Sidespin before", more: "more sidespin before", step: 100, range: SPIN },
  ball_riflespin: { label: "Rifle spin before", more: "more rifle spin before", step: 100, range: SPIN },
};

export const MAIN = ["speed", "attack", "path", "loft", "face"];
export const IMPACT_POINT = ["toe", "high"];
export const FURTHER = ["lie", "closure", "pitch_rate", "lie_rate", "ball_backspin", "ball_sidespin", "ball_riflespin"];
