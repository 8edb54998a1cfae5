/** Face map: what every impact point of a face gives, of one club or the difference of two, and what a spread costs. */

import { html, nothing, type TemplateResult } from "lit-html";
import type { Context, Scene } from "../../context";
import { deliveryPanel } from "../shot/delivery";
import { equipmentPanel } from "../shot/equipment-panel";
import { bestPanel } from "./best-points";
import { forgivenessPanel } from "./forgiveness";
import { mapPanel, setMap } from "./map-panel";
import { wantedMaps } from "./mapped";
import "./map.css";

export const mapScene: Scene = { view, wanted: wantedMaps, drawn: setMap };

function view(context: Context): TemplateResult {
  const failure = context.model.results.map?.failure;
  return html`
    <div class=${failure ? "shot face-map stale" : "shot face-map"}>
      <p class="failure" role="alert">${failure ? `This face cannot be mapped. ${failure}` : nothing}</p>
      <div class="controls">${equipmentPanel(context)} ${deliveryPanel(context)}</div>
      <div class="results">
        <div class="pictures">${mapPanel(context)} ${bestPanel(context)}</div>
        ${forgivenessPanel(context)}
      </div>
    </div>
  `;
}
