/** The frame of every scene: title, scenes, undo, units, theme; and notices. */

import { html, nothing, type TemplateResult } from "lit-html";
import type { Context, Scene } from "./context";
import { choiceOf } from "./parts/choice";
import { conditionsLine } from "./parts/conditions";
import { usedClubLine } from "./parts/used-club";
import { SCENES } from "./scenes/scenes";
import { THEMES } from "./state/state";

/** `scene` is what is shown, null while it is loaded. */
export function app(context: Context, scene: Scene | null): TemplateResult {
  const { hasOwnShots = false } = SCENES.find(({ name }) => name === context.state.scene) ?? {};
  return html`
    <a class="skip" href="#main" @click=${skip}>Skip to the shot</a>
    ${header(context)} ${conditionsLine(context)} ${hasOwnShots ? nothing : usedClubLine(context)} ${notices(context)}
    <main id="main" tabindex="-1">${scene ? scene.view(context) : html`<p aria-busy="true">The scene is loading …</p>`}</main>
    <footer>
      <p>
        clubface ${context.equipment.version}. The address of this page holds the shot and everything you chose: copy it to share or keep
        it.
      </p>
    </footer>
  `;
}

/** Goes to the main part without touching the address, which holds the shot. */
function skip(event: Event): void {
  event.preventDefault();
  document.querySelector<HTMLElement>("#main")?.focus();
}

function header({ state, model, actions }: Context): TemplateResult {
  const { past, future } = model.timeline;
  return html`
    <header>
      <h1>clubface <span>studio</span></h1>
      <nav aria-label="Scenes">
        ${SCENES.map(
          ({ name, title }) => html`
            <button
              type="button"
              aria-current=${state.scene === name ? "page" : nothing}
              @click=${() => actions.change({ kind: "scene", scene: name })}
            >
              ${title}
            </button>
          `,
        )}
      </nav>
      <div class="tools">
        <button type="button" ?disabled=${!past.length} @click=${actions.undo} title="Ctrl+Z">Undo</button>
        <button type="button" ?disabled=${!future.length} @click=${actions.redo} title="Ctrl+Shift+Z">Redo</button>
        ${choiceOf({
          name: "units",
          label: "Units",
          value: state.system,
          options: [
            ["golf", "mph, yd"],
            ["metric", "m/s, m"],
          ],
          choose: (system) => actions.change({ kind: "system", system }),
        })}
        ${choiceOf({
          name: "theme",
          label: "Theme",
          value: state.theme,
          options: THEMES.map((theme) => [theme, theme]),
          choose: (theme) => actions.change({ kind: "theme", theme }),
        })}
        <button type="button" @click=${() => print()}>Print</button>
      </div>
    </header>
  `;
}

function notices({ model, actions }: Context): TemplateResult {
  return html`<div class="notices" role="status">
    ${
      model.notices.length
        ? html`${model.notices.map((notice) => html`<p>${notice}</p>`)}
            <button type="button" @click=${actions.dismiss}>Close</button>`
        : nothing
    }
  </div>`;
}
