/** Sweet spot, longest carry and effective face: the figures that a face has as a whole. */

import { html, type TemplateResult } from "lit-html";
import type { Context } from "../../context";
import type { FaceValues } from "../../core/face-map";
import { areDetailsOld, clubsOf, detailedMaps } from "./mapped";
import { placeInWords } from "./scales";

export function bestPanel(context: Context): TemplateResult {
  const maps = detailedMaps(context, "map");
  const clubs = clubsOf(context);
  if (maps?.faces.length !== clubs.length) return html``;
  return html`
    <section class=${areDetailsOld(context, "map") ? "best old" : "best"} aria-labelledby="best">
      <h2 id="best">Sweet spot and effective face</h2>
      <div class="scroll" tabindex="0" role="region" aria-label="Table of sweet spot and effective face">
        <table>
          <caption class="unseen">Sweet spot, longest carry and effective face</caption>
          <thead>
            <tr>
              <th scope="col">Of the face</th>
              ${clubs.map((club) => html`<th scope="col">${context.equipment.clubs[club].label}</th>`)}
            </tr>
          </thead>
          <tbody>
            ${rows(context).map(
              ({ title, meaning, text }) => html`<tr>
                <th scope="row" title=${meaning}>${title}</th>
                ${maps.faces.map((face, i) => text(face, i))}
              </tr>`,
            )}
          </tbody>
        </table>
      </div>
    </section>
  `;
}

interface Row {
  title: string;
  meaning: string;
  text(face: FaceValues, place: number): TemplateResult;
}

function rows(context: Context): Row[] {
  const { formatter, state, equipment } = context;
  const number = (quantity: string, name: string, si: number | null | undefined): TemplateResult =>
    html`<td data-best=${name} data-value=${String(si)}>${si == null ? "–" : formatter.text(quantity, si, state.system)}</td>`;
  const place =
    (quantity: string) =>
    ({ summary }: FaceValues): TemplateResult => {
      const best = summary.best[quantity];
      if (!best) return html`<td>–</td>`;
      return html`<td data-best=${`${quantity} place`} data-toe=${String(best.toe)} data-high=${String(best.high)}>
      ${placeInWords(context, [best.toe, best.high])}
    </td>`;
    };
  const isOld = areDetailsOld(context, "map-area");
  const area = isOld ? null : detailedMaps(context, "map-area");
  const least = formatter.format(100 * (1 - equipment.face_map.share), 0);
  return [
    { title: "Sweet spot", meaning: "where the ball speed is greatest", text: place("ball_speed") },
    {
      title: "Ball speed there",
      meaning: "the greatest of the face",
      text: ({ summary }) => number("ball_speed", "ball_speed", summary.best.ball_speed?.value),
    },
    { title: "Longest carry from", meaning: "where the carry is greatest", text: place("carry") },
    {
      title: "Carry there",
      meaning: "the greatest of the face",
      text: ({ summary }) => number("carry", "carry", summary.best.carry?.value),
    },
    {
      title: "Effective face",
      meaning: `where the ball speed is within ${least}% of that of the sweet spot`,
      text: (_, i) =>
        area === null
          ? html`<td aria-busy="true">being computed …</td>`
          : number("face_area", "effective_area", area.faces[i]?.summary.effective_area),
    },
    {
      title: "Whole face",
      meaning: "area within the outline",
      text: ({ summary }) => number("face_area", "face_area", summary.face_area),
    },
  ];
}
