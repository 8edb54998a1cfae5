/** The numbers of the club on sliders, each with the parts that the rules allow and that can be built. */

import { html, nothing, type TemplateResult } from "lit-html";
import { type Context, choiceSetting } from "../../context";
import { MASS_PROPERTIES } from "../../core/design";
import { type Band, clubField } from "../../parts/field";
import { useClub } from "../../parts/used-club";
import { outputOf } from "../../state/store";
import { DESIGNED, HEAD } from "../../state/used-club";
import { changedNames, clubOf, designedValue, given, ownValue, reachOf, verdicts } from "./designed";
import { CG, FACE, INERTIA, OUTLINE, PRODUCTS, SPACE, type Variable } from "./settings";

export function clubPanel(context: Context): TemplateResult {
  const { actions } = context;
  const changed = changedNames(context);
  const isUsed = choiceSetting(context, HEAD) === DESIGNED;
  const fields = (variables: Variable[]): TemplateResult[] => variables.map((each) => field(context, each));
  const back = (): void =>
    actions.change({
      kind: "settings",
      settings: { ...Object.fromEntries(changed.map((name) => [name, null])), [HEAD]: null },
    });
  const isOpen = (variables: Variable[]): boolean => variables.some(({ name }) => changed.includes(name));
  const known = SPACE.filter(({ name }) => Number.isFinite(ownValue(context, name)));
  return html`
    <section aria-labelledby="numbers-of-club">
      <h2 id="numbers-of-club">The club</h2>
      <p class="buttons">
        <button
          type="button"
          aria-pressed=${isUsed}
          ?disabled=${!isUsed && !changed.length}
          @click=${() => useClub(context, isUsed ? null : DESIGNED)}
        >
          Use this club
        </button>
        <button type="button" ?disabled=${!changed.length} @click=${back}>Back to the club</button>
      </p>
      <p class="remark">
        ${isUsed ? "All scenes use this club and follow its sliders." : "“Use this club” uses it in all scenes."}
      </p>
      <ul class="legend" aria-label="Lines below the sliders">
        <li><i class="band rules"></i>within the rules</li>
        <li><i class="band built"></i>can be built, with everything else unchanged</li>
      </ul>
      <h3>Centre of gravity</h3>
      ${fields(CG)}
      <h3>Mass, loft and face</h3>
      ${fields(FACE)}
      <h3>Moments of inertia</h3>
      ${fields(INERTIA)}
      <details ?open=${isOpen(PRODUCTS)}>
        <summary>Products of inertia</summary>
        ${fields(PRODUCTS)}
      </details>
      <details ?open=${isOpen(OUTLINE)}>
        <summary>Outline of the face</summary>
        <p class="remark">It only decides which shots miss the face. No rule limits it.</p>
        ${fields(OUTLINE)}
      </details>
      <details ?open=${isOpen(SPACE)}>
        <summary>Space of the head</summary>
        <p class="remark">
          Where mass can be placed: ${clubOf(context).space.origin}. The head is a shell, and its free mass can lie anywhere in this space.
        </p>
        ${fields(known)}
      </details>
    </section>
  `;
}

function field(context: Context, variable: Variable): TemplateResult {
  const { formatter, state } = context;
  const { name, label } = variable;
  const own = ownValue(context, name);
  const text = (si: number): string => (si === Infinity ? "flat" : formatter.text(name, si, state.system));
  const broken = verdicts(context).find(({ of, conforms }) => of === name && conforms === false);
  return clubField(
    context,
    {
      name,
      label,
      range: reachOf(context, variable),
      remark: given(context, name) ? `The club's own: ${text(own)}` : own === Infinity ? "flat" : undefined,
      broken: broken && `Beyond the rules: ${broken.title} at most ${text(broken.limit)}. ${broken.source}`,
      bands: bandsOf(context, variable),
    },
    own,
  );
}

function bandsOf(context: Context, variable: Variable): Band[] {
  const { formatter, state, model } = context;
  const { name, label } = variable;
  const [least] = reachOf(context, variable);
  const text = (si: number): string => formatter.text(name, si, state.system);
  const bands: Band[] = verdicts(context)
    .filter(({ of }) => of === name)
    .map(({ limit, most, title, source }) => ({
      kind: "rules",
      words: `Within the rules up to ${text(limit)}${limit > most ? ` with the tolerance, ${text(most)} without` : ""}: ${title}. ${source}`,
      parts: limit > least ? [[least, limit]] : [],
    }));
  const allowed = MASS_PROPERTIES.includes(name) ? outputOf(model, "limits")?.allowed[name] : undefined;
  if (!allowed) return bands;
  const parts = allowed.map(([from, to]) => `${text(from)} to ${text(to)}`).join(" and ");
  const words = parts ? `${label}: can be built from ${parts}` : `${label}: no value can be built`;
  return [...bands, { kind: "built", words, parts: allowed }];
}

/** Whether a heavier head is swung slower, and what that means for this one. */
export function speedRemark(context: Context): TemplateResult | typeof nothing {
  const { formatter, state } = context;
  if (!given(context, "club_mass") || choiceSetting(context, "heavier") === "same") return nothing;
  const mass = (name: "designed" | "own"): number =>
    name === "own" ? ownValue(context, "club_mass") : designedValue(context, "club_mass");
  const word = mass("designed") > mass("own") ? "slower" : "faster";
  const text = formatter.text("club_mass", mass("designed"), state.system);
  return html`<p class="remark">
    A head of ${text} is swung ${word}: speed falls with mass to the power ${context.equipment.speed_exponent}
    (MacKenzie, Ryan and Rice, 2015).
  </p>`;
}
