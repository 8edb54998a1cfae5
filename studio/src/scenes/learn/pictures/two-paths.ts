/** A closing head from above: where its centre of gravity moves, and where the centre of its face does. */

import { svg, type TemplateResult } from "lit-html";
import type { LessonResult } from "../lesson";
import { arrow, drawing, type Point, segment, turn } from "./marks";

/** How many times angles are drawn as large as they are. */
const LARGER = 4;
const LENGTH = 66;

/** Directions to the right [rad]; the closure [rad/s]. */
export function twoPathsPicture(
  result: LessonResult,
  { mass, face, closure }: { mass: number; face: number; closure: number },
): TemplateResult {
  const { columns } = result.context.equipment.clubs[result.setup.lesson.chosen.club];
  const [depth, half] = [(columns.cg_x ?? 0) * 1e3, (columns.face_width ?? 0) * 500];
  const centre: Point = [0, 0];
  const gravity: Point = [0, depth];
  const to = ([x, y]: Point, angle: number): Point => [
    x + LENGTH * Math.sin(LARGER * angle),
    y - LENGTH * Math.cos(LARGER * angle),
  ];
  const words = {
    mass: `centre of gravity: path ${result.text("path", mass)}`,
    face: `centre of the face: path ${result.text("path", face)}`,
    closure: `the face is ${result.text("closure", closure)}`,
  };
  return drawing(
    `One head, two paths, angles ×${LARGER}`,
    Object.values(words).join(", "),
    [-78, -78, 156, 186],
    svg`
      <path class="head" d=${`M${-half} 8Q0 -8 ${half} 8C${half + 4} ${2.3 * depth} ${-half - 4} ${2.3 * depth} ${-half} 8Z`}></path>
      ${segment("target", [0, 108], [0, -78])}
      ${turn("direction head-turn", gravity, 26, closure * 0.05, 4)}
      ${arrow("direction path", gravity, to(gravity, mass), 4)}
      ${arrow("direction face-line", centre, to(centre, face), 4)}
      <circle class="mass" cx=${gravity[0]} cy=${gravity[1]} r="3"></circle>
      <circle class="spot face-line" cx="0" cy="0" r="3"></circle>`,
    [
      ["direction path", words.mass],
      ["direction face-line", words.face],
      ["direction head-turn", words.closure],
    ],
  );
}
