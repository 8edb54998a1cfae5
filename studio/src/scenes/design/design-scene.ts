/** Design: a club with other numbers than its own, within the rules and within what can be built. */

import { html, type TemplateResult } from "lit-html";
import type { Context, Scene } from "../../context";
import { MASS_PROPERTIES } from "../../core/design";
import type { Wanted } from "../../core/lanes";
import { headlineDelivery } from "../models/strike-in-words";
import { deliveryPanel } from "../shot/delivery";
import { equipmentPanel } from "../shot/equipment-panel";
import { facePanel } from "../shot/face";
import "./design.css";
import { changesPanel } from "./changes";
import { clubPanel } from "./club-panel";
import { designedValue, reachOf, setups, spaceOf } from "./designed";
import { dropHandlers, filePanel } from "./file-panel";
import { headPicture } from "./head-picture";
import { inShort } from "./in-short";
import { optimumInput, optimumPanel } from "./optimum";
import { VARIABLES } from "./settings";
import { verdictPanel } from "./verdict-panel";

export const designScene: Scene = { view, wanted };

/** Shots of a golfer with each of both clubs: contact models take some hundred times as long. */
const SHOTS = { impulse: 4096, contact: 256 };

/** How long a slider must rest before a golfer's chart is computed, which takes some tenths of a second [ms]. */
const REST = 150;

function wanted(context: Context): Wanted[] {
  const both = setups(context);
  const bodies = VARIABLES.filter(({ name }) => MASS_PROPERTIES.includes(name));
  const limits: Wanted<"limits"> = {
    kind: "limits",
    input: {
      space: spaceOf(context),
      values: Object.fromEntries(bodies.map(({ name }) => [name, designedValue(context, name)])),
      ranges: Object.fromEntries(bodies.map((each) => [each.name, reachOf(context, each)])),
    },
  };
  const kind = context.description.models.find(({ name }) => name === context.state.model)?.kind ?? "impulse";
  const average: Wanted<"average"> = { kind: "average", input: { ...both, count: SHOTS[kind] }, lane: "batch" };
  const rest = both.own.golfer ? REST : 0;
  return [
    { kind: "design", input: both },
    limits,
    ...(both.own.golfer ? [average] : []),
    { kind: "optimum", input: optimumInput(context), lane: "batch", rest },
  ] as Wanted[];
}

function view(context: Context): TemplateResult {
  const { over, drop } = dropHandlers(context);
  return html`
    <div class="design" @dragover=${over} @drop=${drop}>
      ${inShort(context)}
      <div class="controls">
        <section aria-labelledby="start">
          <h2 id="start">Start from</h2>
          <p>${headlineDelivery(context)}</p>
          <details class="strike">
            <summary>Change club, ball, model or strike</summary>
            ${equipmentPanel(context)} ${deliveryPanel(context)} ${facePanel(context)}
          </details>
        </section>
        ${clubPanel(context)} ${filePanel(context)}
      </div>
      <div class="answers">
        ${headPicture(context)} ${optimumPanel(context)} ${changesPanel(context)} ${verdictPanel(context)}
      </div>
    </div>
  `;
}
