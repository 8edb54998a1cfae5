/** What colours and marks of the map stand for. */

import { html, svg, type TemplateResult } from "lit-html";
import { type Context, choiceSetting } from "../../context";
import { cssColour } from "../../parts/colours";
import { rootSize, USUAL_WIDTH } from "../../parts/measure";
import { mapPalette } from "./colours";
import type { Shown } from "./mapped";
import { ELLIPSES, shareWithin } from "./marks";
import { bandShare, levelDigits, valueScale } from "./scales";

/** Room for the number of a level, in letters of the page. */
const LETTERS = 2.2;

/** The colours and the numbers they stand for. */
export function colourLegend(context: Context, shown: Shown): TemplateResult {
  const { formatter } = context;
  const scale = valueScale(context, shown);
  const palette = mapPalette(shown.isDiverging, isDark());
  const isBands = choiceSetting(context, "map_style") === "bands";
  const edges = isBands
    ? [scale.ends[0], ...scale.levels, scale.ends[1]]
    : Array.from({ length: 65 }, (_, i) => scale.ends[0] + (i / 64) * (scale.ends[1] - scale.ends[0]));
  const digits = levelDigits(scale.levels);
  const unit = formatter.units.symbol(scale.unit);
  const sides = legendSides(context, shown);
  const room = (context.model.widths.map ?? USUAL_WIDTH) / (LETTERS * rootSize());
  const every = Math.max(1, Math.ceil(scale.levels.length / Math.max(1, room)));
  // Those that are left out do not include 0.
  const first = Math.max(0, scale.levels.indexOf(0)) % every;
  return html`
    <div class="colours" aria-hidden="true">
      <svg viewBox="0 0 100 4" preserveAspectRatio="none">
        ${edges.slice(1).map((edge, i) => {
          const from = 100 * scale.share(edges[i]);
          const share = isBands
            ? bandShare(scale, scale.levels, (edge + edges[i]) / 2)
            : scale.share((edge + edges[i]) / 2);
          return svg`<rect x=${from} width=${100 * scale.share(edge) - from + 0.1} height="4" fill=${cssColour(palette(share))}></rect>`;
        })}
      </svg>
      <div class="levels">
        ${scale.levels
          .filter((_, i) => i % every === first)
          .map(
            (level) =>
              html`<span style=${`left: ${(100 * scale.share(level)).toFixed(2)}%`}>${levelText(context, shown, level, digits)}</span>`,
          )}
      </div>
      <p class="ends"><span>${sides[0]}</span><span>${formatter.quantity(shown.name).label}${unit ? `, ${unit}` : ""}</span><span>${sides[1]}</span></p>
    </div>
  `;
}

function legendSides({ formatter }: Context, { name, isDifference, isDiverging }: Shown): readonly [string, string] {
  const { sides } = formatter.quantity(name);
  if (sides?.[0] === "left") return sides;
  if (isDifference) return ["less", "more"];
  return (isDiverging && sides) || ["", ""];
}

/** A level as it is printed: without its sign where the two sides have names. */
export function levelText({ formatter }: Context, shown: Shown, level: number, digits: number): string {
  if (shown.isDifference) return `${level > 0 ? "+" : ""}${formatter.format(level, digits)}`;
  return formatter.format(shown.isDiverging ? Math.abs(level) : level, digits);
}

export function marksLegend(): TemplateResult {
  const shares = ELLIPSES.map((each) => `${(100 * shareWithin(each)).toFixed(0)}%`).join(" and ");
  return html`
    <ul class="legend" aria-label="Marks on the map">
      <li><i class="impact"></i>impact point</li>
      <li><i class="sweet-spot"></i>sweet spot: the greatest ball speed</li>
      <li><i class="centre"></i>centre of the face</li>
      <li><i class="effective"></i>effective face</li>
      <li><i class="scatter"></i>${shares} of your impacts</li>
    </ul>
  `;
}

/** Whether the page is dark now, by the theme or by the system. */
export function isDark(): boolean {
  const { theme } = document.documentElement.dataset;
  return theme === "dark" || (theme !== "light" && matchMedia("(prefers-color-scheme: dark)").matches);
}
