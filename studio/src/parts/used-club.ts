/** A line that says in every scene that shots are struck with the club as it was designed, and with which numbers. */

import { html, nothing, type TemplateResult } from "lit-html";
import type { Context } from "../context";
import { clubName } from "../equipment/names";
import { HEAD, usedNumbers } from "../state/used-club";

/** Strikes with the designed club in every scene, or with the club's own numbers again. */
export const useClub = ({ actions }: Context, head: string | null): void =>
  actions.change({ kind: "settings", settings: { [HEAD]: head } });

export function usedClubLine(context: Context): TemplateResult | typeof nothing {
  const { formatter, state, equipment } = context;
  const numbers = Object.entries(usedNumbers(context));
  if (!numbers.length) return nothing;
  const words = numbers.map(
    ([name, si]) => `${formatter.quantity(name).label} ${formatter.text(name, si, state.system)}`,
  );
  const loft = usedNumbers(context).static_loft;
  const more = loft === undefined ? 0 : loft - (equipment.clubs[state.club].columns.static_loft ?? loft);
  return html`
    <aside class="conditions" aria-label="Designed club">
      <span>
        Struck with the <b>${clubName(context, state.club)} as designed</b>: ${words.join(", ")}${
          more
            ? `; dynamic loft ${formatter.difference("loft", more, state.system, { hasSides: false })} to that of the slider`
            : nothing
        }.
      </span>
      <button type="button" class="quiet" @click=${() => useClub(context, null)}>Use the club's own numbers</button>
    </aside>
  `;
}
