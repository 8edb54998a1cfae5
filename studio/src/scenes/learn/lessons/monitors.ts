/** Why two monitors disagree: they measure at other places, compute what they do not see, and normalise. */

import { html } from "lit-html";
import type { Lesson, LessonResult } from "../lesson";
import { monitorsTable } from "../pictures/monitors-table";
import { twoPathsPicture } from "../pictures/two-paths";

const DEGREE = Math.PI / 180;
/** How far the paths are to differ [rad], and how near to it. */
const APART = -2.5 * DEGREE;
const NEAR = 0.2 * DEGREE;
/** A closure from which that of the answer follows [rad/s]: the face moves sideways in proportion to it. */
const EXAMPLE = 1000 * DEGREE;

/** How fast the centre of the face moves to the right at first touch [m/s]: the ball is at rest, and slides the other way. */
const sideways = (result: LessonResult, name: string): number =>
  -(result.case(name).history?.sliding_z.values[0] ?? Number.NaN);

export const monitors: Lesson = {
  name: "monitors",
  title: "Two monitors can disagree and both be right",
  chosen: { club: "driver", ball: "modern", model: "response" },
  delivery: {
    speed: { value: 105, unit: "mph" },
    attack: { value: -1, unit: "deg" },
    path: { value: 0, unit: "deg" },
    loft: { value: 13, unit: "deg" },
  },
  sliders: [
    { setting: "monitors_closure", label: "Closure rate", range: ["0 deg/s", "4000 deg/s"], input: "closure" },
    { setting: "monitors_high", label: "Up the face", range: ["-15 mm", "15 mm"], input: "high" },
    {
      setting: "monitors_temperature",
      label: "Temperature of the air",
      range: ["0 degC", "40 degC"],
      condition: "temperature",
    },
  ],
  cases: (setup) => {
    const { flight, ...strike } = setup.strike();
    const today = { ...flight, temperature: setup.at("monitors_temperature") };
    return {
      today: { strike: { ...strike, flight: today } },
      normal: { strike: { ...strike, flight } },
      touch: { strike: setup.strike({ chosen: { model: "volumetric" }, values: { high: 0 } }), history: true },
      example: {
        strike: setup.strike({ chosen: { model: "volumetric" }, values: { high: 0, closure: EXAMPLE } }),
        history: true,
      },
    };
  },
  content: (result) => {
    const { delivery } = result.setup;
    const { equipment, description } = result.context;
    const { value: ratio, source } = equipment.lessons.loft_ratio;
    const { ball_mass, ball_radius, ball_inertia } = equipment.balls.published.columns;
    const { values } = result.case("today");
    const closure = result.at("monitors_closure");
    const forwards = delivery.speed * Math.cos(delivery.attack);
    const facePath = Math.atan2(sideways(result, "touch"), forwards);
    const answer = (EXAMPLE * forwards * Math.tan(APART)) / sideways(result, "example");
    const rolling = (ball_inertia * values.backspin) / (ball_mass * ball_radius);
    const computedLoft = values.launch + Math.asin(rolling / (ratio * values.ball_speed));
    const usual = description.flight_inputs.find(({ name }) => name === "temperature")?.default ?? Number.NaN;
    const [today, normal] = [values.carry, result.value("normal", "carry")];
    return {
      text: html`
        <p>
          A radar follows the middle of the head, a camera its face. A face that closes swings its centre to the left: at
          ${result.size("closure", closure)} the camera sees a path of ${result.number("path", facePath)}, the radar
          ${result.number("path", delivery.path)}. The radar's loft is that of the impact point, computed from the ball as if a
          rigid ball had rolled off the face: ${result.number("loft", computedLoft)}, while the middle of the face had
          ${result.number("loft", delivery.loft)}. One carry is for the conditions of the day, ${result.number("carry", today)} at
          ${result.number("temperature", result.at("monitors_temperature"))}; the other is normalised to
          ${result.number("temperature", usual)}: ${result.number("carry", normal)}. Some monitors measure spin, others estimate it.
          Before you compare two numbers, ask what each one measures.
        </p>`,
      pictures: [
        twoPathsPicture(result, { mass: delivery.path, face: facePath, closure }),
        monitorsTable(result, [
          { quantity: "path", radar: delivery.path, camera: facePath, why: "middle of the head, or of the face" },
          {
            quantity: "loft",
            radar: computedLoft,
            camera: delivery.loft,
            why: "at the impact point, computed from the ball; or at the middle of the face",
          },
          { quantity: "carry", radar: normal, camera: today, why: "normalised, or for the conditions of the day" },
        ]),
      ],
      question: html`The radar says that the path is ${result.number("path", delivery.path)}, the camera that it is
      ${result.number("path", APART)}, within ${result.number("loft", NEAR)}. How fast does the face close?`,
      now: html`Closing at ${result.size("closure", closure)}, the camera sees a path of ${result.number("path", facePath)}.`,
      isSolved: Math.abs(facePath - APART) <= NEAR,
      answer: html`At about ${result.size("closure", answer)}:
      the deeper the centre of gravity behind the face, the more the two paths differ.`,
      sources: [equipment.lessons.club_data.source, source],
    };
  },
};
