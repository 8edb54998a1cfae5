/** Why it curves: the ball starts between path and face, and its axis is square to the plane of both. */

import { html } from "lit-html";
import type { Values } from "../../../core/types";
import { crossing, type Lesson, spread } from "../lesson";
import { dPlanePicture } from "../pictures/d-plane";
import { flightsPicture } from "../pictures/flights";

/** How far from the line of its start a ball lands, over its carry; to the right is positive. */
const curveShare = ({ curve, carry }: Values): number => curve / carry;

export const curve: Lesson = {
  name: "curve",
  title: "The ball starts near the face and curves away from the path",
  chosen: { club: "driver", ball: "modern", model: "response" },
  delivery: {
    speed: { value: 100, unit: "mph" },
    attack: { value: 0, unit: "deg" },
    loft: { value: 13, unit: "deg" },
  },
  sliders: [
    { setting: "curve_path", label: "Club path", range: ["-10 deg", "10 deg"], input: "path" },
    { setting: "curve_face", label: "Face angle", range: ["-5 deg", "5 deg"], input: "face" },
  ],
  cases: (setup) => ({
    now: { strike: setup.strike(), path: true },
    straight: { strike: setup.strike({ values: { path: setup.at("curve_face") } }), path: true },
  }),
  curves: (setup) => ({
    path: { strike: setup.strike(), by: "path", values: spread(-0.18, 0.18, 73) },
  }),
  content: (result) => {
    const { straight_curve: straight } = result.context.description.shot_shapes;
    const { start_shares: shares } = result.context.equipment.lessons;
    const { values } = result.case("now");
    const [path, face] = [result.at("curve_path"), result.at("curve_face")];
    const delivery = result.setup.delivery;
    const [published, spreadOfIt] = shares.rows.driver;
    const share = 1 - (result.value("straight", "azimuth") - values.azimuth) / (face - path);
    const over = result.curve("path");
    const curves = over
      ? Array.from(over.x, (_, i) => curveShare({ curve: over.y.curve[i], carry: over.y.carry[i] }))
      : [];
    const enough = crossing(over?.x ?? [], curves, -straight);
    const curved = curveShare(values);
    return {
      text: html`
        <p>
          Path and face are two directions.
          ${
            Math.abs(face - path) > 0.01
              ? html`The ball starts ${result.share(share, "share of the way from path to face")} of the way from path to face;`
              : html`Where they agree the ball starts along both;`
          }
          motion capture found ${result.share(published, "published share")} ± ${result.share(spreadOfIt, "its spread")} for
          drivers, a little less. And it has one spin, not two: it turns about an axis square to the plane of path and face,
          the D-plane. A face right of the path tilts this axis to the right, and the ball banks that way like an aeroplane;
          the axis is now ${result.number("spin_axis", values.spin_axis)}. So the face decides where the ball starts, and the
          difference between face and path which way it curves.
        </p>`,
      pictures: [
        dPlanePicture(result, {
          path: { right: path, up: delivery.attack },
          face: { right: face, up: delivery.loft },
          start: { right: values.azimuth, up: values.launch },
          spinAxis: values.spin_axis,
        }),
        flightsPicture(result, "curve", [
          { kind: "faded", label: "path as the face", case: "straight" },
          { kind: "yours", label: "yours", case: "now" },
        ]),
      ],
      question: html`The face points right of the target. How far to the right must the path go until the ball draws: until
      it curves left by more than ${result.share(straight, "limit of a straight shot")} of its carry?`,
      now: html`Path ${result.number("path", path)}, face ${result.number("face", face)}: the ball curves
      ${result.share(Math.abs(curved), "curve over carry")} of its carry to the ${curved < 0 ? "left" : "right"} and lands
      ${result.number("side", values.side)}.`,
      isSolved: face > 0 && curved < -straight,
      answer: html`From ${result.number("path", enough)} on, with the face ${result.number("face", face)}: the path must be right of
      the face, not only right of the target.`,
      sources: [shares.source],
    };
  },
};
