/** Low and high strikes of a driver: roll and gear effect trade launch for spin. */

import { html } from "lit-html";
import { chartFrame } from "../../../parts/chart";
import { type Lesson, peak, spread } from "../lesson";
import { headPicture } from "../pictures/head";

/** Share of the longest carry at which the question counts as answered. */
const NEAR = 0.999;
/** A groove of an iron [m]. */
const GROOVE = 0.0036;

export const height: Lesson = {
  name: "height",
  title: "A drive struck high launches higher and spins less",
  chosen: { club: "driver", ball: "modern", model: "response" },
  delivery: { speed: { value: 100, unit: "mph" }, attack: { value: 0, unit: "deg" } },
  sliders: [
    { setting: "height_high", label: "Up the face", range: ["-18 mm", "18 mm"], input: "high" },
    { setting: "height_loft", label: "Dynamic loft", range: ["8 deg", "18 deg"], input: "loft" },
  ],
  cases: (setup) => {
    const iron = (model: string, high: number) => ({
      strike: setup.strike({
        chosen: { club: "7-iron", model },
        values: { loft: setup.usual("descent_loft"), attack: setup.usual("descent_attack"), high },
      }),
    });
    return {
      now: { strike: setup.strike() },
      centre: { strike: setup.strike({ values: { high: 0 } }) },
      ironByResponse: iron("response", 0),
      lowIronByResponse: iron("response", -GROOVE),
      ironByStandard: iron("standard", 0),
      lowIronByStandard: iron("standard", -GROOVE),
    };
  },
  curves: (setup) => ({ high: { strike: setup.strike(), by: "high", values: spread(-0.018, 0.018, 37) } }),
  content: (result) => {
    const { values } = result.case("now");
    const high = result.at("height_high");
    const { columns } = result.context.equipment.clubs.driver;
    const over = result.curve("high");
    const [best, longest] = over ? peak(over.x, over.y.carry) : [Number.NaN, Number.NaN];
    const lower = (model: string) =>
      result.difference(
        "backspin",
        result.value(`lowIronBy${model}`, "backspin") - result.value(`ironBy${model}`, "backspin"),
        ["less", "more"],
      );
    return {
      text: html`
        <p>
          The face of a driver is curved upwards too: higher on it there is more loft. And struck above its centre of gravity
          the head turns back and, like a gear, turns the ball forwards. Struck ${result.number("high", high)} this drive launches
          ${result.number("launch", values.launch)} with ${result.number("backspin", values.backspin)}; from the centre it is
          ${result.number("launch", result.value("centre", "launch"))} with
          ${result.number("backspin", result.value("centre", "backspin"))}. Ball speed falls on the way up, so that there is a best
          height.
        </p>
        <p>
          On irons the models disagree: struck one groove lower, ${result.model("response")} has ${lower("Response")} and
          ${result.model("standard")} ${lower("Standard")} backspin.
        </p>`,
      pictures: [
        headPicture(result, {
          seen: "side",
          radius: columns.roll ?? Number.POSITIVE_INFINITY,
          struck: high,
          face: result.at("height_loft"),
          start: values.launch,
          headTurn: values.club_spin_z,
          ballTurn: values.backspin,
          words: {
            start: `the ball launches ${result.text("launch", values.launch)}`,
            ball: `the ball turns: backspin ${result.text("backspin", values.backspin)}`,
            head: `the loft of the head turns: ${result.text("pitch_rate", values.club_spin_z)}`,
          },
        }),
        chartFrame(result.context, {
          name: "lesson-height",
          title: "Carry over strike height",
          x: { label: "up the face", quantity: "high" },
          y: { label: "carry", quantity: "carry" },
          lines: over ? [{ label: "carry", x: over.x, y: over.y.carry }] : [],
          mark: high,
        }),
      ],
      question: html`How high on the face does this drive carry farthest? Move the strike there.`,
      now: html`Struck ${result.number("high", high)} it has ${result.number("ball_speed", values.ball_speed)} of ball speed and
      carries ${result.number("carry", values.carry)}.`,
      isSolved: values.carry >= NEAR * longest,
      answer: html`About ${result.number("high", best)} on the face: ${result.number("carry", longest)}. With another loft it is
      another height: less loft asks for a higher strike.`,
    };
  },
};
