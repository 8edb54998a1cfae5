/** Why wet wedges launch high: without grip the ball slides up the face. */

import { html } from "lit-html";
import { chartFrame } from "../../../parts/chart";
import { crossing, type Lesson, spread } from "../lesson";
import { anglesPicture } from "../pictures/angles";

/** The share of the dry spin that is asked for, and how near to it. */
const HALF = 0.5;
const NEAR = 0.03;
/** Launch angles that are alike on the page [rad]. */
const ALIKE = 0.001;

export const wet: Lesson = {
  name: "wet",
  title: "A wet wedge launches high because the ball slides",
  chosen: { club: "sand-wedge", ball: "modern", model: "response" },
  delivery: { speed: { value: 60, unit: "mph" }, attack: { value: -5, unit: "deg" } },
  sliders: [
    { setting: "wet_friction", label: "Friction of ball and face", range: ["0.05", "0.6"] },
    { setting: "wet_loft", label: "Dynamic loft", range: ["20 deg", "60 deg"], input: "loft" },
  ],
  left: "The Shot scene has the friction of the ball; that of the slider stays here.",
  cases: (setup) => {
    const parameters = { friction: setup.at("wet_friction") };
    const dry = { friction: setup.usual("wet_friction") };
    const driver = {
      chosen: { club: "driver" },
      values: { loft: setup.usual("height_loft"), attack: 0, speed: setup.delivery.speed },
    };
    return {
      now: { strike: setup.strike({ parameters }) },
      dry: { strike: setup.strike({ parameters: dry }) },
      driver: { strike: setup.strike({ ...driver, parameters }) },
      dryDriver: { strike: setup.strike({ ...driver, parameters: dry }) },
    };
  },
  curves: (setup) => ({ friction: { strike: setup.strike(), by: "friction", values: spread(0.05, 0.6, 56) } }),
  content: (result) => {
    const { values } = result.case("now");
    const [friction, loft] = [result.at("wet_friction"), result.at("wet_loft")];
    const dry = (quantity: string): number => result.value("dry", quantity);
    const { source, rows } = result.context.equipment.lessons.wedge_covers;
    const over = result.curve("friction");
    const answer = over ? crossing(over.x, over.y.backspin, HALF * dry("backspin")) : Number.NaN;
    const share = values.backspin / dry("backspin");
    const driver = result.value("driver", "launch") - result.value("dryDriver", "launch");
    return {
      text: html`
        <p>
          With this much loft the ball climbs the face unless friction holds it. Dry, with a friction of
          ${result.number("friction", result.setup.usual("wet_friction"))}, this one starts ${result.number("launch", dry("launch"))}
          with ${result.number("backspin", dry("backspin"))}. With water or grass between them it slides, starts nearer to where
          the face points, and turns less: now ${result.number("launch", values.launch)}. A drive with that friction launches
          ${Math.abs(driver) < ALIKE ? "as before" : result.difference("launch", driver, ["lower", "higher"])}.
        </p>
        <p>
          Of 62 balls that a robot struck, those with urethane covers started
          ${result.number("launch", rows.urethane[0])} with ${result.number("backspin", rows.urethane[1])}, and two that slid
          ${result.number("launch", rows["two that slide"][0])} with ${result.number("backspin", rows["two that slide"][1])}. No published friction of a wet face was found, and no model here has grooves.
        </p>`,
      pictures: [
        anglesPicture(result, {
          attack: result.setup.delivery.attack,
          loft,
          launch: values.launch,
          other: { launch: dry("launch"), label: "dry, it starts" },
        }),
        chartFrame(result.context, {
          name: "lesson-wet",
          title: "Backspin over friction, with this loft",
          x: { label: "friction", quantity: "friction" },
          y: { label: "backspin", quantity: "backspin" },
          lines: over ? [{ label: "backspin", x: over.x, y: over.y.backspin }] : [],
          mark: friction,
        }),
      ],
      question: html`How slippery must the face be for half of the dry spin to be lost?`,
      now: html`Friction ${result.number("friction", friction)}: ${result.share(share, "spin over that of a dry face")} of the dry
      spin, ${result.number("backspin", values.backspin)}.`,
      isSolved: Math.abs(share - HALF) <= NEAR,
      answer: html`A friction of about ${result.number("friction", answer)},
      ${result.share(answer / result.setup.usual("wet_friction"), "friction over that of a dry face")} of the dry one. The ball
      slides all the way up the face there, and its spin falls as friction does.`,
      sources: [source],
    };
  },
};
