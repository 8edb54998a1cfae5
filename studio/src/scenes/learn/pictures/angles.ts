/** Club and ball from the side: the way of the head, where the face points, and where the ball starts. */

import { svg, type TemplateResult } from "lit-html";
import type { LessonResult } from "../lesson";
import { arrow, drawing, type Point, segment } from "./marks";

export interface Angles {
  attack: number;
  loft: number;
  launch: number;
  /** Another start to compare with, and what it is called. */
  other?: { launch: number; label: string };
}

const RADIUS = 21.35;
const WIDTH = 190;
const HEIGHT = 134;

export function anglesPicture(result: LessonResult, { attack, loft, launch, other }: Angles): TemplateResult {
  const along = (from: Point, angle: number, length: number): Point => [
    from[0] + length * Math.cos(angle),
    from[1] - length * Math.sin(angle),
  ];
  const ball: Point = [0, 0];
  const contact = along(ball, loft, -RADIUS);
  const ends = [along(contact, loft + Math.PI / 2, 26), along(contact, loft - Math.PI / 2, 26)];
  const spinLoft = loft - attack;
  const reach = 34;
  const [from, to] = [along(contact, attack, reach), along(contact, loft, reach)];
  const arc = `M${from[0]} ${from[1]}A${reach} ${reach} 0 0 0 ${to[0]} ${to[1]}`;
  const words = {
    path: `head moves ${result.text("attack", attack)}`,
    face: `face points ${result.text("loft", loft)} up`,
    angle: `between them ${result.text("loft", spinLoft)} of spin loft`,
    start: `ball starts ${result.text("launch", launch)}`,
  };
  const compared = other && `${other.label} ${result.text("launch", other.launch)}`;
  return drawing(
    "At impact, from the side",
    [...Object.values(words), compared].filter(Boolean).join(", "),
    [-75, -92, WIDTH, HEIGHT],
    svg`
      ${segment("target", [-75, 0], [WIDTH, 0])}
      <circle class="ball" r=${RADIUS}></circle>
      ${segment("blade", ends[0], ends[1])}
      <path class="direction between" d=${arc}></path>
      ${arrow("direction path", along(contact, attack, -46), along(contact, attack, 62))}
      ${arrow("direction face-line", contact, along(contact, loft, 88))}
      ${other ? arrow("direction other", ball, along(ball, other.launch, 96)) : ""}
      ${arrow("direction start", ball, along(ball, launch, 96))}`,
    [
      ["direction path", words.path],
      ["direction face-line", words.face],
      ["direction between", words.angle],
      ["direction start", words.start],
      ...(compared ? [["direction other", compared] as const] : []),
    ],
  );
}
