/** Forces, spin, compression and energies over time, of one case or of two on each other. */

import type { Context } from "../../context";
import type { ElementsImpact } from "../../core/elements";
import type { Chart } from "../../parts/chart";
import type { CaseName } from "./case";
import { radiusOf } from "./shape-fields";

export interface ChartCase {
  name: CaseName;
  label: string;
  impact: ElementsImpact;
}

type Line = Chart["lines"][number];

interface Drawn {
  name: string;
  title: string;
  quantity: string;
  line(impact: ElementsImpact): Omit<Line, "label">;
}

const history = (impact: ElementsImpact, group: string, name: string): Omit<Line, "label"> => ({
  x: impact.arrays[`${group}.time`].values,
  y: impact.arrays[`${group}.${name}`].values,
});

const DRAWN: Drawn[] = [
  { name: "normal", title: "Normal force", quantity: "normal", line: (impact) => history(impact, "contact", "normal") },
  {
    name: "tangential",
    title: "Friction along the face",
    quantity: "tangential",
    line: (impact) => history(impact, "contact", "tangential"),
  },
  {
    name: "spin",
    title: "Backspin",
    quantity: "backspin",
    line: (impact) => {
      const { x, y } = history(impact, "motion", "spin");
      return { x, y: Float64Array.from(x, (_, i) => y[3 * i + 2]) };
    },
  },
  {
    name: "compression",
    title: "Compression (share of the radius)",
    quantity: "contraction",
    line: (impact) => {
      const { x, y } = history(impact, "motion", "radius");
      const radius = radiusOf(impact);
      return { x, y: Float64Array.from(y, (distance) => Math.max(0, 1 - distance / radius)) };
    },
  },
];

/** Energies that are drawn, with the names that the core has for what they are. */
const ENERGIES: [name: string, quantity: string][] = [
  ["kinetic", "kinetic"],
  ["strain", "strain_energy"],
  ["viscous", "viscous"],
  ["friction", "friction_energy"],
  ["hourglass", "hourglass"],
];
/** All that add up to the energy that there was. */
const SUMMED = ["kinetic", "strain", "viscous", "friction", "hourglass", "plastic", "contact", "damping"];

/** What each energy has changed by since first touch, and all of them together, which is the error of the balance. */
function energyLines({ formatter }: Context, impact: ElementsImpact): Line[] {
  const time = impact.arrays["energy.time"].values;
  const since = (name: string): Float64Array => {
    const { values } = impact.arrays[`energy.${name}`];
    return values.map((value) => value - values[0]);
  };
  const all = SUMMED.map(since);
  const sum = time.map((_, i) => all.reduce((total, each) => total + each[i], 0));
  return [
    ...ENERGIES.map(([name, quantity]) => ({ label: formatter.quantity(quantity).label, x: time, y: since(name) })),
    { label: "sum of all", x: time, y: sum },
  ];
}

let made: { key: readonly unknown[]; charts: Chart[] } = { key: [], charts: [] };

/** The charts; their arrays are the same objects while the impacts are. */
export function elementCharts(context: Context, cases: ChartCase[], mark: number): Chart[] {
  const key = cases.flatMap(({ label, impact }) => [label, impact]);
  if (key.length !== made.key.length || key.some((each, i) => each !== made.key[i])) {
    const x = { label: "time", quantity: "contact_time" };
    const charts: Chart[] = DRAWN.map(({ name, title, quantity, line }) => ({
      name: `elements-${name}`,
      title,
      x,
      y: { label: title, quantity },
      lines: cases.map(({ label, impact }) => ({ label, ...line(impact) })),
    }));
    for (const { name, label, impact } of cases)
      charts.push({
        name: `elements-energy-${name}`,
        title: cases.length > 1 ? `Energies since first touch, ${label}` : "Energies since first touch",
        x,
        y: { label: "Change", quantity: "kinetic" },
        lines: energyLines(context, impact),
      });
    made = { key, charts };
  }
  return made.charts.map((chart) => ({ ...chart, mark }));
}
