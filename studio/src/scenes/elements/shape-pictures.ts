/** The deforming ball of each case in three dimensions, with legend and table. */

import { html, nothing, type TemplateResult } from "lit-html";
import { repeat } from "lit-html/directives/repeat.js";
import { type Context, choiceSetting, delivered, outlineOf as outlineOfFace } from "../../context";
import { settingChoice } from "../../parts/choice";
import { colourLegend } from "../../parts/legend";
import { setStage, stageFrame } from "../../parts/stage";
import { type Look, pieceColour, setBall } from "./ball-picture";
import { ballOf } from "./case";
import { type DrawnCase, SHAPE_COLOURS, scales } from "./drawn-case";
import { displacements, speeds, widths } from "./shape-fields";

export function shapePictures(context: Context, cases: DrawnCase[]): TemplateResult {
  const { shape } = scales(context, cases);
  const colour = choiceSetting(context, "colour");
  const [quantity, title] = SHAPE_COLOURS[colour] ?? [];
  return html`
    <div class="choices looks">
      ${settingChoice(context, {
        name: "cut",
        label: "Shown",
        options: [
          ["half", "cut in half"],
          ["whole", "whole ball"],
        ],
      })}
      ${settingChoice(context, {
        name: "colour",
        label: "Colour",
        options: [
          ["displacement", "displacement"],
          ["speed", "speed"],
          ["pieces", "core and cover"],
        ],
      })}
    </div>
    <div class="cases">
      ${repeat(
        cases,
        ({ name }) => name,
        (each) => html`<figure class=${each.isCurrent ? "" : "stale"}>
          ${each.label ? html`<figcaption>${each.label}</figcaption>` : nothing}
          ${stageFrame(`elements-${each.name}`, shapeInWords(context, each))}
        </figure>`,
      )}
    </div>
    ${
      quantity
        ? colourLegend(context, { title, quantity, scale: shape })
        : html`<ul class="legend">
            ${pieceNames(context, cases).map(
              (name, i) => html`<li><i style=${`border-color: var(${pieceColour(i)})`}></i>${name}</li>`,
            )}
          </ul>`
    }
    <details>
      <summary>The shapes as a table</summary>
      ${cases.map((each) => shapeTable(context, each))}
    </details>
  `;
}

const pieceNames = (context: Context, cases: DrawnCase[]): string[] => ballOf(context, cases[0].setup)?.pieces ?? [];

function shapeInWords({ formatter, state }: Context, { impact, frame, moment }: DrawnCase): string {
  const text = (name: string, value: number): string => formatter.text(name, value, state.system);
  const [along, up] = widths(impact, frame);
  const furthest = Math.max(...displacements(impact, frame));
  return (
    `The meshed ball on the face ${text("contact_time", moment)} after first touch, seen from the right: ` +
    `${text("penetration", along)} thick and ${text("penetration", up)} high, pieces displaced by up to ` +
    `${text("penetration", furthest)}`
  );
}

const ROWS = 11;

function shapeTable({ formatter, state }: Context, { impact, label }: DrawnCase): TemplateResult {
  const text = (name: string, value: number): string => formatter.text(name, value, state.system);
  const last = impact.times.length - 1;
  const frames = [...new Set(Array.from({ length: ROWS }, (_, i) => Math.round((i * last) / (ROWS - 1))))];
  const heads = ["time", "thickness", "height", "width to the toe", "largest displacement", "largest speed"];
  return html`<div class="scroll" tabindex="0" role="region" aria-label=${`Shapes ${label}`}>
    <table>
      <caption>${label || "The ball at moments of the impact"}</caption>
      <thead><tr>${heads.map((head) => html`<th scope="col">${head}</th>`)}</tr></thead>
      <tbody>
        ${frames.map(
          (frame) => html`<tr>
            <th scope="row">${text("contact_time", impact.times[frame])}</th>
            ${widths(impact, frame).map((width) => html`<td>${text("penetration", width)}</td>`)}
            <td>${text("penetration", Math.max(...displacements(impact, frame)))}</td>
            <td>${text("ball_velocity", Math.max(...speeds(impact, frame)))}</td>
          </tr>`,
        )}
      </tbody>
    </table>
  </div>`;
}

/** Half the side of a plane that is drawn [m]. */
const PLANE = 0.033;
const SQUARE = [
  [-PLANE, -PLANE],
  [PLANE, -PLANE],
  [PLANE, PLANE],
  [-PLANE, PLANE],
] as const;
let outline: { key: string; corners: Look["outline"] } = { key: "", corners: SQUARE };

/** The outline of the face from the point where it is struck; the same object while it is the same. */
function outlineOf(context: Context, { setup }: DrawnCase): Look["outline"] {
  if (setup.against === "plane") return SQUARE;
  const corners = outlineOfFace(context);
  const [toe, high] = [delivered(context, "toe"), delivered(context, "high")];
  const key = JSON.stringify([context.state.club, toe, high]);
  if (outline.key !== key) outline = { key, corners: corners.map(([z, y]) => [z - toe, y - high] as const) };
  return outline.corners;
}

export function drawShapes(context: Context, cases: DrawnCase[]): void {
  const [cut, colour] = [choiceSetting(context, "cut"), choiceSetting(context, "colour")];
  const scale = scales(context, cases).shape;
  for (const each of cases) {
    const corners = outlineOf(context, each);
    const inputs = [each.impact, each.frame, cut, colour, scale.most, corners, context.state.theme];
    setStage(`elements-${each.name}`, inputs, (stage, isNew) =>
      setBall(stage, each.impact, each.frame, { cut, colour, scale, outline: corners }, isNew),
    );
  }
}
