/** The ball from behind: its spin axis, how its near side moves, and where the lift pulls it. */

import { html, svg, type TemplateResult } from "lit-html";
import type { Context } from "../../context";

/** Radius of the ball in the drawing, and half its width. */
const RADIUS = 40;
const HALF = 72;
/** Lengths from the middle: of the axis, and of the arrow of the lift. */
const AXIS = 62;
const LIFT = 60;
/** Stripes that the ball's near side moves along, as shares of the radius. */
const STRIPES = [-0.62, 0, 0.62];

type Point = readonly [right: number, up: number];

export function spinPanel(context: Context): TemplateResult {
  const values = context.model.good?.values;
  if (!values) return html``;
  const { formatter, state } = context;
  const text = (name: string): string =>
    `${formatter.quantity(name).label} ${formatter.text(name, values[name], state.system)}`;
  const words = [text("spin_axis"), text("backspin"), text("sidespin"), text("total_spin")];
  return html`
    <section class="spin" aria-labelledby="spin">
      <h2 id="spin">Spin</h2>
      ${drawing([values.backspin, values.sidespin], `The ball from behind: ${words.join(", ")}.`)}
      <ul class="legend" aria-label="Spin of the ball from behind">
        <li><i class="spin-axis"></i>${words[0]}</li>
        <li><i class="surface"></i>near side of the ball: ${words[1]}, ${words[2]}</li>
        <li><i class="lift"></i>lift</li>
        <li>${words[3]}</li>
      </ul>
      <p class="remark">${pull(context, values.spin_axis)}</p>
    </section>
  `;
}

function pull({ formatter, state }: Context, axis: number): string {
  const { side, number, unit } = formatter.show("spin_axis", axis, state.system);
  if (!side) return "The axis is level: nothing pulls the ball to a side.";
  return `The axis leans ${number}${unit} to the ${side}, the lift with it: that pulls the ball ${side}.`;
}

function drawing([backspin, sidespin]: readonly [number, number], label: string): TemplateResult {
  const whole = Math.hypot(backspin, sidespin) || 1;
  // From behind, right and up: the axis of backspin points right, the near side of the ball then moves down.
  const axis: Point = [backspin / whole, -sidespin / whole];
  const lift: Point = [sidespin / whole, backspin / whole];
  const at = ([right, up]: Point, far: number, [across, over]: Point = [0, 0], sideways = 0): [number, number] => [
    right * far + across * sideways,
    -(up * far + over * sideways),
  ];
  const line = (kind: string, [x1, y1]: [number, number], [x2, y2]: [number, number]): TemplateResult =>
    svg`<line class=${kind} x1=${x1} y1=${y1} x2=${x2} y2=${y2}></line>` as TemplateResult;
  const head = (kind: string, tip: [number, number], [right, up]: Point): TemplateResult => {
    const corner = (back: number, out: number): string =>
      `${tip[0] - right * back - up * out},${tip[1] + up * back - right * out}`;
    return svg`<polygon class=${kind} points=${`${tip.join(",")} ${corner(7, 3.5)} ${corner(7, -3.5)}`}></polygon>` as TemplateResult;
  };
  const down: Point = [-lift[0], -lift[1]];
  const stripes = STRIPES.map((share) => {
    const half = RADIUS * Math.sqrt(1 - share ** 2) * 0.8;
    const [from, to] = [at(axis, share * RADIUS, down, -half), at(axis, share * RADIUS, down, half)];
    // Stripes away from the middle are seen as arcs of the ball.
    const bow = at(axis, share * RADIUS * 1.25, down, 0);
    return svg`
      <path class="surface" d=${`M${from.join(" ")} Q${bow.join(" ")} ${to.join(" ")}`}></path>
      ${head("surface", at(axis, share * RADIUS * 0.98, down, half + 3), down)}`;
  });
  return html`
    <svg viewBox=${`${-HALF} ${-HALF} ${2 * HALF} ${2 * HALF}`} role="img" aria-label=${label}>
      <line class="target" x1=${-HALF} x2=${HALF} y1="0" y2="0"></line>
      <circle class="ball" r=${RADIUS}></circle>
      ${stripes}
      ${line("spin-axis", at(axis, -AXIS), at(axis, AXIS))}
      ${line("lift", at(lift, RADIUS), at(lift, LIFT))} ${head("lift", at(lift, LIFT + 6), lift)}
    </svg>
  `;
}
