/** Club and ball at impact, to scale: from above path, face and start, from the side attack, loft and launch. */

import { html, svg, type TemplateResult } from "lit-html";
import { type Context, delivered } from "../../context";
import { handSign } from "../../equipment/equipment";

const MILLIMETRE = 1e-3;
/** Half the width of a drawing [mm]. */
const HALF = 75;
/** Lengths of what is drawn [mm]: the club's path before impact, path and face normal after it, the ball's start. */
const PATH_BEFORE = 50;
const AFTER = 60;
const START = 92;

interface Direction {
  /** Class of the line. */
  kind: string;
  name: string;
  /** Angle from the target line, to the right or up [rad]. */
  angle: number;
}

export function atImpact(context: Context): TemplateResult {
  const values = context.model.good?.values;
  if (!values) return html``;
  const direction = (kind: string, name: string): Direction => ({
    kind,
    name,
    angle: values[name] ?? delivered(context, name),
  });
  const { columns } = context.equipment.clubs[context.state.club];
  const fromAbove = [direction("path", "path"), direction("face-line", "face"), direction("start", "azimuth")];
  const fromSide = [direction("path", "attack"), direction("face-line", "loft"), direction("start", "launch")];
  return html`
    <section aria-labelledby="at-impact">
      <h2 id="at-impact">At impact</h2>
      <div class="at-impact">
        ${view(context, "From above", fromAbove, {
          // To the right on the page is right of the target, up is to the target.
          place: (along, across) => [across, -along],
          size: columns.face_width ?? 0,
          struck: handSign(context.state) * delivered(context, "toe"),
        })}
        ${view(context, "From the side", fromSide, {
          place: (along, across) => [along, -across],
          size: columns.face_height ?? 0,
          struck: delivered(context, "high"),
        })}
      </div>
    </section>
  `;
}

interface Layout {
  /** Where a point ahead and to the side stands on the page. */
  place(along: number, across: number): [number, number];
  /** Extent of the face [m], and where it is struck. */
  size: number;
  struck: number;
}

function view(context: Context, title: string, directions: Direction[], layout: Layout): TemplateResult {
  const { formatter, state, equipment } = context;
  const [club, face, start] = directions;
  const radius = equipment.balls[state.ball].columns.ball_radius / MILLIMETRE;
  const normal = [Math.cos(face.angle), Math.sin(face.angle)] as const;
  const contact = [-radius * normal[0], -radius * normal[1]] as const;
  /** A point of the face, away from the impact point. */
  const onFace = (at: number): [number, number] =>
    layout.place(contact[0] - at * normal[1], contact[1] + at * normal[0]);
  const from = (origin: readonly [number, number], angle: number, length: number): [number, number] =>
    layout.place(origin[0] + length * Math.cos(angle), origin[1] + length * Math.sin(angle));
  const segment = (kind: string, [x1, y1]: [number, number], [x2, y2]: [number, number]): TemplateResult =>
    svg`<line class=${kind} x1=${x1} y1=${y1} x2=${x2} y2=${y2}></line>` as TemplateResult;
  const [least, most] = [-layout.size / 2 - layout.struck, layout.size / 2 - layout.struck].map(
    (at) => at / MILLIMETRE,
  );
  const words = directions.map(({ kind, name, angle }) => ({
    kind,
    text: `${formatter.quantity(name).label} ${formatter.text(name, angle, state.system)}`,
  }));
  const centre = layout.place(0, 0);
  return html`
    <figure>
      <figcaption>${title}</figcaption>
      <svg
        viewBox=${`${-HALF} ${-HALF} ${2 * HALF} ${2 * HALF}`}
        role="img"
        aria-label=${`${title}: ${words.map(({ text }) => text).join(", ")}`}
      >
        ${segment("target", from([0, 0], 0, -HALF * 1.2), from([0, 0], 0, HALF * 1.2))}
        <circle class="ball" cx=${centre[0]} cy=${centre[1]} r=${radius}></circle>
        ${segment("blade", onFace(least), onFace(most))}
        ${segment("direction path", from(contact, club.angle, -PATH_BEFORE), from(contact, club.angle, AFTER))}
        ${segment("direction face-line", from(contact, face.angle, 0), from(contact, face.angle, AFTER))}
        ${segment("direction start", from([0, 0], start.angle, 0), from([0, 0], start.angle, START))}
      </svg>
      <ul class="legend">
        ${words.map(({ kind, text }) => html`<li><i class=${`direction ${kind}`}></i>${text}</li>`)}
      </ul>
    </figure>
  `;
}
