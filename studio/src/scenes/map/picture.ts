/** The map on a canvas: colours within the outline, contour lines with their numbers, and what is marked. */

import { cssColour, type Palette } from "../../parts/colours";
import { inkOn, mapPalette } from "./colours";
import { contours, type Field, type Place } from "./field";
import { isOnFace, type Shown } from "./mapped";
import { bandShare, type ValueScale } from "./scales";

/** Where points of the face stand on the canvas [px]. */
export interface Layout {
  width: number;
  height: number;
  /** Pixels of the screen for one of the page's. */
  ratio: number;
  x(toe: number): number;
  y(high: number): number;
  /** The point of the face at a place of the canvas. */
  place(x: number, y: number): Place;
}

/** Room for the numbers of the axes, in letters of the page. */
const LEFT = 2.4;
const BOTTOM = 1.7;
const AROUND = 0.6;

export function layoutOf({ drawn, side }: Shown, width: number, rem: number, ratio: number): Layout {
  const [least, most] = [drawn.toe[0], drawn.toe[drawn.toe.length - 1]];
  const [low, top] = [drawn.high[0], drawn.high[drawn.high.length - 1]];
  const [left, right] = [LEFT * rem, width - AROUND * rem];
  const scale = (right - left) / (most - least);
  const height = Math.round((top - low) * scale + (BOTTOM + AROUND) * rem);
  const centre = (left + right) / 2 - (side * (least + most) * scale) / 2;
  const ground = height - BOTTOM * rem + low * scale;
  return {
    width,
    height,
    ratio,
    x: (toe) => centre + side * toe * scale,
    y: (high) => ground - high * scale,
    place: (x, y) => [(side * (x - centre)) / scale, (ground - y) / scale],
  };
}

/** Colours of the page. */
export interface Ink {
  ink: string;
  line: string;
  faint: string;
  accent: string;
  card: string;
  isDark: boolean;
}

export interface Drawing {
  shown: Shown;
  scale: ValueScale;
  layout: Layout;
  ink: Ink;
  style: string;
  /** Size of letters [px]. */
  rem: number;
  /** A level as text. */
  text(level: number): string;
}

export function drawMap(canvas: HTMLCanvasElement, drawing: Drawing): void {
  const { layout, shown, ink } = drawing;
  canvas.width = Math.round(layout.width * layout.ratio);
  canvas.height = Math.round(layout.height * layout.ratio);
  const pen = canvas.getContext("2d");
  if (!pen) return;
  pen.scale(layout.ratio, layout.ratio);
  const palette = mapPalette(shown.isDiverging, ink.isDark);
  axes(pen, drawing);
  pen.save();
  for (const corners of shown.outlines) {
    trace(pen, layout, corners);
    pen.clip();
  }
  pen.drawImage(colours(drawing, palette), 0, 0, layout.width, layout.height);
  pen.restore();
  lines(pen, drawing, palette);
  pen.strokeStyle = ink.ink;
  pen.lineWidth = 1.5;
  for (const corners of shown.outlines) {
    trace(pen, layout, corners);
    pen.closePath();
    pen.stroke();
  }
}

export function trace(pen: CanvasRenderingContext2D, { x, y }: Layout, places: readonly Place[]): void {
  pen.beginPath();
  for (const [toe, high] of places) pen.lineTo(x(toe), y(high));
}

/** A picture of the box around the face, a pixel of the screen each. */
function colours({ shown, scale, layout, style }: Drawing, palette: Palette): HTMLCanvasElement {
  const picture = document.createElement("canvas");
  picture.width = Math.round(layout.width * layout.ratio);
  picture.height = Math.round(layout.height * layout.ratio);
  const pen = picture.getContext("2d");
  if (!pen) return picture;
  const image = pen.createImageData(picture.width, picture.height);
  const { toe, high, values } = shown.drawn;
  const [columns, rows] = [toe.length, high.length];
  const bands = scale.levels;
  for (let row = 0; row < picture.height; row += 1) {
    const up = layout.place(0, (row + 0.5) / layout.ratio)[1];
    const y = ((up - high[0]) / (high[rows - 1] - high[0])) * (rows - 1);
    if (y < 0 || y > rows - 1) continue;
    const below = Math.min(rows - 2, Math.floor(y));
    for (let column = 0; column < picture.width; column += 1) {
      const across = layout.place((column + 0.5) / layout.ratio, 0)[0];
      const x = ((across - toe[0]) / (toe[columns - 1] - toe[0])) * (columns - 1);
      if (x < 0 || x > columns - 1) continue;
      const left = Math.min(columns - 2, Math.floor(x));
      const at = below * columns + left;
      const [u, v] = [x - left, y - below];
      const lower = values[at] + u * (values[at + 1] - values[at]);
      const upper = values[at + columns] + u * (values[at + columns + 1] - values[at + columns]);
      const si = lower + v * (upper - lower);
      if (Number.isNaN(si)) continue;
      const value = scale.fromSi(si);
      const share = style === "bands" ? bandShare(scale, bands, value) : scale.share(value);
      const [red, green, blue] = palette(share);
      image.data.set([red, green, blue, 255], 4 * (row * picture.width + column));
    }
  }
  pen.putImageData(image, 0, 0);
  return picture;
}

/** Contour lines, each with its number where it is long enough. */
function lines(pen: CanvasRenderingContext2D, drawing: Drawing, palette: Palette): void {
  const { shown, scale, layout, rem, text } = drawing;
  const drawn: Field = { ...shown.drawn, values: Float64Array.from(shown.drawn.values, scale.fromSi) };
  const labels: [number, number][] = [];
  pen.font = `${0.72 * rem}px system-ui, sans-serif`;
  pen.textAlign = "center";
  pen.textBaseline = "middle";
  for (const level of scale.levels) {
    const colour = palette(scale.share(level));
    for (const line of contours(drawn, level))
      for (const part of insideParts(shown, line)) {
        pen.strokeStyle = inkOn(colour);
        pen.globalAlpha = 0.75;
        pen.lineWidth = level === 0 ? 2 : 1;
        trace(pen, layout, part);
        pen.stroke();
        pen.globalAlpha = 1;
        label(pen, drawing, part, text(level), cssColour(colour), inkOn(colour), labels);
      }
  }
}

/** The parts of a line on the face. */
function insideParts({ outlines }: Shown, line: readonly Place[]): Place[][] {
  const parts: Place[][] = [[]];
  for (const place of line)
    if (isOnFace(outlines, place)) parts[parts.length - 1].push(place);
    else if (parts[parts.length - 1].length) parts.push([]);
  return parts.filter((part) => part.length > 1);
}

function label(
  pen: CanvasRenderingContext2D,
  { layout, rem }: Drawing,
  part: readonly Place[],
  text: string,
  colour: string,
  ink: string,
  taken: [number, number][],
): void {
  const points = part.map(([toe, high]) => [layout.x(toe), layout.y(high)] as const);
  const width = pen.measureText(text).width;
  const reach = points.reduce(
    (sum, [x, y], i) => sum + (i ? Math.hypot(x - points[i - 1][0], y - points[i - 1][1]) : 0),
    0,
  );
  if (reach < 2 * width) return;
  // From the middle of the line outwards, the first place that is free.
  for (const share of [0.5, 0.35, 0.65, 0.2, 0.8]) {
    const at = Math.round(share * (points.length - 1));
    const [x, y] = points[at];
    if (taken.some(([u, v]) => Math.hypot(x - u, y - v) < width + 0.8 * rem)) continue;
    if (x - width / 2 < LEFT * rem || x + width / 2 > layout.width - AROUND * rem) continue;
    const [before, after] = [points[Math.max(0, at - 2)], points[Math.min(points.length - 1, at + 2)]];
    let angle = Math.atan2(after[1] - before[1], after[0] - before[0]);
    if (Math.abs(angle) > Math.PI / 2) angle -= Math.sign(angle) * Math.PI;
    pen.save();
    pen.translate(x, y);
    pen.rotate(angle);
    pen.lineWidth = 4;
    pen.lineJoin = "round";
    pen.strokeStyle = colour;
    pen.strokeText(text, 0, 0);
    pen.fillStyle = ink;
    pen.fillText(text, 0, 0);
    pen.restore();
    taken.push([x, y]);
    return;
  }
}

/** Lines 10 mm apart, and their numbers. */
function axes(pen: CanvasRenderingContext2D, { layout, ink, rem, shown }: Drawing): void {
  const { toe, high } = shown.drawn;
  const [left, right] = [LEFT * rem, layout.width - AROUND * rem];
  const [above, below] = [layout.y(high[high.length - 1]), layout.y(high[0])];
  pen.font = `${0.72 * rem}px system-ui, sans-serif`;
  pen.fillStyle = ink.faint;
  pen.strokeStyle = ink.line;
  pen.lineWidth = 1;
  const each = Math.abs(layout.x(0.01) - layout.x(0)) < 1.8 * rem ? 20 : 10;
  const places = (from: number, to: number): number[] => {
    const first = Math.ceil((Math.min(from, to) * 1e3) / each - 1e-9);
    const last = Math.floor((Math.max(from, to) * 1e3) / each + 1e-9);
    return Array.from({ length: last - first + 1 }, (_, i) => (first + i) * each);
  };
  pen.textAlign = "center";
  pen.textBaseline = "top";
  for (const millimetres of places(toe[0], toe[toe.length - 1])) {
    const x = layout.x(millimetres / 1e3);
    segment(pen, [x, above], [x, below]);
    pen.fillText(String(Math.abs(millimetres)), x, below + 0.35 * rem);
  }
  pen.textAlign = "right";
  pen.textBaseline = "middle";
  for (const millimetres of places(high[0], high[high.length - 1])) {
    const y = layout.y(millimetres / 1e3);
    segment(pen, [left, y], [right, y]);
    pen.fillText(String(Math.abs(millimetres)), left - 0.4 * rem, y);
  }
}

function segment(pen: CanvasRenderingContext2D, from: [number, number], to: [number, number]): void {
  pen.beginPath();
  pen.moveTo(...from);
  pen.lineTo(...to);
  pen.stroke();
}
