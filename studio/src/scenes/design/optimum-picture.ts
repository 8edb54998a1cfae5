/** The picture of the optimum chart: contours, what is not allowed, the club, its original, the best one, the way up. */

import { html, nothing, svg, type TemplateResult } from "lit-html";
import type { Context } from "../../context";
import type { ChartAxis, Optimum } from "../../core/design";
import { line, scale, ticks } from "../../parts/axes";
import { areaBelow, contours, type Grid, type Place } from "../../parts/contours";
import { letterZoom } from "../../parts/measure";
import { draggedPlace } from "../../parts/pointer";
import { designedValue, ownValue } from "./designed";
import { objectiveLabel, slopesOf, variableNamed } from "./optimum";

const [LEFT, RIGHT, TOP, BOTTOM] = [56, 12, 12, 44];
const WIDEST = 720;
const SHAPE = 0.72;
const LEVELS = 9;
/** Length of the arrow that points to more [px]. */
const ARROW = 46;
/** What is read downwards: the CG below the face centre. */
const DOWNWARDS = ["cg_y"];

export function optimumPicture(context: Context, optimum: Optimum): TemplateResult {
  const { model, formatter, state, actions } = context;
  const { axes, objective, x, y, values, margins, best } = optimum;
  const zoom = letterZoom();
  const width = Math.min(WIDEST, Math.max(260, (model.widths["optimum"] ?? WIDEST) / zoom));
  const height = Math.round(width * SHAPE);
  const right = scale(axes[0].range, [LEFT, width - RIGHT]);
  const ends = [height - BOTTOM, TOP] as const;
  const up = scale(axes[1].range, DOWNWARDS.includes(axes[1].name) ? [ends[1], ends[0]] : ends);
  const grid = (numbers: ArrayLike<number>): Grid => ({ columns: x.length, rows: y.length, values: numbers });
  const at = ([column, row]: Place): [number, number] => [
    right.at(x[0] + column * (x[1] - x[0])),
    up.at(y[0] + row * (y[1] - y[0])),
  ];
  const unit = formatter.reading(objective.output, state.system).unit;
  const shown = Array.from(values, (value) => formatter.units.fromSi(value, unit));
  const finite = shown.filter(Number.isFinite);
  const levels = ticks([Math.min(...finite), Math.max(...finite)], LEVELS);
  const decimals = levels.length > 1 && levels[1] - levels[0] < 1 ? (levels[1] - levels[0] < 0.1 ? 2 : 1) : 0;
  const here = [designedValue(context, axes[0].name), designedValue(context, axes[1].name)] as const;
  const own = [ownValue(context, axes[0].name), ownValue(context, axes[1].name)] as const;
  const place = ([across, upwards]: readonly [number, number]): [number, number] => [right.at(across), up.at(upwards)];
  const [hereX, hereY] = place(here);
  const slopes = slopesOf(context, optimum);
  const isShown = (point: readonly [number, number]): boolean =>
    axes.every(({ range: [low, high] }, i) => point[i] >= low && point[i] <= high);

  const move = (point: readonly [number, number], going: string | null): void => {
    const settings = axes.map(({ name, range: [low, high] }, i) => {
      const reading = formatter.reading(name, state.system);
      const value = formatter.units.fromSi(Math.max(low, Math.min(high, point[i])), reading.unit);
      return [name, { value: Number(value.toFixed(reading.digits)), unit: reading.unit }] as const;
    });
    actions.change({ kind: "settings", settings: Object.fromEntries(settings) }, going);
  };
  const point = (event: PointerEvent): void => {
    const there = draggedPlace(event);
    if (!there) return;
    const back = (axis: ChartAxis, pixel: number, to: typeof right): number =>
      axis.range[0] + (pixel - to.at(axis.range[0])) / (to.at(1) - to.at(0));
    move([back(axes[0], there.x, right), back(axes[1], there.y, up)], "place on the chart");
  };
  const nudge = (event: KeyboardEvent): void => {
    const moves: Record<string, [number, number]> = {
      ArrowLeft: [-1, 0],
      ArrowRight: [1, 0],
      ArrowUp: [0, DOWNWARDS.includes(axes[1].name) ? -1 : 1],
      ArrowDown: [0, DOWNWARDS.includes(axes[1].name) ? 1 : -1],
    };
    const steps = moves[event.key];
    if (!steps) return;
    event.preventDefault();
    const size = axes.map(({ range: [low, high] }) => ((high - low) / 100) * (event.shiftKey ? 5 : 1));
    move([here[0] + steps[0] * size[0], here[1] + steps[1] * size[1]], null);
  };

  const label = (axis: ChartAxis): string => {
    const symbol = formatter.units.symbol(formatter.reading(axis.name, state.system).unit);
    return `${variableNamed(axis.name).label}${symbol ? `, ${symbol}` : ""}`;
  };
  const axisTicks = (axis: ChartAxis, count: number): { at: number; text: string }[] => {
    const reading = formatter.reading(axis.name, state.system);
    const range = axis.range.map((each) => formatter.units.fromSi(each, reading.unit));
    return ticks([range[0], range[1]], count).map((tick) => ({
      at: formatter.units.toSi({ value: tick, unit: reading.unit }),
      text: String(Number(tick.toFixed(6))),
    }));
  };
  const { columns } = margins;
  const allowed: Grid = { columns, rows: columns, values: margins.values.map((value) => value + margins.rounding) };
  const finer = (x.length - 1) / (columns - 1);
  const atFine = ([column, row]: Place): [number, number] => at([column * finer, row * finer]);
  const spoken =
    `${objectiveLabel(context, objective)} over ${label(axes[0])} and ${label(axes[1])}, from ` +
    `${formatter.format(Math.min(...finite), decimals)} to ${formatter.format(Math.max(...finite), decimals)} ` +
    `${formatter.units.symbol(unit)}; a click or the arrow keys move the club.`;
  return html`
    <div
      class="optimum"
      data-sized="optimum"
      role="group"
      tabindex="0"
      aria-label="Place of the club on the chart. The arrow keys move it, with Shift by more."
      @keydown=${nudge}
    >
      <svg
        class="view"
        role="img"
        aria-label=${spoken}
        width=${width * zoom}
        height=${height * zoom}
        viewBox=${`0 0 ${width} ${height}`}
        @pointerdown=${point}
        @pointermove=${point}
        @pointerup=${actions.settle}
      >
        <defs>
          <pattern id="not-built" width="7" height="7" patternUnits="userSpaceOnUse" patternTransform="rotate(45)">
            <line class="hatch" x1="0" x2="0" y1="0" y2="7"></line>
          </pattern>
          <pattern id="not-allowed" width="7" height="7" patternUnits="userSpaceOnUse" patternTransform="rotate(-45)">
            <line class="hatch rules" x1="0" x2="0" y1="0" y2="7"></line>
          </pattern>
        </defs>
        ${axisTicks(axes[0], width / 90).map(
          (
            tick,
          ) => svg`<line class="grid" x1=${right.at(tick.at)} x2=${right.at(tick.at)} y1=${TOP} y2=${height - BOTTOM}></line>
            <text class="tick" x=${right.at(tick.at)} y=${height - BOTTOM + 16} text-anchor="middle">${tick.text}</text>`,
        )}
        ${axisTicks(axes[1], height / 60).map(
          (
            tick,
          ) => svg`<line class="grid" x1=${LEFT} x2=${width - RIGHT} y1=${up.at(tick.at)} y2=${up.at(tick.at)}></line>
            <text class="tick" x=${LEFT - 6} y=${up.at(tick.at) + 4} text-anchor="end">${tick.text}</text>`,
        )}
        <text class="tick" x=${width - RIGHT} y=${height - 8} text-anchor="end">${label(axes[0])}</text>
        <text class="tick" transform=${`translate(14 ${TOP}) rotate(-90)`} text-anchor="end">${label(axes[1])}</text>
        <path class="not-built" data-area="not-built" d=${areaBelow(allowed, 0)
          .map((each) => `${line(each.map(atFine))}Z`)
          .join("")}></path>
        <path class="edge built" d=${contours(allowed, 0)
          .map((each) => line(each.map(atFine)))
          .join("")}></path>
        ${ruleAreas(optimum, right.at, up.at, [LEFT, width - RIGHT], [TOP, height - BOTTOM])}
        ${levels.map((level, i) => contourOf(grid(shown), level, at, formatter.format(level, decimals), i))}
        ${slopes && isShown(here) ? arrow(slopes, objective.sign, axes, [hereX, hereY], [right.at(1) - right.at(0), up.at(1) - up.at(0)]) : nothing}
        ${isShown(own) ? svg`<circle class="own" cx=${place(own)[0]} cy=${place(own)[1]} r="5"></circle>` : nothing}
        ${best ? svg`<path class="best" d=${star(place([best.x, best.y]), 8)}></path>` : nothing}
        ${isShown(here) ? svg`<circle class="here" data-mark="here" cx=${hereX} cy=${hereY} r="5"></circle>` : nothing}
      </svg>
      <ul class="legend">
        <li><i class="mark here"></i>you are here</li>
        <li><i class="mark own"></i>the club's own</li>
        <li><i class="mark best">★</i>best allowed</li>
        <li><i class="contour"></i>${objectiveLabel(context, objective)}, ${formatter.units.symbol(unit)}</li>
        <li><i class="swatch not-built"></i>cannot be built</li>
        ${axes.some(({ most }) => Math.abs(most) < Number.MAX_VALUE) ? html`<li><i class="swatch not-allowed"></i>beyond the rules</li>` : nothing}
      </ul>
    </div>
  `;
}

type Pixel = [number, number];

/** A line of equal value, its number near its middle. */
function contourOf(
  grid: Grid,
  level: number,
  at: (place: Place) => Pixel,
  text: string,
  number: number,
): TemplateResult {
  const lines = contours(grid, level);
  if (!lines.length) return svg`` as TemplateResult;
  const places = lines.flat();
  // Not where it would hide the numbers of the axes.
  const inner = places.filter(({ 0: x, 1: y }) => x > 0.1 * grid.columns && y > 0.1 * grid.rows);
  const free = inner.length ? inner : places;
  const [x, y] = at(free[Math.floor(free.length * (number % 2 ? 0.4 : 0.65))]);
  return svg`<path class="contour" d=${lines.map((each) => line(each.map(at))).join("")}></path>
    <text class="level" x=${x} y=${y + 4} text-anchor="middle">${text}</text>` as TemplateResult;
}

/** What lies beyond the rules for the numbers on the axes. */
function ruleAreas(
  { axes }: Optimum,
  right: (value: number) => number,
  up: (value: number) => number,
  [x1, x2]: Pixel,
  [y1, y2]: Pixel,
): TemplateResult[] {
  const isInside = ({ most, range }: ChartAxis): boolean => most > range[0] && most < range[1];
  const area = (x: number, y: number, width: number, height: number): TemplateResult =>
    svg`<rect class="not-allowed" x=${x} y=${y} width=${width} height=${height}></rect>` as TemplateResult;
  const result: TemplateResult[] = [];
  if (axes.some(({ most }) => most < -1e300)) return [area(x1, y1, x2 - x1, y2 - y1)];
  if (isInside(axes[0])) result.push(area(right(axes[0].most), y1, x2 - right(axes[0].most), y2 - y1));
  if (isInside(axes[1])) result.push(area(x1, y1, x2 - x1, up(axes[1].most) - y1));
  return result;
}

/** An arrow along the steepest way to more, in the picture. */
function arrow(slopes: Pixel, sign: number, axes: [ChartAxis, ChartAxis], from: Pixel, pixels: Pixel): TemplateResult {
  // Steepest where both axes count by their lengths in the picture.
  const [across, upwards] = slopes.map((slope, i) => (sign * slope) / pixels[i]);
  const length = Math.hypot(across, upwards);
  if (!(length > 0) || !axes.length) return svg`` as TemplateResult;
  const [dx, dy] = [(across / length) * ARROW, (upwards / length) * ARROW];
  const tip: Pixel = [from[0] + dx, from[1] + dy];
  const wing = (side: number): Pixel => [tip[0] - 0.25 * dx - side * 0.14 * dy, tip[1] - 0.25 * dy + side * 0.14 * dx];
  return svg`<path class="gradient" data-mark="gradient" d=${line([from, tip])}></path>
    <path class="gradient" d=${line([wing(1), tip, wing(-1)])}></path>` as TemplateResult;
}

function star([x, y]: Pixel, radius: number): string {
  const points = Array.from({ length: 10 }, (_, i): Pixel => {
    const [size, angle] = [i % 2 ? radius * 0.45 : radius, (i * Math.PI) / 5];
    return [x + size * Math.sin(angle), y - size * Math.cos(angle)];
  });
  return `${line(points)}Z`;
}
