/** The pictures of the impact as one image, and as a video. */

import { html, type TemplateResult } from "lit-html";
import type { Context } from "../../context";
import { choiceSetting } from "../../context";
import { handSign } from "../../equipment/equipment";
import type { ColourScale } from "../../parts/colours";
import { download } from "../../parts/download";
import { colourReader } from "../../parts/page-colours";
import { join } from "../../quantities/formatter";
import { caseInWords } from "./case-panel";
import { type DrawnCase, SHAPE_COLOURS, scales } from "./drawn-case";
import { TRACTIONS } from "./patch";
import { patchCanvas, TITLES } from "./patch-pictures";
import { isPlaying, startPlaying } from "./player";

/** Sizes of the sheet [px]. */
const COLUMN = 800;
const MARGIN = 20;
const STAGE = 480;
const MAP = 300;
const LINE = 26;
const HEIGHT = 4 * LINE + STAGE + 3 * LINE + MAP + 3 * LINE + MARGIN;
const FRAMES_PER_SECOND = 30;
const VIDEO_TYPES = ["video/webm;codecs=vp9", "video/webm;codecs=vp8", "video/webm"];
const RECORDING = "elements-recording";

interface Legend {
  title: string;
  quantity: string;
  scale: ColourScale;
}

/** Draws a sheet from what the page shows. */
type Draw = (canvas: HTMLCanvasElement) => void;
let draw: Draw = () => undefined;

/** Keeps what a sheet is drawn from; called when the page has been drawn. */
export function keepSheet(context: Context, cases: DrawnCase[]): void {
  draw = (canvas) => drawSheet(canvas, context, cases);
}

export function exportButtons(context: Context, cases: DrawnCase[]): TemplateResult {
  const isRecording = context.model.transient[RECORDING] === "yes";
  const canRecord = videoType() !== undefined;
  return html`
    <div class="exports">
      <button type="button" @click=${savePicture}>Picture (PNG)</button>
      <button type="button" ?disabled=${isRecording || !canRecord} @click=${() => void saveVideo(context, cases[0])}>
        ${isRecording ? "The video is being recorded …" : "Video (WebM)"}
      </button>
      ${canRecord ? "" : html`<small>This browser cannot record a video.</small>`}
    </div>
  `;
}

const videoType = (): string | undefined =>
  typeof MediaRecorder === "undefined" ? undefined : VIDEO_TYPES.find((type) => MediaRecorder.isTypeSupported(type));

function savePicture(): void {
  const canvas = document.createElement("canvas");
  draw(canvas);
  canvas.toBlob((blob) => blob && download(blob, "impact.png"), "image/png");
}

/** Plays the impact from its start and records it. */
async function saveVideo(context: Context, shown: DrawnCase): Promise<void> {
  const canvas = document.createElement("canvas");
  draw(canvas);
  const recorder = new MediaRecorder(canvas.captureStream(FRAMES_PER_SECOND), { mimeType: videoType() });
  const parts: Blob[] = [];
  recorder.ondataavailable = ({ data }) => parts.push(data);
  const ended = new Promise<void>((resolve) => {
    recorder.onstop = () => resolve();
  });
  recorder.start();
  let hasBegun = false;
  const record = (): void => {
    draw(canvas);
    const playing = document.querySelector("[data-playing]") !== null;
    hasBegun ||= playing;
    if (hasBegun && !playing) recorder.stop();
    else requestAnimationFrame(record);
  };
  context.actions.keep({ [RECORDING]: "yes" });
  startPlaying(context, shown.impact, true);
  requestAnimationFrame(record);
  await ended;
  context.actions.keep({ [RECORDING]: "" });
  download(new Blob(parts, { type: "video/webm" }), "impact.webm");
}

/** Marks the page while it plays, which ends a recording with it. */
export const playingMark = (context: Context): TemplateResult | string =>
  isPlaying(context) ? html`<span data-playing hidden></span>` : "";

function drawSheet(canvas: HTMLCanvasElement, context: Context, cases: DrawnCase[]): void {
  const width = COLUMN * cases.length;
  if (canvas.width !== width || canvas.height !== HEIGHT) [canvas.width, canvas.height] = [width, HEIGHT];
  const pen = canvas.getContext("2d");
  if (!pen) return;
  const colour = colourReader(document.body);
  pen.fillStyle = colour("--card");
  pen.fillRect(0, 0, canvas.width, canvas.height);
  pen.fillStyle = colour("--ink");
  const { formatter, state } = context;
  const { shape, patch } = scales(context, cases);
  const write = (text: string, x: number, y: number, size = 18, weight = 400): void => {
    pen.font = `${weight} ${size}px system-ui, sans-serif`;
    pen.fillText(text, x, y, COLUMN - 2 * MARGIN);
  };
  const legend = ({ title, quantity, scale }: Legend, x: number, y: number, long: number): void => {
    const { unit, digits } = formatter.reading(quantity, state.system);
    const fill = pen.createLinearGradient(x, 0, x + long, 0);
    for (let i = 0; i <= 16; i += 1) {
      const value = scale.least + (i / 16) * (scale.most - scale.least);
      fill.addColorStop(i / 16, `rgb(${scale.at(value).join(" ")})`);
    }
    const text = (value: number): string =>
      join(formatter.format(formatter.units.fromSi(value, unit), digits), formatter.units.symbol(unit));
    write(`${title}: ${text(scale.least)} to ${text(scale.most)}`, x, y + 16, 16);
    pen.save();
    pen.fillStyle = fill;
    pen.fillRect(x, y + 24, long, 12);
    pen.restore();
  };
  cases.forEach((each, i) => {
    const left = i * COLUMN + MARGIN;
    let y = LINE + 6;
    write(caseInWords(context, each.setup), left, y, 17, 600);
    y += LINE;
    write(`${formatter.text("contact_time", each.moment, state.system)} after first touch`, left, y);
    y += LINE / 2;
    const stage = document.querySelector<HTMLCanvasElement>(`[data-stage="elements-${each.name}"] canvas`);
    if (stage) drawFitted(pen, stage, left, y, COLUMN - 2 * MARGIN, STAGE);
    y += STAGE + 6;
    const [quantity, title] = SHAPE_COLOURS[choiceSetting(context, "colour")] ?? [];
    if (quantity) legend({ title, quantity, scale: shape }, left, y, COLUMN - 2 * MARGIN);
    y += 2 * LINE;
    TRACTIONS.forEach((name, k) => {
      const x = left + k * (COLUMN / 2 - MARGIN / 2);
      const map = patchCanvas(each.name, name);
      if (map) drawFitted(pen, map, x, y, MAP, MAP);
      legend({ title: TITLES[name], quantity: "stress", scale: patch[name] }, x, y + MAP + 6, MAP);
    });
    const toe = handSign(state) > 0 ? "right" : "left";
    write(`The face from behind, its toe on the ${toe}; lines 5 mm apart`, left, y + MAP + 3 * LINE, 16);
  });
}

/** Draws an image as large as it fits into a rectangle, in its middle. */
function drawFitted(
  pen: CanvasRenderingContext2D,
  image: HTMLCanvasElement,
  x: number,
  y: number,
  width: number,
  height: number,
): void {
  const scale = Math.min(width / image.width, height / image.height);
  const [w, h] = [image.width * scale, image.height * scale];
  pen.drawImage(image, x + (width - w) / 2, y + (height - h) / 2, w, h);
}
