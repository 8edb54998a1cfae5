/** Lines, arrows and turns of the drawings of lessons. */

import { html, svg, type TemplateResult } from "lit-html";

export type Point = readonly [x: number, y: number];

export const segment = (kind: string, [x1, y1]: Point, [x2, y2]: Point): TemplateResult =>
  svg`<line class=${kind} x1=${x1} y1=${y1} x2=${x2} y2=${y2}></line>` as TemplateResult;

/** A line with a point at its end. */
export function arrow(kind: string, from: Point, to: Point, size = 5): TemplateResult {
  const angle = Math.atan2(to[1] - from[1], to[0] - from[0]);
  return svg`${segment(kind, from, to)}${head(kind, to, angle, size)}` as TemplateResult;
}

/** An arc with a point at its end: `angle` counts against the clock [rad], and begins at the top. */
export function turn(kind: string, [x, y]: Point, radius: number, angle: number, size = 5): TemplateResult {
  const shown = Math.sign(angle) * Math.min(Math.abs(angle), 5.5);
  if (Math.abs(shown) < 0.03) return svg`` as TemplateResult;
  const end = -Math.PI / 2 - shown;
  const to = [x + radius * Math.cos(end), y + radius * Math.sin(end)] as const;
  const flags = `${Math.abs(shown) > Math.PI ? 1 : 0} ${shown > 0 ? 0 : 1}`;
  const tangent = end - (Math.sign(shown) * Math.PI) / 2;
  return svg`<path class=${kind} d=${`M${x} ${y - radius}A${radius} ${radius} 0 ${flags} ${to[0]} ${to[1]}`}></path>
    ${head(kind, to, tangent, size)}` as TemplateResult;
}

function head(kind: string, [x, y]: Point, angle: number, size: number): TemplateResult {
  const corner = (turned: number, length: number): string =>
    `${x + length * Math.cos(angle + turned)},${y + length * Math.sin(angle + turned)}`;
  const points = [corner(0, size * 0.4), corner(2.5, size), corner(-2.5, size)].join(" ");
  return svg`<polygon class=${`${kind} point`} points=${points}></polygon>` as TemplateResult;
}

/** A drawing with its title, its content in words, and what its lines are. */
export const drawing = (
  title: string,
  words: string,
  box: readonly [x: number, y: number, width: number, height: number],
  content: unknown,
  legend: readonly (readonly [kind: string, text: string])[],
): TemplateResult => html`
  <figure class="lesson-drawing">
    <figcaption>${title}</figcaption>
    <svg viewBox=${box.join(" ")} role="img" aria-label=${`${title}: ${words}`}>${content}</svg>
    <ul class="legend">
      ${legend.map(([kind, text]) => html`<li><i class=${kind}></i>${text}</li>`)}
    </ul>
  </figure>
`;
