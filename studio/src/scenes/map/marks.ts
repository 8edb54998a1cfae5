/** What is marked on the map: the face's centre, the sweet spot, the impact point, where impacts scatter, the cursor. */

import { type Context, delivered, settingSi } from "../../context";
import { cursorOf } from "./cursor";
import { contours, type Place } from "./field";
import { detailedMaps, isOnFace, type Shown } from "./mapped";
import { type Ink, type Layout, trace } from "./picture";

/** Standard deviations of the ellipses. */
export const ELLIPSES = [1, 2];

/** How much wider the line beneath a line is [px]. */
const HALO = 2;

/** The share of impacts that an ellipse of so many standard deviations holds. */
export const shareWithin = (deviations: number): number => 1 - Math.exp(-(deviations ** 2) / 2);

export interface Marks {
  impact: Place;
  sweetSpot: Place | null;
  /** Ball speed of the first club at which its effective face ends [m/s]. */
  edge: number | null;
  deviations: Place;
  cursor: Place | null;
}

export function marksOf(context: Context): Marks {
  const details = detailedMaps(context, "map");
  const best = details?.faces[0].summary.best.ball_speed;
  return {
    impact: [delivered(context, "toe"), delivered(context, "high")],
    sweetSpot: best ? [best.toe, best.high] : null,
    edge: best ? best.value * context.equipment.face_map.share : null,
    deviations: [settingSi(context, "strikes_toe"), settingSi(context, "strikes_high")],
    cursor: cursorOf(context),
  };
}

/** Draws them; each line has a lighter one beneath it, so that it is seen on every colour. */
export function drawMarks(pen: CanvasRenderingContext2D, shown: Shown, layout: Layout, marks: Marks, ink: Ink): void {
  const { x, y } = layout;
  const size = Math.max(4, layout.width / 110);
  /** A pixel where the map is as wide as usual. */
  const pixel = Math.max(1, layout.width / 640);
  const stroke = (draw: () => void, width: number, dashes: number[] = [], colour = ink.ink): void => {
    for (const [style, thick, dash] of [
      [ink.card, width + HALO, []],
      [colour, width, dashes],
    ] as const) {
      pen.strokeStyle = style;
      pen.lineWidth = thick * pixel;
      pen.setLineDash(dash.map((each) => each * pixel));
      draw();
    }
    pen.setLineDash([]);
  };
  const cross = ([toe, high]: Place, reach: number): void => {
    pen.beginPath();
    pen.moveTo(x(toe) - reach, y(high));
    pen.lineTo(x(toe) + reach, y(high));
    pen.moveTo(x(toe), y(high) - reach);
    pen.lineTo(x(toe), y(high) + reach);
    pen.stroke();
  };
  pen.save();
  for (const corners of shown.outlines) {
    trace(pen, layout, corners);
    pen.clip();
  }
  if (marks.edge !== null) {
    const { edge } = marks;
    for (const line of contours(shown.speed, edge))
      stroke(
        () => {
          trace(pen, layout, line);
          pen.stroke();
        },
        1.5,
        [7, 4],
      );
  }
  const scale = Math.abs(x(1) - x(0));
  for (const times of ELLIPSES)
    stroke(
      () => {
        const [across, up] = marks.deviations.map((each) => each * times * scale);
        pen.beginPath();
        pen.ellipse(x(marks.impact[0]), y(marks.impact[1]), across, up, 0, 0, 2 * Math.PI);
        pen.stroke();
      },
      1.25,
      [3, 3],
      ink.accent,
    );
  pen.restore();
  stroke(() => cross([0, 0], 1.2 * size), 1.5);
  if (marks.sweetSpot) {
    const [toe, high] = marks.sweetSpot;
    stroke(() => {
      pen.beginPath();
      pen.arc(x(toe), y(high), size, 0, 2 * Math.PI);
      pen.stroke();
    }, 2);
  }
  const [toe, high] = marks.impact;
  pen.beginPath();
  pen.arc(x(toe), y(high), size, 0, 2 * Math.PI);
  pen.fillStyle = ink.accent;
  pen.fill();
  pen.strokeStyle = ink.card;
  pen.lineWidth = 2 * pixel;
  pen.stroke();
  if (marks.cursor && isOnFace(shown.outlines, marks.cursor)) {
    const { cursor } = marks;
    stroke(() => cross(cursor, 2.2 * size), 1);
  }
}
