/** Gear effect: a strike off the centre turns head and ball like two gears, and bulge answers it. */

import { html } from "lit-html";
import { crossing, type Lesson, spread } from "../lesson";
import { flightsPicture } from "../pictures/flights";
import { headPicture } from "../pictures/head";

/** How near the target line is near [m], and which strikes count [m]. */
const NEAR = 2;
const LEAST_TOE = 0.01;

export const gear: Lesson = {
  name: "gear",
  title: "A toe strike hooks, so a driver's face bulges",
  chosen: { club: "driver", ball: "modern", model: "response" },
  delivery: {
    speed: { value: 100, unit: "mph" },
    attack: { value: 0, unit: "deg" },
    loft: { value: 13, unit: "deg" },
  },
  sliders: [
    { setting: "gear_bulge", label: "Radius of the bulge", range: ["200 mm", "1200 mm"] },
    { setting: "gear_toe", label: "Towards the toe", range: ["-25 mm", "25 mm"], input: "toe" },
  ],
  left: "The Shot scene has the bulge of the club; that of the slider stays here.",
  cases: (setup) => {
    const bulge = setup.at("gear_bulge");
    const struck = (toe: number) => ({ strike: setup.strike({ values: { bulge, toe } }), path: true });
    const iron = { club: "7-iron" };
    return {
      now: struck(setup.at("gear_toe")),
      centre: struck(0),
      opposite: struck(-setup.at("gear_toe")),
      flat: { strike: setup.strike({ values: { bulge: Number.POSITIVE_INFINITY } }) },
      iron: { strike: setup.strike({ chosen: iron, values: { loft: setup.usual("descent_loft") } }) },
    };
  },
  curves: (setup) => ({ bulge: { strike: setup.strike(), by: "bulge", values: spread(0.2, 1.2, 51) } }),
  content: (result) => {
    const { values } = result.case("now");
    const { clubs } = result.context.equipment;
    const [toe, bulge] = [result.at("gear_toe"), result.at("gear_bulge")];
    const over = result.curve("bulge");
    const right = over ? crossing(over.x, over.y.side) : Number.NaN;
    const depth = (club: string) => result.number("cg_x", clubs[club].columns.cg_x ?? Number.NaN);
    return {
      text: html`
        <p>
          Struck ${result.towards(toe)}, the head turns about its centre of gravity, ${depth("driver")} behind the face.
          The face slides sideways under the ball and turns it the other way, like two gears: the spin axis is
          ${result.number("spin_axis", values.spin_axis)}. From a flat face the ball would land
          ${result.number("side", result.value("flat", "side"))}. A bulged face points away from the target where it is struck, so
          that the ball starts ${result.number("azimuth", values.azimuth)} and curves back. A 7-iron's centre of gravity lies
          ${depth("7-iron")} behind the face: struck as far out, its spin axis is
          ${result.number("spin_axis", result.value("iron", "spin_axis"))}, and its face is flat. Few have measured how
          strong the gear effect is.
        </p>`,
      pictures: [
        headPicture(result, {
          seen: "above",
          radius: bulge,
          struck: toe,
          face: 0,
          start: values.azimuth,
          headTurn: values.club_spin_y,
          ballTurn: -values.sidespin,
          words: {
            start: `the ball starts ${result.text("azimuth", values.azimuth)}`,
            ball: `the ball turns: sidespin ${result.text("sidespin", values.sidespin)}`,
            head: `the head turns: ${result.text("closure", values.club_spin_y)}`,
          },
        }),
        flightsPicture(result, "gear", [
          { kind: "faded", label: "centre", case: "centre" },
          { kind: "other", label: "as far on the other side", case: "opposite" },
          { kind: "yours", label: "yours", case: "now" },
        ]),
      ],
      question: html`Struck ${result.towards(result.setup.usual("gear_toe"))} on this nearly flat face, the ball hooks. Round
      the face: at which bulge does it land within ${result.number("carry", NEAR)} of the target line?`,
      now: html`With a bulge of ${result.number("bulge", bulge)} the ball struck ${result.towards(toe)} lands
      ${result.number("side", values.side)}.`,
      isSolved: toe >= LEAST_TOE && Math.abs(values.side) <= NEAR,
      answer: html`At about ${result.number("bulge", right)}, struck ${result.towards(toe)}. The driver here has
      ${result.number("bulge", clubs.driver.columns.bulge ?? Number.NaN)}.`,
    };
  },
};
