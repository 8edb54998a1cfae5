/** How spin is made: friction turns the ball, and turns round before the ball has left. */

import { html } from "lit-html";
import type { CoreArray } from "../../../core/types";
import { modelName } from "../../../equipment/names";
import { chartFrame } from "../../../parts/chart";
import { crossing, type Lesson, type LessonResult, peak, spread } from "../lesson";

/** Frictions drawn for comparison with that of the slider. */
const OTHERS = { slippery: 0.08, grippy: 0.35 } as const;
/** Share of the greatest spin at which the question counts as answered. */
const NEAR = 0.99;

/** The moment at which friction turns from making spin to taking it [s]; NaN where it does not. */
function reversal(history: Record<string, CoreArray>): number {
  const friction = frictionOf(history);
  const most = friction.indexOf(Math.max(...friction));
  return crossing(history.time.values.subarray(most), friction.subarray(most));
}

const frictions = new WeakMap<CoreArray, Float64Array>();

/** Friction along the face, above zero where it makes backspin [N]; of one history the same array. */
function frictionOf({ force_y }: Record<string, CoreArray>): Float64Array {
  const known = frictions.get(force_y) ?? Float64Array.from(force_y.values, (force) => -force);
  frictions.set(force_y, known);
  return known;
}

function courseOfSpin(result: LessonResult) {
  const { history } = result.case("now");
  if (!history) return html``;
  const spins = history.ball_spin.values.filter((_, i) => i % 3 === 2);
  const [turned, end] = [reversal(history), history.time.values.at(-1) ?? 0];
  if (!(turned < 0.98 * end))
    return html`At this friction the ball slides all the way, and the force never turns round. `;
  return html`Here it does so after ${result.number("reversal_time", turned)} of ${result.number("contact_time", end)}, and brakes the
  spin from ${result.number("spin_max", Math.max(...spins))} to ${result.number("backspin", result.value("now", "backspin"))}. `;
}

export const spin: Lesson = {
  name: "spin",
  title: "Friction makes the spin, then takes some of it back",
  chosen: { club: "driver", ball: "modern", model: "rings" },
  delivery: {
    speed: { value: 100, unit: "mph" },
    attack: { value: 0, unit: "deg" },
    loft: { value: 13, unit: "deg" },
  },
  sliders: [{ setting: "spin_friction", label: "Friction of ball and face", range: ["0.02", "0.6"] }],
  left: "The Shot scene has the friction of the ball; that of the slider stays here.",
  cases: (setup) => ({
    now: { strike: setup.strike({ parameters: { friction: setup.at("spin_friction") } }), history: true },
  }),
  steady: (setup) =>
    Object.fromEntries(
      Object.entries(OTHERS).map(([name, friction]) => [
        name,
        { strike: setup.strike({ parameters: { friction } }), history: true },
      ]),
    ),
  curves: (setup) => {
    const values = spread(0.02, 0.6, 59);
    return {
      rings: { strike: setup.strike(), by: "friction", values },
      response: { strike: setup.strike({ chosen: { model: "response" } }), by: "friction", values },
    };
  },
  content: (result) => {
    const friction = result.at("spin_friction");
    const now = result.value("now", "backspin");
    const [rings, response] = [result.curve("rings"), result.curve("response")];
    const [best, most] = rings ? peak(rings.x, rings.y.backspin) : [Number.NaN, Number.NaN];
    const least = rings?.y.backspin.at(-1) ?? Number.NaN;
    const courses = [
      { label: `friction ${result.text("friction", friction)} (slider)`, history: result.case("now").history },
      ...Object.entries(OTHERS).map(([name, value]) => ({
        label: `friction ${result.text("friction", value)}`,
        history: result.steadyCase(name)?.history,
      })),
    ];
    return {
      text: html`
        <p>
          The face drags the ball's surface down, and the ball begins to turn backwards. Its shell is stretched along the
          face, like a tyre in a bend. Before the ball leaves it springs back: friction turns round and pushes up the face.
          ${courseOfSpin(result)}The more grip, the more is stretched and taken back, so that more friction can mean less spin.
        </p>
        <p>
          The pictures are by the contact model ${result.model("rings")}. An impulse model has no history over time, but by ${result.model("response")} the spin falls in the same way.
        </p>`,
      pictures: [
        chartFrame(result.context, {
          name: "lesson-friction",
          title: "Friction along the face",
          x: { label: "time", quantity: "contact_time" },
          y: { label: "friction along the face", quantity: "tangential" },
          lines: courses.flatMap(({ label, history }) =>
            history ? [{ label, x: history.time.values, y: frictionOf(history) }] : [],
          ),
        }),
        chartFrame(result.context, {
          name: "lesson-spin",
          title: "Backspin over friction",
          x: { label: "friction", quantity: "friction" },
          y: { label: "backspin", quantity: "backspin" },
          lines: [
            ...(rings ? [{ label: modelName(result.context, "rings"), x: rings.x, y: rings.y.backspin }] : []),
            ...(response
              ? [{ label: modelName(result.context, "response"), x: response.x, y: response.y.backspin }]
              : []),
          ],
          mark: friction,
        }),
      ],
      question: html`At which friction does this drive spin most? Reduce the friction until you find it.`,
      now: html`Friction ${result.number("friction", friction)}: the ball leaves with ${result.number("backspin", now)}.`,
      isSolved: now >= NEAR * most,
      answer: html`At about ${result.number("friction", best)}, with ${result.number("backspin", most)} by
      ${result.model("rings")}. With less friction the ball slides throughout; with more, more is taken back:
      ${result.number("backspin", least)} are left at ${result.number("friction", rings?.x.at(-1) ?? Number.NaN)}.`,
    };
  },
};
