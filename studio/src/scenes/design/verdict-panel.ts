/** What the rules of golf and mechanics say of the head: each limit with the value, and where it stands. */

import { html, type TemplateResult } from "lit-html";
import type { Context } from "../../context";
import type { Margin } from "../../core/types";
import { outputOf } from "../../state/store";
import { clubOf, type Verdict, verdicts } from "./designed";

export function verdictPanel(context: Context): TemplateResult {
  const all = verdicts(context);
  const limits = outputOf(context.model, "limits");
  const missed = limits ? limits.margins.filter(({ value }) => value < -limits.rounding) : [];
  const broken = all.filter(({ conforms }) => conforms === false);
  return html`
    <section aria-labelledby="limits">
      <h2 id="limits">Rules, and what can be built</h2>
      <p role="status" class="verdict" data-conforms=${String(!broken.length)} data-built=${limits ? String(!missed.length) : ""}>
        ${
          broken.length
            ? html`<b class="mistake">Beyond the rules</b>: ${broken.map(({ title, source }) => `${title} (${source})`).join("; ")}.`
            : html`<b>Within the rules</b>, as far as the page knows the head.`
        }
        ${limits ? built(missed) : html`<span aria-busy="true">Whether it can be built is being computed …</span>`}
      </p>
      <div class="scroll" tabindex="0" role="region" aria-label="Table of the rules">
        <table>
          <caption>Rules of golf</caption>
          <thead>
            <tr><th scope="col">Limit</th><th scope="col">Head</th><th scope="col">At most</th><th scope="col">Verdict</th></tr>
          </thead>
          <tbody>
            ${all.map((each) => ruleRow(context, each))}
          </tbody>
        </table>
      </div>
      <details>
        <summary>Sources of the rules</summary>
        <ul>
          ${all.map(({ title, source }) => html`<li>${title}: <span class="source">${source}</span></li>`)}
        </ul>
      </details>
      <details>
        <summary>What “can be built” means</summary>
        <p>
          Mass, CG and inertia must belong to mass that is nowhere negative and fits into the head (Wensing, Kim and
          Slotine, 2018). This holds for the head as a whole, and for its free mass without the shell. The shell is that of the
          original club, made evenly lighter. The box is ${clubOf(context).space.origin}. It accepts every head that fits into
          it, and it is generous where a head is round. Walls, welds and the strength of the face are not considered here;
          <code>clubface</code> designs those by finite elements.
        </p>
        ${limits ? marginTable(context, limits.margins, limits.rounding) : ""}
      </details>
    </section>
  `;
}

const built = (missed: Margin[]): TemplateResult =>
  missed.length
    ? html`<b class="mistake">It cannot be built</b>: ${worst(missed).reason}.`
    : html`<b>It can be built</b> with the free mass in the right places.`;

const worst = (margins: Margin[]): Margin => margins.reduce((one, other) => (other.value < one.value ? other : one));

function ruleRow(
  { formatter, state }: Context,
  { name, title, of, most, limit, value, conforms, source }: Verdict,
): TemplateResult {
  const text = (si: number): string => formatter.text(of, si, state.system);
  const tolerance = limit > most ? ` + ${text(limit - most)}` : "";
  const words =
    conforms === null
      ? "not known"
      : !conforms
        ? "does not conform"
        : value > most
          ? "conforms within the tolerance"
          : "conforms";
  return html`<tr data-rule=${name} data-conforms=${String(conforms)} title=${source}>
    <th scope="row">${title}</th>
    <td>${conforms === null ? "–" : text(value)}</td>
    <td>${text(most)}${tolerance}</td>
    <td class=${conforms === false ? "mistake" : ""}>${words}</td>
  </tr>`;
}

function marginTable({ formatter }: Context, margins: Margin[], rounding: number): TemplateResult {
  const names = [...new Set(margins.map(({ name }) => name))];
  return html`<table>
    <caption>Margin of each condition, as a fraction of the mass; below 0 no such head exists</caption>
    <tbody>
      ${names.map((name) => {
        const least = worst(margins.filter((each) => each.name === name));
        const isMissed = least.value < -rounding;
        return html`<tr>
          <th scope="row">${name}</th>
          <td class=${isMissed ? "mistake" : ""}>${formatter.format(isMissed ? least.value : Math.max(0, least.value), 4)}</td>
        </tr>`;
      })}
    </tbody>
  </table>`;
}
