/** Flight: the range in three dimensions, in wind, air and on grounds of all kinds. */

import { html, nothing, type TemplateResult } from "lit-html";
import { type Context, choiceSetting, type Scene, strike } from "../../context";
import type { Wanted } from "../../core/lanes";
import { outputOf } from "../../state/store";
import { deliveryPanel } from "../shot/delivery";
import { equipmentPanel } from "../shot/equipment-panel";
import { contributionsInput } from "../shot/explanation/contributions";
import { explained, explanation } from "../shot/explanation/explanation";
import { headline } from "../shot/headline";
import { bagPanel } from "./bag";
import { bagStrikes } from "./bag-shots";
import { conditionsPanel } from "./conditions-panel";
import { flightNumbers } from "./flight-numbers";
import { golferPanel } from "./golfer";
import { golferShots } from "./golfer-shots";
import { rangePanel } from "./range-panel";
import { setRange } from "./range-picture";
import "../../style/flight.css";

export const flightScene: Scene = { view, wanted, drawn: setRange };

function wanted(context: Context): Wanted[] {
  const result: Wanted[] = [{ kind: "air", input: strike(context).flight }];
  if (explained(context)) result.push({ kind: "contributions", input: contributionsInput(context, strike(context)) });
  const flying = choiceSetting(context, "flying");
  if (flying === "clubs") result.push({ kind: "bag", input: bagStrikes(context), lane: "batch" });
  if (flying === "golfer") result.push({ kind: "dispersion", input: golferShots(context), lane: "batch" });
  return result;
}

function view(context: Context): TemplateResult {
  const failure = outputOf(context.model, "shot")?.failure;
  const flying = choiceSetting(context, "flying");
  return html`
    <div class=${failure ? "range stale" : "range"}>
      <p class="failure" role="alert">
        ${failure ? `This flight cannot be computed. ${failure.input}: ${failure.message}.` : nothing}
      </p>
      ${headline(context)}
      ${rangePanel(context)}
      <div class="controls">${conditionsPanel(context)} ${equipmentPanel(context)} ${deliveryPanel(context)}</div>
      <div class="results">
        ${flying === "clubs" ? bagPanel(context) : flying === "golfer" ? golferPanel(context) : flightNumbers(context)}
      </div>
      ${explanation(context)}
    </div>
  `;
}
