/** Wind, air and ground of all flights: what is not as usual in words, for the head of every scene. */

import { html, nothing, type TemplateResult } from "lit-html";
import { type Context, choiceSetting, settingSi } from "../context";
import { CONDITIONS, type Condition, givenConditions } from "../state/conditions";

/** Within this of the target line or of the direction across it a wind has a plain name [rad]. */
const NEAR = 1e-3;

/** The wind as a golfer says it: "headwind 10 mph", "wind 10 mph from 45° right of the target". */
export function windInWords(context: Context): string {
  const { formatter, state } = context;
  const speed = settingSi(context, "wind");
  if (!speed) return "no wind";
  const from = settingSi(context, "wind_from");
  const blowing = formatter.text("wind_speed", speed, state.system);
  const [along, across] = [Math.cos(from), Math.sin(from)];
  const [headwind, tailwind] = formatter.quantity("wind_x").sides ?? ["", ""];
  const [left, right] = formatter.quantity("wind_from").sides ?? ["", ""];
  if (Math.abs(across) < NEAR) return `${along > 0 ? headwind : tailwind} ${blowing}`;
  if (Math.abs(along) < NEAR) return `wind ${blowing} from the ${across > 0 ? right : left}`;
  return `wind ${blowing} from ${formatter.text("wind_from", Math.atan2(across, along), state.system)} of the target`;
}

/** What is not as usual, in one sentence without its full stop; "" where all is. */
export function conditionsInWords(context: Context): string {
  const { formatter, state } = context;
  const given = givenConditions(state);
  const text = (name: Condition): string => formatter.text(name, settingSi(context, name), state.system);
  const words: Record<Condition, () => string> = {
    wind: () => windInWords(context),
    wind_from: () => "",
    altitude: () => (given.includes("pressure") ? "" : `altitude ${text("altitude")}`),
    temperature: () => text("temperature"),
    humidity: () => `humidity ${text("humidity")}`,
    pressure: () => text("pressure"),
    ground: () => `ground: ${choiceSetting(context, "ground")}`,
  };
  return given
    .map((name) => words[name]())
    .filter(Boolean)
    .join(", ");
}

/** All conditions as usual again. */
export const usualConditions = ({ actions }: Context): void =>
  actions.change({
    kind: "settings",
    settings: Object.fromEntries(Object.keys(CONDITIONS).map((name) => [name, null])),
  });

/** A line that says in every scene what its flights fly in, where that is not as usual. */
export function conditionsLine(context: Context): TemplateResult | typeof nothing {
  const words = conditionsInWords(context);
  if (!words) return nothing;
  return html`
    <aside class="conditions" aria-label="Conditions of the flight">
      <span>Flights in <b>${words}</b></span>
      <button type="button" class="quiet" @click=${() => usualConditions(context)}>Usual conditions</button>
    </aside>
  `;
}
