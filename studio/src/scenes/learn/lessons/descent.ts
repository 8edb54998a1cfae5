/** Why a descending blow spins more: spin comes from the angle between path and face. */

import { html } from "lit-html";
import { chartFrame } from "../../../parts/chart";
import { crossing, type Lesson, spread } from "../lesson";
import { anglesPicture } from "../pictures/angles";

const DEGREE = Math.PI / 180;
/** How far down the question asks for [rad], and how near the spin must stay [rad/s]. */
const DOWN = -8 * DEGREE;
const NEAR = (100 * Math.PI) / 30;
/** What the text hits further down [rad]. */
const FURTHER = -4 * DEGREE;

export const descent: Lesson = {
  name: "descent",
  title: "A descending blow spins more, if the loft stays",
  chosen: { club: "7-iron", ball: "modern", model: "response" },
  delivery: { speed: { value: 88, unit: "mph" } },
  sliders: [
    { setting: "descent_attack", label: "Attack angle", range: ["-12 deg", "4 deg"], input: "attack" },
    { setting: "descent_loft", label: "Dynamic loft", range: ["14 deg", "34 deg"], input: "loft" },
  ],
  cases: (setup) => ({
    now: { strike: setup.strike() },
    further: { strike: setup.strike({ values: { attack: setup.at("descent_attack") + FURTHER } }) },
    start: {
      strike: setup.strike({ values: { attack: setup.usual("descent_attack"), loft: setup.usual("descent_loft") } }),
    },
  }),
  curves: (setup) => ({
    attack: { strike: setup.strike(), by: "attack", values: spread(-12 * DEGREE, 4 * DEGREE, 33) },
    loft: { strike: setup.strike({ values: { attack: DOWN } }), by: "loft", values: spread(0.2, 0.6, 41) },
  }),
  content: (result) => {
    const { values } = result.case("now");
    const [attack, loft] = [result.at("descent_attack"), result.at("descent_loft")];
    const start = result.value("start", "backspin");
    const [over, lofts] = [result.curve("attack"), result.curve("loft")];
    const answer = lofts ? crossing(lofts.x, lofts.y.backspin, start) : Number.NaN;
    const more = result.value("further", "backspin") - values.backspin;
    return {
      text: html`
        <p>
          Backspin comes from the angle between the way the head moves and the way the face points: the spin loft, now
          ${result.number("loft", loft - attack)}. Hit ${result.difference("attack", FURTHER, ["further down", "up"])} with the same
          loft and the angle opens: the ball spins ${result.difference("backspin", more, ["less", "more"])}. But a golfer who hits
          down usually has the hands ahead, and that takes loft off the club. If both angles change by the same amount, it is the
          same strike aimed lower: same spin loft, same spin, lower launch. So the spin does not come from the ground, nor from
          pinching the ball against it.
        </p>`,
      pictures: [
        anglesPicture(result, { attack, loft, launch: values.launch }),
        chartFrame(result.context, {
          name: "lesson-descent",
          title: "Backspin over attack angle, with this loft",
          x: { label: "attack angle", quantity: "attack" },
          y: { label: "backspin", quantity: "backspin" },
          lines: over ? [{ label: "backspin", x: over.x, y: over.y.backspin }] : [],
          mark: attack,
        }),
      ],
      question: html`Hit ${result.number("attack", DOWN)} or more and keep the spin you started with,
      ${result.number("backspin", start)}, to within ${result.number("backspin", NEAR)}. How much loft must you take off?`,
      now: html`Attack ${result.number("attack", attack)}, loft ${result.number("loft", loft)}: ${result.number("backspin", values.backspin)},
      launched ${result.number("launch", values.launch)}.`,
      isSolved: attack <= DOWN * (1 - 1e-9) && Math.abs(values.backspin - start) <= NEAR,
      answer: html`As much as the blow went down: ${result.number("loft", answer)} of loft at ${result.number("attack", DOWN)}, which
      is ${result.number("loft", answer - DOWN)} of spin loft as before.`,
    };
  },
};
