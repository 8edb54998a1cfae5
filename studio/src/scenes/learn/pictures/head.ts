/** The head with the ball on its face: from above with its bulge, or from the side with its roll. */

import { svg, type TemplateResult } from "lit-html";
import type { LessonResult } from "../lesson";
import { arrow, drawing, type Point, segment, turn } from "./marks";

export interface HeadPicture {
  seen: "above" | "side";
  /** Radius of the face in this view [m]. */
  radius: number;
  /** Where the face is struck, towards the toe or up the face [m]. */
  struck: number;
  /** Where the face points at its centre, and where the ball starts, to the right or up [rad]. */
  face: number;
  start: number;
  /** Turning of head and ball after impact about the axis towards who looks [rad/s]. */
  headTurn: number;
  ballTurn: number;
  /** In words: the start, the spin. */
  words: { start: string; ball: string; head: string };
}

const MILLIMETRE = 1e-3;
/** Times over which the turns are drawn [s]: the head turns far more slowly than the ball. */
const [HEAD_TIME, BALL_TIME] = [0.03, 0.008];
/** Extent of a head behind its face, as a multiple of the depth of its CG. */
const DEEP = 2.3;

export function headPicture(result: LessonResult, picture: HeadPicture): TemplateResult {
  const { seen, struck, face, start, headTurn, ballTurn, words } = picture;
  const { equipment } = result.context;
  const { club, ball } = result.setup.lesson.chosen;
  const { columns } = equipment.clubs[club];
  const isAbove = seen === "above";
  const [radius, at] = [picture.radius / MILLIMETRE, struck / MILLIMETRE];
  const size = ((isAbove ? columns.face_width : columns.face_height) ?? 0) / MILLIMETRE;
  const ballRadius = equipment.balls[ball].columns.ball_radius / MILLIMETRE;
  /** From along the target line and across it to the page. */
  const place = ([along, across]: Point): Point => (isAbove ? [across, -along] : [along, -across]);
  const from = ([x, y]: Point, angle: number, length: number): Point => [
    x + length * Math.cos(angle),
    y + length * Math.sin(angle),
  ];
  /** A point of the face, at a distance from its centre. */
  const onFace = (away: number): Point => {
    const depth = Number.isFinite(radius) ? radius - Math.sqrt(radius ** 2 - away ** 2) : 0;
    return from(from([0, 0], face, -depth), face + Math.PI / 2, away);
  };
  const corners = Array.from({ length: 21 }, (_, i) => place(onFace((i / 20 - 0.5) * size)));
  const contact = onFace(at);
  const normal = face + (Number.isFinite(radius) ? Math.asin(at / radius) : 0);
  const centre = from(contact, normal, ballRadius);
  const turned = isAbove ? face : face - (columns.static_loft ?? 0);
  const [back, across] = [columns.cg_x ?? 0, (isAbove ? columns.cg_z : columns.cg_y) ?? 0].map(
    (each) => -each / MILLIMETRE,
  );
  const mass = place(from(from([0, 0], turned, back), turned + Math.PI / 2, across));
  const rear = (share: number): Point => place(from(onFace(share * size), turned, DEEP * back));
  const [first] = corners;
  const outline =
    `M${corners.map(([x, y]) => `${x.toFixed(1)} ${y.toFixed(1)}`).join("L")}` +
    `C${rear(0.56).join(" ")} ${rear(-0.56).join(" ")} ${first.join(" ")}Z`;
  const box = isAbove ? ([-78, -100, 156, 190] as const) : ([-100, -58, 190, 104] as const);
  return drawing(
    isAbove ? "Head and ball from above" : "Head and ball from the side",
    Object.values(words).join(", "),
    box,
    svg`
      <path class="head" d=${outline}></path>
      ${segment("target", place([-100, 0]), place([110, 0]))}
      <path class="blade" d=${`M${corners.map((corner) => corner.join(" ")).join("L")}`}></path>
      <circle class="ball" cx=${place(centre)[0]} cy=${place(centre)[1]} r=${ballRadius}></circle>
      ${arrow("direction face-line", place(contact), place(from(contact, normal, 48)), 4)}
      ${arrow("direction start", place(centre), place(from(centre, start, 58)), 4)}
      <circle class="mass" cx=${mass[0]} cy=${mass[1]} r="3"></circle>
      ${turn("direction head-turn", mass, 12, headTurn * HEAD_TIME, 4)}
      ${turn("direction ball-turn", place(centre), 12, ballTurn * BALL_TIME, 4)}
      ${segment("direction lever", mass, place(contact))}`,
    [
      ["direction face-line", "where the face points there"],
      ["direction start", words.start],
      ["direction ball-turn", words.ball],
      ["direction head-turn", words.head],
      ["mass", "centre of gravity of the head"],
    ],
  );
}
