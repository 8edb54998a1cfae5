/** Shot: how the club is delivered, how the ball leaves, and where it flies. */

import { html, nothing, type TemplateResult } from "lit-html";
import { type Context, type Scene, strike } from "../../context";
import type { Wanted } from "../../core/lanes";
import type { Failure } from "../../core/types";
import { outputOf } from "../../state/store";
import { atImpact, setHead } from "./at-impact";
import { spinPanel } from "./ball-spin";
import { deliveryPanel } from "./delivery";
import { equipmentPanel } from "./equipment-panel";
import { contributionsInput } from "./explanation/contributions";
import { explained, explanation } from "./explanation/explanation";
import { facePanel } from "./face";
import { flightPanel } from "./flight-panel";
import { headline } from "./headline";
import { numbersPanel } from "./numbers";
import { whatIfPanel } from "./what-if";
import { DELIVERY } from "./words";

export const shotScene: Scene = {
  view,
  wanted: (context) => {
    const struck = strike(context);
    const lane = slopesLane(context);
    const slopes: Wanted = { kind: "slopes", input: struck, lane };
    return explained(context)
      ? [slopes, { kind: "contributions", input: contributionsInput(context, struck), lane }]
      : [slopes];
  },
  drawn: setHead,
};

function view(context: Context): TemplateResult {
  const failure = outputOf(context.model, "shot")?.failure;
  return html`
    <div class=${failure ? "shot stale" : "shot"}>
      <p class="failure" role="alert">${failure ? failureText(context, failure) : nothing}</p>
      ${headline(context)}
      <div class="controls">${equipmentPanel(context)} ${deliveryPanel(context)} ${facePanel(context)}</div>
      <div class="results">
        <div class="pictures">
          <div class="meeting">${atImpact(context)} ${spinPanel(context)}</div>
          ${flightPanel(context)} ${whatIfPanel(context)}</div>
        ${numbersPanel(context)}
      </div>
      ${explanation(context)}
    </div>
  `;
}

/** Derivatives of a contact that lasts take longer than a frame, those of an impulse less than a millisecond. */
function slopesLane({ state, description }: Context): "page" | "quick" {
  return description.models.find(({ name }) => name === state.model)?.kind === "contact" ? "quick" : "page";
}

function failureText({ model }: Context, { input, message }: Failure): string {
  const kept = model.good ? " The last one is shown." : "";
  return `This shot cannot be computed. ${DELIVERY[input]?.label ?? input}: ${message}.${kept}`;
}
