/** The face with the impact point: a click or the arrow keys move it. */

import { html, svg, type TemplateResult } from "lit-html";
import { type Context, delivered, outlineOf } from "../../context";
import { handSign } from "../../equipment/equipment";
import { draggedPlace } from "../../parts/pointer";
import type { Amount } from "../../quantities/units";
import { usedNumbers } from "../../state/used-club";
import { deliveryField } from "./delivery";

/** Space around the face in the drawing [mm]. */
const MARGIN = 6;
/** Radius of the drawn mark [mm]: the patch of a ball pressed against the face. */
const MARK = 5;
const MILLIMETRE = 1e-3;
const ARROWS: Record<string, [number, number]> = {
  ArrowLeft: [-1, 0],
  ArrowRight: [1, 0],
  ArrowUp: [0, 1],
  ArrowDown: [0, -1],
};

export function facePanel(context: Context): TemplateResult {
  const { state, equipment, formatter, actions } = context;
  const club = equipment.clubs[state.club];
  const used = usedNumbers(context);
  const [width, height] = ["face_width", "face_height"].map((name) => used[name] ?? club.columns[name] ?? 0);
  // Seen through the head, from behind: the toe is on the right of a right-handed club.
  const side = handSign(state);
  const [across, up] = [width / 2 / MILLIMETRE + MARGIN, height / 2 / MILLIMETRE + MARGIN];
  const corners = outlineOf(context)
    .map(([toe, high]) => `${(side * toe) / MILLIMETRE},${-high / MILLIMETRE}`)
    .join(" ");
  const [toe, high] = [delivered(context, "toe"), delivered(context, "high")];

  const within = (value: number, limit: number): number => Math.max(-limit, Math.min(limit, value));
  const move = (toeThere: number, highThere: number, going: string | null): void => {
    const amount = (value: number, limit: number): Amount => ({
      value: Number((within(value, limit) / MILLIMETRE).toFixed(1)),
      unit: "mm",
    });
    const amounts = { toe: amount(toeThere, width / 2), high: amount(highThere, height / 2) };
    actions.change({ kind: "delivery", amounts }, going);
  };
  const point = (event: PointerEvent): void => {
    const there = draggedPlace(event);
    if (there) move(side * there.x * MILLIMETRE, -there.y * MILLIMETRE, "impact point");
  };
  const nudge = (event: KeyboardEvent): void => {
    const arrow = ARROWS[event.key];
    if (!arrow) return;
    event.preventDefault();
    const size = (event.shiftKey ? 5 : 1) * MILLIMETRE;
    move(toe + side * arrow[0] * size, high + arrow[1] * size, null);
  };

  const place = `${formatter.text("toe", toe, state.system)}, ${formatter.text("high", high, state.system)}`;
  return html`
    <section aria-labelledby="impact-point">
      <h2 id="impact-point">Impact point</h2>
      <div
        class="face"
        role="group"
        tabindex="0"
        aria-label=${`Impact point on the face: ${place}. The arrow keys move it by 1 mm, with Shift by 5 mm.`}
        @keydown=${nudge}
      >
        <svg
          viewBox=${`${-across} ${-up} ${2 * across} ${2 * up}`}
          role="img"
          aria-label=${`The face seen from behind, struck at ${place}`}
          @pointerdown=${point}
          @pointermove=${point}
          @pointerup=${actions.settle}
        >
          <polygon class="outline" points=${corners}></polygon>
          ${[-20, -10, 0, 10, 20].map(
            (at) => svg`<line class="grid" x1=${at} x2=${at} y1=${-up + MARGIN} y2=${up - MARGIN}></line>`,
          )}
          ${[-20, -10, 0, 10, 20]
            .filter((at) => Math.abs(at) < up - MARGIN)
            .map(
              (at) => svg`<line class="grid" y1=${at} y2=${at} x1=${-across + MARGIN} x2=${across - MARGIN}></line>`,
            )}
          <circle class="impact" cx=${(side * toe) / MILLIMETRE} cy=${-high / MILLIMETRE} r=${MARK}></circle>
          <circle class="centre" r="0.9"></circle>
        </svg>
        <p class="ends" aria-hidden="true">
          <span>${side < 0 ? "toe" : "heel"}</span><span>lines 10 mm apart</span><span>${side < 0 ? "heel" : "toe"}</span>
        </p>
      </div>
      ${deliveryField(context, "toe", [-width / 2, width / 2])} ${deliveryField(context, "high", [-height / 2, height / 2])}
    </section>
  `;
}
