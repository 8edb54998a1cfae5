/** The map: its canvas, the value under the cursor, its colours in numbers; a press makes the shot strike there. */

import { html, type TemplateResult } from "lit-html";
import { type Context, choiceSetting } from "../../context";
import { settingChoice } from "../../parts/choice";
import { rootSize, USUAL_WIDTH } from "../../parts/measure";
import { colourReader } from "../../parts/page-colours";
import { cursorOf, pointAt } from "./cursor";
import type { Place } from "./field";
import { colourLegend, isDark, levelText, marksLegend } from "./legend";
import { mapTable } from "./map-table";
import { clubsOf, isOnFace, type Shown, shownAt, shownMap } from "./mapped";
import { drawMarks, marksOf } from "./marks";
import { type Drawing, drawMap, type Ink, type Layout, layoutOf } from "./picture";
import { levelDigits, placeInWords, titleOf, valueInWords, valueScale } from "./scales";
import { NO_CLUB, STYLES } from "./settings";

const MILLIMETRE = 1e-3;
const ARROWS: Record<string, Place> = { ArrowLeft: [-1, 0], ArrowRight: [1, 0], ArrowUp: [0, 1], ArrowDown: [0, -1] };

export function mapPanel(context: Context): TemplateResult {
  const { equipment, formatter, state } = context;
  const shown = shownMap(context);
  const title = titleOf(context, choiceSetting(context, "map"), clubsOf(context));
  return html`
    <section class="map" aria-labelledby="map">
      <h2 id="map">${title.charAt(0).toUpperCase()}${title.slice(1)}</h2>
      <div class="choices">
        ${settingChoice(context, {
          name: "map",
          label: "Quantity",
          options: equipment.face_map.quantities.map((name) => [name, formatter.quantity(name).label]),
        })}
        ${settingChoice(context, {
          name: "map_minus",
          label: "Minus the map of",
          options: [
            [NO_CLUB, "no other club"],
            ...Object.entries(equipment.clubs)
              .filter(([name]) => name !== state.club)
              .map(([name, { label }]) => [name, label] as const),
          ],
        })}
        ${settingChoice(context, { name: "map_style", label: "Colours", options: STYLES })}
      </div>
      ${shown ? mapOf(context, shown, title) : html`<p aria-busy="true">The face is being struck everywhere …</p>`}
    </section>
  `;
}

function mapOf(context: Context, shown: Shown, title: string): TemplateResult {
  const { actions, model } = context;
  const at = cursorOf(context) ?? marksOf(context).impact;
  const [left, right] = shown.side < 0 ? ["toe", "heel"] : ["heel", "toe"];
  const strike = ([toe, high]: Place, going: string | null): void => {
    const amount = (value: number): { value: number; unit: string } => ({
      value: Number((value / MILLIMETRE).toFixed(1)),
      unit: "mm",
    });
    actions.change({ kind: "delivery", amounts: { toe: amount(toe), high: amount(high) } }, going);
  };
  const point = (event: PointerEvent): void => {
    const canvas = event.currentTarget as HTMLCanvasElement;
    const box = canvas.getBoundingClientRect();
    const layout = layoutNow(context, shown);
    const there = layout.place(
      ((event.clientX - box.left) * layout.width) / box.width,
      ((event.clientY - box.top) * layout.height) / box.height,
    );
    const place = isOnFace(shown.outlines, there) ? there : null;
    pointAt(context, place);
    if (event.type === "pointerdown") canvas.setPointerCapture(event.pointerId);
    if (place && (event.type === "pointerdown" || canvas.hasPointerCapture(event.pointerId)))
      strike(place, "impact point");
  };
  const press = (event: KeyboardEvent): void => {
    const arrow = ARROWS[event.key];
    if (arrow) {
      event.preventDefault();
      const step = (event.shiftKey ? 5 : 1) * MILLIMETRE;
      const there: Place = [at[0] + shown.side * arrow[0] * step, at[1] + arrow[1] * step];
      if (isOnFace(shown.outlines, there)) pointAt(context, there);
    } else if (event.key === "Enter" || event.key === " ") {
      event.preventDefault();
      strike(at, null);
    } else if (event.key === "Escape") pointAt(context, null);
  };
  return html`
    <div
      class="canvas"
      role="group"
      tabindex="0"
      aria-label="Map of the face. The arrow keys move the cursor by 1 mm, with Shift by 5 mm; Enter strikes there."
      data-sized="map"
      data-milliseconds=${["map-first", "map", "map-forgiveness", "map-area"].map((slot) => model.results[slot]?.milliseconds ?? 0).join(" ")}
      @keydown=${press}
    >
      <canvas
        role="img"
        aria-label=${spoken(context, shown, title)}
        data-points=${`${shown.maps.toe.length}x${shown.maps.high.length}`}
        @pointerdown=${point}
        @pointermove=${point}
        @pointerup=${actions.settle}
        @pointerleave=${() => pointAt(context, null)}
      ></canvas>
    </div>
    <p class="ends" aria-hidden="true"><span>${left}</span><span>mm from the centre of the face</span><span>${right}</span></p>
    ${colourLegend(context, shown)}
    <p class="reading" role="status" data-value=${String(shownAt(shown, at))}>
      ${cursorOf(context) ? "Cursor" : "Impact point"}, ${placeInWords(context, at)}:
      <b>${valueInWords(context, shown, shownAt(shown, at))}</b>
    </p>
    ${marksLegend()} ${mapTable(context)}
  `;
}

/** What the map shows, for who does not see it. */
function spoken(context: Context, shown: Shown, title: string): string {
  const [least, most] = shown.range.map((value) => valueInWords(context, shown, value));
  const { sweetSpot, impact } = marksOf(context);
  const at = (place: Place): string =>
    `${placeInWords(context, place)}: ${valueInWords(context, shown, shownAt(shown, place))}`;
  const parts = [`from ${least} to ${most}`, `at the impact point, ${at(impact)}`];
  if (sweetSpot) parts.push(`at the sweet spot, ${at(sweetSpot)}`);
  return `Map of the face. ${title}: ${parts.join("; ")}.`;
}

function layoutNow({ model }: Context, shown: Shown): Layout {
  const width = Math.max(240, model.widths.map ?? USUAL_WIDTH);
  return layoutOf(shown, width, rootSize(), Math.min(2, devicePixelRatio));
}

let base: { inputs: readonly unknown[]; picture: HTMLCanvasElement } | null = null;

/** Draws the map anew where something has changed; what is marked, every time. */
export function setMap(context: Context): void {
  const canvas = document.querySelector<HTMLCanvasElement>(".map canvas");
  const shown = shownMap(context);
  if (!canvas || !shown) return;
  const layout = layoutNow(context, shown);
  const colour = colourReader(canvas);
  const ink: Ink = {
    ink: colour("--ink"),
    line: colour("--line"),
    faint: colour("--faint"),
    accent: colour("--accent"),
    card: colour("--card"),
    isDark: isDark(),
  };
  const scale = valueScale(context, shown);
  const digits = levelDigits(scale.levels);
  const drawing: Drawing = {
    shown,
    scale,
    layout,
    ink,
    style: choiceSetting(context, "map_style"),
    rem: rootSize(),
    text: (level) => levelText(context, shown, level, digits),
  };
  const inputs = [shown, layout.width, layout.ratio, drawing.rem, drawing.style, scale.unit, ...Object.values(ink)];
  if (!base || inputs.some((input, i) => input !== base?.inputs[i])) {
    base ??= { inputs, picture: document.createElement("canvas") };
    base.inputs = inputs;
    drawMap(base.picture, drawing);
  }
  const { picture } = base;
  if (canvas.width !== picture.width) canvas.width = picture.width;
  if (canvas.height !== picture.height) canvas.height = picture.height;
  const pen = canvas.getContext("2d");
  if (!pen) return;
  pen.setTransform(1, 0, 0, 1, 0, 0);
  pen.clearRect(0, 0, picture.width, picture.height);
  pen.drawImage(picture, 0, 0);
  pen.scale(layout.ratio, layout.ratio);
  drawMarks(pen, shown, layout, marksOf(context), ink);
}
