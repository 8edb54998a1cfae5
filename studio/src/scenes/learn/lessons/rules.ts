/** What the rules limit of a driver: how far its face gives, and how steady the head is. */

import { html } from "lit-html";
import { chartFrame } from "../../../parts/chart";
import { type Lesson, type LessonResult, type Setup, spread } from "../lesson";
import { isWithin, type Limited, limitsPicture } from "../pictures/limits";

/** Distance of the strikes from the centre [m], and the carry to be gained [m]. */
const TOE = 0.02;
const GAIN = 16.5;

/** A head that is struck squarely through its CG, so that nothing turns. */
const SQUARE = { loft: 0, static_loft: 0, toe: 0, cg_y: 0, cg_z: 0 };

const limited = (time: number, inertia: number): Limited[] => [
  { rule: "characteristic_time", quantity: "characteristic_time", value: time },
  { rule: "moment_of_inertia", quantity: "iyy", value: inertia },
];

/** The greatest values that conform. */
function greatest({ context }: Setup): { characteristic_time: number; iyy: number } {
  const most = (rule: string): number => {
    const { most: limit, tolerance } = context.equipment.lessons.rules[rule];
    return limit + tolerance;
  };
  return { characteristic_time: most("characteristic_time"), iyy: most("moment_of_inertia") };
}

/** Speed of parting over speed of meeting, along the normal. */
const restitution = (result: LessonResult, name: string): number =>
  (result.value(name, "velocity_x") - result.value(name, "club_velocity_x")) / result.setup.delivery.speed;

export const rules: Lesson = {
  name: "rules",
  title: "The rules limit how far a face gives and how steady a head is",
  chosen: { club: "driver", ball: "modern", model: "response" },
  delivery: {
    speed: { value: 100, unit: "mph" },
    attack: { value: 0, unit: "deg" },
    loft: { value: 13, unit: "deg" },
    toe: { value: 20, unit: "mm" },
  },
  sliders: [
    { setting: "rules_time", label: "Characteristic time of the face", range: ["50 us", "320 us"] },
    { setting: "rules_inertia", label: "Moment of inertia, vertical axis", range: ["2500 g cm2", "6700 g cm2"] },
  ],
  left: "The Shot scene has face and inertia of the club; those of the sliders stay here.",
  cases: (setup) => {
    const now = { characteristic_time: setup.at("rules_time"), iyy: setup.at("rules_inertia") };
    const start = { characteristic_time: setup.usual("rules_time"), iyy: setup.usual("rules_inertia") };
    const { characteristic_time } = greatest(setup);
    return {
      now: { strike: setup.strike({ values: now }) },
      start: { strike: setup.strike({ values: start }) },
      centre: { strike: setup.strike({ values: { ...now, toe: 0 } }) },
      rigid: { strike: setup.strike({ values: { ...SQUARE, characteristic_time: 0 } }) },
      limit: { strike: setup.strike({ values: { ...SQUARE, characteristic_time } }) },
    };
  },
  curves: (setup) => {
    const now = { characteristic_time: setup.at("rules_time"), iyy: setup.at("rules_inertia") };
    const values = spread(-0.025, 0.025, 51);
    return {
      now: { strike: setup.strike({ values: now }), by: "toe", values },
      limit: { strike: setup.strike({ values: greatest(setup) }), by: "toe", values },
    };
  },
  content: (result) => {
    const { rules: all } = result.context.equipment.lessons;
    const [time, inertia] = [result.at("rules_time"), result.at("rules_inertia")];
    const heads = limited(time, inertia);
    const gained = result.value("now", "carry") - result.value("start", "carry");
    const fits = heads.every((each) => isWithin(result, each));
    const [now, limit] = [result.curve("now"), result.curve("limit")];
    const most = greatest(result.setup);
    return {
      text: html`
        <p>
          A face that gives sends the ball off faster. The rules measure how long a small steel ball stays on it: at most
          ${result.number("characteristic_time", all.characteristic_time.most)}, with
          ${result.number("characteristic_time", all.characteristic_time.tolerance)} of tolerance. From a rigid face to there the
          restitution of this ball and head grows from ${result.number("restitution", restitution(result, "rigid"))} to
          ${result.number("restitution", restitution(result, "limit"))}. A head with more inertia turns less when it is struck off
          the centre and keeps more speed: now ${result.number("ball_speed", result.value("centre", "ball_speed"))} at the centre, and
          ${result.number("ball_speed", result.value("now", "ball_speed"))} struck ${result.towards(TOE)}. The
          rules limit size and grooves too; no model here has grooves.
        </p>`,
      pictures: [
        limitsPicture(result, heads),
        chartFrame(result.context, {
          name: "lesson-rules",
          title: "Ball speed from heel to toe",
          x: { label: "towards the toe", quantity: "toe" },
          y: { label: "ball speed", quantity: "ball_speed" },
          lines: [
            ...(now ? [{ label: "this head", x: now.x, y: now.y.ball_speed }] : []),
            ...(limit ? [{ label: "at both limits", x: limit.x, y: limit.y.ball_speed }] : []),
          ],
          mark: TOE,
        }),
      ],
      question: html`Struck ${result.towards(TOE)}, gain ${result.difference("carry", GAIN, ["shorter", "of carry"])} over the head you started with, without breaking a rule.`,
      now: html`It carries ${result.number("carry", result.value("now", "carry"))}, a difference of
      ${result.difference("carry", gained, ["less", "more"])}, and the head ${fits ? "conforms" : "does not conform"}.`,
      isSolved: fits && gained >= GAIN,
      answer: html`It takes both: at ${result.number("characteristic_time", most.characteristic_time)} and
      ${result.number("iyy", most.iyy)}, the highest values that conform, the gain is greatest; neither alone is enough.`,
      sources: [all.characteristic_time.source, all.moment_of_inertia.source],
    };
  },
};
