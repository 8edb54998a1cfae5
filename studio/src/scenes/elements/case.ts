/** How the case of finite elements follows from the state: pure functions. */

import { type Context, choiceSetting, delivered, strike } from "../../context";
import type { ElementsCase } from "../../core/elements";
import type { Strike, Values } from "../../core/types";
import type { MeshedBall, MeshName, RunName } from "../../equipment/elements";
import { handSign } from "../../equipment/equipment";
import type { Amount } from "../../quantities/units";
import { SECOND_SAME } from "./settings";

export const CASES = ["first", "second"] as const;
export type CaseName = (typeof CASES)[number];

/** What one case is of. */
export interface Setup {
  ball: string;
  against: string;
  friction: number;
  /** Of the head, or of the ball that is thrown at a plane [m/s]. */
  speed: number;
  /** Dynamic loft; for a plane the angle between the path of the ball and the normal [rad]. */
  loft: number;
}

/** The amount that was given for a setting; undefined where something stands for it. */
export const given = ({ state }: Context, name: string): Amount | undefined => {
  const value = state.settings[name];
  return typeof value === "object" ? value : undefined;
};

const givenSi = (context: Context, name: string): number | undefined => {
  const amount = given(context, name);
  return amount && context.formatter.units.toSi(amount);
};

export function setupOf(context: Context, name: CaseName): Setup {
  const { state, equipment } = context;
  const against = choiceSetting(context, "against");
  const first = {
    ball: state.ball,
    against,
    friction: givenSi(context, "friction") ?? equipment.elements.balls[state.ball]?.friction ?? 0,
    speed: delivered(context, "speed"),
    loft: loftOf(context, against),
  };
  if (name === "first") return first;
  const other = (setting: string, same: string): string => {
    const chosen = choiceSetting(context, setting);
    return chosen === SECOND_SAME ? same : chosen;
  };
  const [ball, face] = [other("second_ball", first.ball), other("second_against", first.against)];
  const isFriction = ball === first.ball || givenSi(context, "friction") !== undefined;
  return {
    ball,
    against: face,
    friction:
      givenSi(context, "second_friction") ??
      (isFriction ? first.friction : (equipment.elements.balls[ball]?.friction ?? 0)),
    speed: givenSi(context, "second_speed") ?? first.speed,
    loft: givenSi(context, "second_loft") ?? loftOf(context, face),
  };
}

/** The loft of a delivery that leaves it out is that of the head. */
function loftOf(context: Context, against: string): number {
  const head = context.equipment.elements.heads[against];
  return head && !context.state.delivery.loft ? (head.columns.static_loft ?? 0) : delivered(context, "loft");
}

export const ballOf = ({ equipment }: Context, { ball }: Setup): MeshedBall | undefined =>
  equipment.elements.balls[ball];

/** Why a setup can be no case, "" where it can; a ball without pieces has a message of its own. */
export function problemOf({ equipment, formatter, state }: Context, setup: Setup): string {
  const { limits } = equipment.elements;
  const isPlane = setup.against === "plane";
  const checked: [quantity: string, value: number, limit: keyof typeof limits, applies: boolean][] = [
    ["friction", setup.friction, "friction", true],
    ["speed", setup.speed, "thrown_speed", isPlane],
    ["loft", Math.abs(setup.loft), "thrown_angle", isPlane],
  ];
  const wrong = checked.find(([, value, limit, applies]) => {
    const [least, most] = limits[limit];
    return applies && !(value >= least && value <= most);
  });
  if (!wrong) return "";
  const [quantity, value, limit] = wrong;
  const [given, least, most] = [value, ...limits[limit]].map((each) => formatter.text(quantity, each, state.system));
  return `${formatter.quantity(quantity).label} ${given}; it must be from ${least} to ${most}`;
}

/** The case of a setup; null where the ball is not described by its pieces, or a value is out of its limits. */
export function caseOf(context: Context, setup: Setup, mesh: MeshName): ElementsCase | null {
  const { equipment, state } = context;
  const { runs, safeties, heads } = equipment.elements;
  const meshed = ballOf(context, setup)?.meshes[mesh];
  if (!meshed || problemOf(context, setup)) return null;
  const head = heads[setup.against];
  const inputs = (): number[] => strikeAgainst(context, setup, meshed.columns).inputs;
  const face: ElementsCase["described"]["face"] =
    setup.against === "plane"
      ? { plane: { speed: setup.speed, angle: Math.abs(setup.loft) } }
      : { head: { inputs: inputs(), mesh: head?.values ?? null } };
  const run = runs[choiceSetting(context, "follow") as RunName];
  return {
    described: { ball: meshed.values, face, friction: setup.friction, run },
    safeties,
    hand: setup.against === "plane" ? 1 : handSign(state),
  };
}

/** The same as a strike of a model, whose head is rigid. */
export function strikeAgainst(context: Context, setup: Setup, ball: Values = {}): Strike {
  const { equipment, state } = context;
  const head = equipment.elements.heads[setup.against];
  const columns = head?.columns ?? {};
  const finite = Object.entries(columns).map(([name, value]) => [name, value ?? Number.POSITIVE_INFINITY]);
  // The time of the face is for models that take the head as rigid, and depends on the model.
  const club = equipment.clubs[state.club].columns;
  const time =
    head || Object.keys(ball).length ? { characteristic_time: club.characteristic_time ?? 0, included_time: 0 } : {};
  const chosen = ballOf(context, setup) ? { ball: setup.ball } : {};
  return strike(context, chosen, {
    ...time,
    ...Object.fromEntries(finite),
    ...ball,
    speed: setup.speed,
    loft: setup.loft,
  });
}
