/** Why two monitors disagree: they measure at other places, compute what they do not see, and normalise. */

import { html } from "lit-html";
import type { Found, Lesson } from "../lesson";
import { monitorsTable } from "../pictures/monitors-table";
import { twoPathsPicture } from "../pictures/two-paths";

const DEGREE = Math.PI / 180;
/** How far the paths are to differ [rad], and how near to it. */
const APART = -2.5 * DEGREE;
const NEAR = 0.2 * DEGREE;
/** A closure from which that of the answer follows [rad/s]: the face moves sideways in proportion to it. */
const EXAMPLE = 1000 * DEGREE;

/** How fast the centre of the face moves to the right at first touch [m/s]: the ball is at rest, and slides the other way. */
const sideways = (found: Found, name: string): number => -(found.case(name).history?.sliding_z.values[0] ?? Number.NaN);

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
  tell: (found) => {
    const { delivery } = found.setup;
    const { equipment, description } = found.context;
    const { value: ratio, source } = equipment.lessons.loft_ratio;
    const { ball_mass, ball_radius, ball_inertia } = equipment.balls.published.columns;
    const { values } = found.case("today");
    const closure = found.at("monitors_closure");
    const forwards = delivery.speed * Math.cos(delivery.attack);
    const facePath = Math.atan2(sideways(found, "touch"), forwards);
    const answer = (EXAMPLE * forwards * Math.tan(APART)) / sideways(found, "example");
    const rolling = (ball_inertia * values.backspin) / (ball_mass * ball_radius);
    const computedLoft = values.launch + Math.asin(rolling / (ratio * values.ball_speed));
    const usual = description.flight_inputs.find(({ name }) => name === "temperature")?.default ?? Number.NaN;
    const [today, normal] = [values.carry, found.value("normal", "carry")];
    return {
      text: html`
        <p>
          A radar follows the middle of the head, a camera its face. A face that closes swings its centre to the left: at
          ${found.size("closure", closure)} the camera sees a path of ${found.say("path", facePath)}, the radar
          ${found.say("path", delivery.path)}. The radar's loft is that of the point struck, computed from the ball as if a
          rigid one had rolled off: ${found.say("loft", computedLoft)}, where the middle of the face had
          ${found.say("loft", delivery.loft)}. One carry is that of the day, ${found.say("carry", today)} at
          ${found.say("temperature", found.at("monitors_temperature"))}, the other is normalised: ${found.say("carry", normal)}
          at ${found.say("temperature", usual)}. Spin is measured by some and estimated by others. Ask what a number is of
          before you compare it.
        </p>`,
      pictures: [
        twoPathsPicture(found, { mass: delivery.path, face: facePath, closure }),
        monitorsTable(found, [
          { quantity: "path", radar: delivery.path, camera: facePath, why: "middle of the head, or of the face" },
          {
            quantity: "loft",
            radar: computedLoft,
            camera: delivery.loft,
            why: "of the point struck, from the ball; or of the middle of the face",
          },
          { quantity: "carry", radar: normal, camera: today, why: "normalised, or of the day" },
        ]),
      ],
      question: html`The radar says that the path is ${found.say("path", delivery.path)}, the camera that it is
      ${found.say("path", APART)}, within ${found.say("loft", NEAR)}. How fast does the face close?`,
      now: html`Closing at ${found.size("closure", closure)}, the camera sees a path of ${found.say("path", facePath)}.`,
      isSolved: Math.abs(facePath - APART) <= NEAR,
      answer: html`At about ${found.size("closure", answer)}:
      the deeper the centre of gravity behind the face, the more the two paths differ.`,
      sources: [equipment.lessons.club_data.source, source],
    };
  },
};
