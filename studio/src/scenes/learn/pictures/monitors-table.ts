/** What two monitors say of one shot. */

import { html, type TemplateResult } from "lit-html";
import type { LessonResult } from "../lesson";

export interface Reported {
  quantity: string;
  radar: number;
  camera: number;
  /** Why they differ. */
  why: string;
}

export const monitorsTable = (result: LessonResult, rows: Reported[]): TemplateResult => html`
  <figure>
    <figcaption>One shot, two reports</figcaption>
    <table>
      <thead>
        <tr><th scope="col">Quantity</th><th scope="col">One</th><th scope="col">Another</th><th scope="col">Why</th></tr>
      </thead>
      <tbody>
        ${rows.map(
          ({ quantity, radar, camera, why }) => html`<tr>
            <th scope="row">${result.context.formatter.quantity(quantity).label}</th>
            <td>${result.number(quantity, radar)}</td>
            <td>${result.number(quantity, camera)}</td>
            <td>${why}</td>
          </tr>`,
        )}
      </tbody>
    </table>
  </figure>
`;
