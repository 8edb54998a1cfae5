/** The D-plane edge-on, as who stands behind the ball sees it: path, face, start and the axis of the spin. */

import { svg, type TemplateResult } from "lit-html";
import { ticks } from "../../../parts/axes";
import { sideOf } from "../../../quantities/formatter";
import type { LessonResult } from "../lesson";
import { drawing, type Point, segment } from "./marks";

interface Direction {
  /** To the right and up [rad]. */
  right: number;
  up: number;
}

export interface DPlane {
  path: Direction;
  face: Direction;
  start: Direction;
  spinAxis: number;
}

const PIXELS = 11;
const DEGREE = Math.PI / 180;
const REACH = 55;

/** On a screen in front of the ball, on which every plane through the ball is a straight line. */
const seen = ({ right, up }: Direction): Point => [
  (PIXELS * Math.tan(right)) / DEGREE,
  (-PIXELS * Math.tan(up)) / Math.cos(right) / DEGREE,
];

export function dPlanePicture(result: LessonResult, { path, face, start, spinAxis }: DPlane): TemplateResult {
  const [ofPath, ofFace, ofStart] = [path, face, start].map(seen);
  const beyond = (share: number): Point => [
    ofPath[0] + share * (ofFace[0] - ofPath[0]),
    ofPath[1] + share * (ofFace[1] - ofPath[1]),
  ];
  const axis = (length: number): Point => [
    ofStart[0] + length * Math.cos(spinAxis),
    ofStart[1] + length * Math.sin(spinAxis),
  ];
  const words = {
    path: `path ${result.text("path", path.right)}`,
    face: `face ${result.text("face", face.right)}`,
    start: `start ${result.text("azimuth", start.right)}`,
    axis: `spin axis ${result.text("spin_axis", spinAxis)}`,
  };
  const { sides } = result.context.formatter.quantity("azimuth");
  const ground = seen({ right: 0, up: 0 })[1];
  return drawing(
    "The D-plane, from behind the ball",
    Object.values(words).join(", "),
    [-150, -180, 300, 232],
    svg`
      ${ticks([-12, 12], 6).map((tick) => {
        const x = PIXELS * tick;
        return svg`${segment("grid", [x, -172], [x, 26])}
          <text class="tick" x=${x} y="42" text-anchor="middle">${`${Math.abs(tick)}° ${sideOf(sides, tick, 0).charAt(0).toUpperCase()}`.trim()}</text>`;
      })}
      ${segment("ground", [-150, ground], [150, ground])}
      ${segment("target", [0, -172], [0, 26])}
      ${segment("plane", beyond(-0.12), beyond(1.12))}
      ${segment("axis", axis(-REACH), axis(REACH))}
      <circle class="ball" cx=${ofStart[0]} cy=${ofStart[1]} r="13"></circle>
      <circle class="spot start" cx=${ofStart[0]} cy=${ofStart[1]} r="5"></circle>
      <circle class="spot path" cx=${ofPath[0]} cy=${ofPath[1]} r="6"></circle>
      <circle class="spot face-line" cx=${ofFace[0]} cy=${ofFace[1]} r="6"></circle>`,
    [
      ["spot path", words.path],
      ["spot face-line", words.face],
      ["spot start", words.start],
      ["axis", words.axis],
    ],
  );
}
