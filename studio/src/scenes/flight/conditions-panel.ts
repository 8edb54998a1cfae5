/** Wind, air and ground, by sliders and by typing. */

import { html, type TemplateResult } from "lit-html";
import { type Context, settingSi } from "../../context";
import { settingChoice } from "../../parts/choice";
import { windInWords } from "../../parts/conditions";
import { type Field, settingField } from "../../parts/field";
import { CONDITIONS, type Condition } from "../../state/conditions";
import { outputOf } from "../../state/store";

/** Names, and ends of the sliders as people give them. */
const FIELDS: Record<Exclude<Condition, "ground">, [label: string, least: string, most: string]> = {
  wind: ["Wind speed", "0 mph", "40 mph"],
  wind_from: ["Wind from", "-180 deg", "180 deg"],
  altitude: ["Altitude", "0 m", "3000 m"],
  temperature: ["Temperature", "-5 degC", "45 degC"],
  humidity: ["Humidity", "0 %", "100 %"],
  pressure: ["Air pressure", "650 hPa", "1060 hPa"],
};

export function conditionsPanel(context: Context): TemplateResult {
  const { state, equipment, formatter } = context;
  const { units } = formatter;
  const isPressureGiven = Object.hasOwn(state.settings, "pressure");
  const field = (name: keyof typeof FIELDS, remark?: string): TemplateResult => {
    const [label, ...ends] = FIELDS[name];
    const usual = CONDITIONS[name].kind === "amount" ? CONDITIONS[name].usual.unit : "";
    const [least, most] = ends.map((text) => units.toSi(units.parse(text, usual)));
    const whole: Field = { name, label, range: [least, most], ...(remark ? { remark } : {}) };
    return settingField(context, whole);
  };
  return html`
    <section aria-labelledby="conditions">
      <h2 id="conditions">Wind, air and ground</h2>
      <div class="wind">${compass(context)}<div>${field("wind")} ${field("wind_from")}</div></div>
      ${field("altitude", isPressureGiven ? "not used, because a pressure is given" : undefined)}
      ${field("temperature")} ${field("humidity")}
      <details ?open=${isPressureGiven}>
        <summary>A measured pressure instead of the altitude</summary>
        ${field("pressure")}
      </details>
      ${settingChoice(context, {
        name: "ground",
        label: "Ground",
        options: Object.keys(equipment.grounds).map((name) => [name, name]),
      })}
      <p class="remark">${airInWords(context)}</p>
    </section>
  `;
}

/** Pressure and density, which follow from the rest. */
function airInWords({ model, state, formatter }: Context): TemplateResult {
  const air = outputOf(model, "air");
  const text = (name: string): string => (air ? formatter.text(name, air[name], state.system) : "…");
  return html`Pressure <span data-air="pressure">${text("pressure")}</span>, density of the air
    <span data-air="density">${text("air_density")}</span>. These conditions apply in every scene.`;
}

/** The wind as an arrow seen from above: the target is up. */
function compass(context: Context): TemplateResult {
  const degrees = (settingSi(context, "wind_from") * 180) / Math.PI;
  const isStill = settingSi(context, "wind") === 0;
  return html`
    <svg class=${isStill ? "compass still" : "compass"} viewBox="-50 -50 100 100" role="img" aria-label=${`Seen from above: ${windInWords(context)}`}>
      <circle class="grid" r="46" fill="none"></circle>
      <path class="target" d="M0 30V-30"></path>
      <text y="-32" text-anchor="middle">target</text>
      <g transform=${`rotate(${degrees})`}>
        <path class="blowing" d="M0 -24V16M-8 6L0 20L8 6"></path>
      </g>
    </svg>
  `;
}
