/** Club, ball, model and hand. */

import { html, nothing, type TemplateResult } from "lit-html";
import type { Context } from "../../context";
import { chosenSet, HANDS, setNames } from "../../equipment/equipment";
import { setName } from "../../equipment/names";
import { choiceOf } from "../../parts/choice";

const labels = (entries: Record<string, { label: string }>): [name: string, label: string][] =>
  Object.entries(entries).map(([name, { label }]) => [name, label]);

export function equipmentPanel(context: Context): TemplateResult {
  const { state, equipment, description, actions } = context;
  const set = chosenSet(equipment, state);
  const names = setNames(equipment, state);
  const model = description.models.find(({ name }) => name === state.model);
  return html`
    <section aria-labelledby="equipment">
      <h2 id="equipment">Club and ball</h2>
      <div class="choices">
        ${choiceOf({
          name: "club",
          label: "Club",
          value: state.club,
          options: labels(equipment.clubs),
          choose: (club) => actions.change({ kind: "club", club }),
        })}
        ${choiceOf({
          name: "hand",
          label: "Hand",
          value: state.hand,
          options: HANDS.map((hand) => [hand, hand]),
          choose: (hand) => actions.change({ kind: "hand", hand }),
        })}
        ${choiceOf({
          name: "ball",
          label: "Ball",
          value: state.ball,
          options: labels(equipment.balls),
          choose: (ball) => actions.change({ kind: "ball", ball }),
        })}
        ${choiceOf({
          name: "model",
          label: "Model",
          value: state.model,
          options: description.models.map(({ name, title }) => [name, title]),
          choose: (name) => actions.change({ kind: "model", model: name }),
        })}
        ${
          names.length > 1
            ? choiceOf({
                name: "parameters",
                label: "Parameters",
                value: state.parameters,
                options: names.map((name) => [name, setName(context, name)]),
                choose: (parameters) => actions.change({ kind: "parameters", parameters }),
              })
            : nothing
        }
      </div>
      <details>
        <summary>About this club, ball and model</summary>
        <p>${equipment.clubs[state.club].description}.</p>
        <p>${equipment.balls[state.ball].description}.</p>
        <p>${model?.title}: ${model?.summary} Source: ${model?.reference}.</p>
        <p>Parameters: ${set.label}, ${set.source}.</p>
        ${set.caveats.length ? html`<ul>${set.caveats.map((caveat) => html`<li>${caveat}</li>`)}</ul>` : nothing}
      </details>
    </section>
  `;
}
