/** Values of equations that no column of the core holds, from head and ball at impact and from derivatives. */

import type { Slopes, Values } from "../../../core/types";
import { cross, direction, dot, minus, plus, size, times, type Vector } from "../../../parts/vectors";
import { poseAtImpact } from "../head-pose";

const vector = (values: Values, name: string): Vector => [
  values[`${name}_x`],
  values[`${name}_y`],
  values[`${name}_z`],
];

/** `inputs` and `outputs` of the shot in SI by name; without derivatives the shares are unknown. */
export function termsOf(inputs: Values, outputs: Values, slopes: Slopes | null): Values {
  const { contact, normal, cg } = poseAtImpact(inputs);
  const arm = minus(contact, cg);
  const { hand, lie_rate, closure, pitch_rate } = inputs;
  const turning: Vector = [-lie_rate * hand, closure * hand, pitch_rate];
  const struck = plus(times(direction(inputs.attack, inputs.path), inputs.speed), cross(turning, arm));
  const after = plus(vector(outputs, "club_velocity"), cross(vector(outputs, "club_spin"), arm));
  const ball = vector(outputs, "velocity");
  const [approach, left, head] = [dot(struck, normal), dot(ball, normal), dot(after, normal)];
  const along_face = size(minus(ball, times(normal, left)));
  const share = (of: string, by: string): number => slopes?.[of]?.[by] ?? Number.NaN;
  const rest = (of: string, names: string[]): number =>
    outputs[of] - names.reduce((sum, name) => sum + share(of, name) * inputs[name], 0);
  return {
    approach,
    along_face,
    restitution: (left - head) / approach,
    head_mass: (inputs.ball_mass * left) / (approach - head),
    spin_lever: (outputs.total_spin * inputs.ball_inertia) / (inputs.ball_mass * inputs.ball_radius * along_face),
    attack_share: share("launch", "attack"),
    loft_share: share("launch", "loft"),
    launch_rest: rest("launch", ["attack", "loft"]),
    path_share: share("azimuth", "path"),
    face_share: share("azimuth", "face"),
    azimuth_rest: rest("azimuth", ["path", "face"]),
    spin_parameter: (inputs.ball_radius * outputs.total_spin) / outputs.ball_speed,
  };
}
