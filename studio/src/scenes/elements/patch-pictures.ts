/** Maps of pressure and shear on the face for each case, with legends, words and tables. */

import { html, nothing, type TemplateResult } from "lit-html";
import { repeat } from "lit-html/directives/repeat.js";
import type { Context } from "../../context";
import { handSign } from "../../equipment/equipment";
import { colourLegend } from "../../parts/legend";
import { colourReader } from "../../parts/page-colours";
import type { CaseName } from "./case";
import { type DrawnCase, scales } from "./drawn-case";
import { drawPatch, middleLine, type PatchPoint, patchAt, senses, TRACTIONS, type Traction, traction } from "./patch";
import { valueAt } from "./shape-fields";

export const TITLES: Record<Traction, string> = { normal: "Pressure", tangential: "Shear" };

export function patchPictures(context: Context, cases: DrawnCase[]): TemplateResult {
  const { patch } = scales(context, cases);
  const side = handSign(context.state);
  return html`
    <div class="cases">
      ${repeat(
        cases,
        ({ name }) => name,
        (each) => {
          const points = patchAt(each.impact, each.moment);
          return html`<div>
          ${each.label ? html`<h3>${each.label}</h3>` : nothing}
          <div class="maps">
            ${TRACTIONS.map(
              (name) => html`<figure class=${each.isCurrent ? "" : "stale"}>
                <figcaption>${TITLES[name]}</figcaption>
                <canvas
                  width="360"
                  height="360"
                  data-patch=${`${each.name}-${name}`}
                  role="img"
                  aria-label=${patchLabel(context, each, name, points)}
                ></canvas>
                <p class="ends" aria-hidden="true"><span>${side > 0 ? "heel" : "toe"}</span><span>${side > 0 ? "toe" : "heel"}</span></p>
              </figure>`,
            )}
          </div>
          <p>${forcesInWords(context, each, points)}</p>
          ${patchTable(context, points)}
        </div>`;
        },
      )}
    </div>
    <div class="maps">
      ${colourLegend(context, { title: "Pressure", quantity: "stress", scale: patch.normal })}
      ${colourLegend(context, { title: "Shear", quantity: "stress", scale: patch.tangential, ends: ["takes backspin", "makes backspin"] })}
    </div>
    <p class="remark">
      Seen from behind, through the face; lines are 5 mm apart, and the dark ones cross below the mass centre. Each cell is the force on a node of the mesh, over
      its part of the undeformed surface.
    </p>
  `;
}

function patchLabel(
  { formatter, state }: Context,
  { moment }: DrawnCase,
  name: Traction,
  points: PatchPoint[],
): string {
  const text = (value: number): string => formatter.text("stress", value, state.system);
  const when = `${TITLES[name]} on the face ${formatter.text("contact_time", moment, state.system)} after first touch`;
  if (!points.length) return `${when}: the ball does not touch it`;
  const values = points.map((point) => traction(point, name));
  return `${when}: from ${text(Math.min(...values))} to ${text(Math.max(...values))} over ${points.length} nodes`;
}

function forcesInWords({ formatter, state }: Context, { impact, moment }: DrawnCase, points: PatchPoint[]): string {
  const text = (name: string, value: number): string => formatter.text(name, value, state.system);
  if (!points.length) return "The ball does not touch the face.";
  const [makes, takes] = senses(points);
  return (
    `Normal force ${text("normal", valueAt(impact, "contact", "normal", moment))}. Along the face, parts of the patch make ` +
    `backspin with ${text("tangential", makes)}, and others take it away with ${text("tangential", -takes)}.`
  );
}

function patchTable({ formatter, state }: Context, points: PatchPoint[]): TemplateResult | typeof nothing {
  if (!points.length) return nothing;
  const text = (name: string, value: number): string => formatter.text(name, value, state.system);
  return html`<details>
    <summary>Pressure and shear as a table</summary>
    <table>
      <caption>On the line up the face through its middle</caption>
      <thead>
        <tr><th scope="col">up from the mass centre</th><th scope="col">pressure</th><th scope="col">shear</th></tr>
      </thead>
      <tbody>
        ${middleLine(points).map(
          (point) => html`<tr>
            <th scope="row">${text("penetration", point.up)}</th>
            ${TRACTIONS.map((name) => html`<td>${text("stress", traction(point, name))}</td>`)}
          </tr>`,
        )}
      </tbody>
    </table>
  </details>`;
}

/** What each canvas was last drawn from. */
const drawn = new WeakMap<HTMLCanvasElement, readonly unknown[]>();

export const patchCanvas = (name: CaseName, which: Traction): HTMLCanvasElement | null =>
  document.querySelector<HTMLCanvasElement>(`canvas[data-patch="${name}-${which}"]`);

export function drawPatches(context: Context, cases: DrawnCase[]): void {
  const { patch, reach } = scales(context, cases);
  for (const each of cases)
    for (const name of TRACTIONS) {
      const canvas = patchCanvas(each.name, name);
      if (!canvas) continue;
      const [ink, line] = ["--ink", "--faint"].map(colourReader(canvas));
      const side = handSign(context.state);
      const inputs = [each.impact, each.moment, patch[name].most, reach, side, ink];
      const before = drawn.get(canvas);
      if (before?.every((input, i) => input === inputs[i])) continue;
      drawn.set(canvas, inputs);
      drawPatch(canvas, {
        points: patchAt(each.impact, each.moment),
        name,
        scale: patch[name],
        reach,
        side,
        ink,
        line,
      });
    }
}
