/** What is computed: what the ball meets, friction, how long and how fine; the second case; starting and stopping. */

import { html, nothing, type TemplateResult } from "lit-html";
import type { Context } from "../../context";
import type { PublishedCase } from "../../equipment/elements";
import { settingChoice } from "../../parts/choice";
import { amountField, type Field } from "../../parts/field";
import { deliveryField, usualRange } from "../shot/delivery";
import { DELIVERY } from "../shot/words";
import { type CaseName, given, problemOf, type Setup } from "./case";
import { type Progress, type ShownCase, startCase, stopCase } from "./impacts";
import { elementCount } from "./numbers";
import { facesOf, SECOND_SAME } from "./settings";

const FACES: Record<string, string> = { club: "this club, rigid", plane: "a rigid plane" };
const faceLabel = ({ equipment }: Context, name: string): string => {
  const head = equipment.elements.heads[name];
  return head ? `${head.label}, deforms` : (FACES[name] ?? name);
};

/** The case in a few words. */
export function caseInWords(context: Context, { ball, against, friction, speed, loft }: Setup): string {
  const { formatter, state, equipment } = context;
  const text = (name: string, value: number): string => formatter.text(name, value, state.system);
  const made = equipment.balls[ball]?.label ?? ball;
  const rest = `${text("loft", loft)}, friction ${text("friction", friction)}`;
  if (against === "plane") return `Ball ${made} thrown at a plane at ${text("speed", speed)} and ${rest}`;
  const head = equipment.elements.heads[against]?.label ?? equipment.clubs[state.club].label;
  return `${head}, ball ${made}, ${text("speed", speed)}, loft ${rest}`;
}

/** What stands here of the delivery. */
export const OWN_FIELDS = ["speed", "loft"];

export function casePanel(context: Context, cases: ShownCase[]): TemplateResult {
  const { equipment } = context;
  const faces = facesOf(equipment).map((name) => [name, faceLabel(context, name)] as const);
  const [first, second] = cases;
  return html`
    <section aria-labelledby="case">
      <h2 id="case">What is computed</h2>
      <div class="choices">
        ${settingChoice(context, { name: "against", label: "The ball meets", options: faces })}
        ${settingChoice(context, {
          name: "mesh",
          label: "Mesh",
          options: [
            ["fine", "fine"],
            ["coarse", "coarse"],
          ],
        })}
        ${settingChoice(context, {
          name: "follow",
          label: "Follow it",
          options: [
            ["contact", "until it leaves"],
            ["millisecond", "for 1000 µs"],
          ],
        })}
        ${settingChoice(context, {
          name: "second",
          label: "Second case",
          options: [
            ["off", "none"],
            ["on", "side by side"],
          ],
        })}
      </div>
      ${OWN_FIELDS.map((name) => deliveryField(context, name))}
      ${frictionField(context, "friction", "Friction", first.setup, "that of the ball")}
      ${status(context, first)}
      ${second ? secondFields(context, second) : nothing}
      <p class="published">
        ${Object.entries(equipment.elements.cases).map(
          ([name, each]) => html`
            <button type="button" class="quiet" data-case=${name} @click=${() => showPublished(context, each)}>${each.label}</button>
          `,
        )}
      </p>
      <p class="remark">
        Everything else about the strike is that of the Shot scene. A head is rigid or deforms. A plane is rigid and at rest;
        loft is then the angle between the ball's path and the normal of the plane.
      </p>
    </section>
  `;
}

function secondFields(context: Context, second: ShownCase): TemplateResult {
  const { equipment } = context;
  const same: readonly [string, string] = [SECOND_SAME, "same as the first"];
  const balls = Object.keys(equipment.elements.balls).map((name) => [name, equipment.balls[name].label] as const);
  const faces = facesOf(equipment).map((name) => [name, faceLabel(context, name)] as const);
  const own = (name: string, input: string): Field => ({
    name,
    label: `${DELIVERY[input].label}, second`,
    range: usualRange(context, input),
  });
  return html`
    <h3>Second case</h3>
    <div class="choices">
      ${settingChoice(context, { name: "second_against", label: "The ball meets, second", options: [same, ...faces] })}
      ${settingChoice(context, { name: "second_ball", label: "Ball, second", options: [same, ...balls] })}
    </div>
    ${ownField(context, own("second_speed", "speed"), "speed", second.setup.speed, "same as the first")}
    ${ownField(context, own("second_loft", "loft"), "loft", second.setup.loft, "same as the first")}
    ${frictionField(context, "second_friction", "Friction, second", second.setup, "same as the first, or that of the ball")}
    ${status(context, second)}
  `;
}

/** A field of a setting for which something stands until it is given. */
function ownField(context: Context, field: Field, quantity: string, si: number, standsFor: string): TemplateResult {
  const amount = given(context, field.name);
  const { actions } = context;
  return amountField(
    context,
    { ...field, remark: amount ? undefined : standsFor },
    {
      quantity,
      amount,
      si,
      change: (next, going) => actions.change({ kind: "settings", settings: { [field.name]: next } }, going),
    },
  );
}

/** Friction that golfers find, to which the slider goes; more can be typed. */
const FRICTION = [0, 1] as const;

const frictionField = (
  context: Context,
  name: string,
  label: string,
  setup: Setup,
  standsFor: string,
): TemplateResult => ownField(context, { name, label, range: FRICTION }, "friction", setup.friction, standsFor);

function status(context: Context, shown: ShownCase): TemplateResult {
  const { name, progress } = shown;
  const going = progress.kind === "going";
  return html`
    <div class="status" data-status=${progress.kind} data-case-name=${name} data-mesh=${shown.isCurrent ? shown.mesh : ""}>
      ${
        going
          ? html`<progress max="1" .value=${progress.share ?? 0} aria-label=${`Progress of the ${CASE[name]} case`}></progress>
              <button type="button" @click=${() => stopCase(context, name)}>Stop</button>`
          : nothing
      }
      ${
        progress.kind === "stopped" || progress.kind === "failed"
          ? html`<button type="button" @click=${() => startCase(context, name)}>Compute</button>`
          : nothing
      }
      <p role=${progress.kind === "failed" || progress.kind === "impossible" ? "alert" : "status"}>
        ${inWords(context, shown, progress)}
      </p>
    </div>
  `;
}

const CASE: Record<CaseName, string> = { first: "first", second: "second" };

function inWords(context: Context, shown: ShownCase, progress: Progress): string | TemplateResult {
  const { impact, setup } = shown;
  const problem = problemOf(context, setup);
  switch (progress.kind) {
    case "impossible":
      return problem ? `This case cannot be computed: ${problem}.` : withBalls(context, shown.setup);
    case "stopped":
      return shown.isCurrent ? "Stopped: this is the coarse mesh." : "Stopped: the previous case is shown.";
    case "failed":
      return `This case cannot be computed: ${progress.why}.`;
    case "going":
      return shown.isCurrent
        ? "This is the coarse mesh; the fine one is being computed."
        : `The ${progress.mesh} mesh is being computed.`;
    default: {
      if (!impact) return "";
      const seconds = context.formatter.text("wall", impact.summary.wall, context.state.system);
      const stopped = impact.summary.stopped ? ` The run ended early: ${impact.summary.stopped}.` : "";
      const edge = impact.summary.over_edge
        ? " The ball reached the edge of the face, where contact ends, so its launch is uncertain."
        : "";
      return `${elementCount(context, shown)} elements, ${impact.summary.steps} steps in ${seconds}.${stopped}${edge}`;
    }
  }
}

/** Says that a ball has no pieces, and offers those that have. */
function withBalls({ actions, equipment }: Context, { ball }: Setup): TemplateResult {
  const label = equipment.balls[ball]?.label ?? ball;
  return html`The layers of the ball ${label} are not known, so it cannot be meshed. Choose another:
    ${Object.keys(equipment.elements.balls).map(
      (name) =>
        html`<button type="button" class="quiet" @click=${() => actions.change({ kind: "ball", ball: name })}>${equipment.balls[name].label}</button> `,
    )}`;
}

/** Shows a published case: its ball, delivery, friction and head, and nothing of the strike before. */
function showPublished(
  { state, actions, formatter }: Context,
  { ball, against, friction, delivery }: PublishedCase,
): void {
  const amounts = Object.entries(delivery).map(([name, text]) => [
    name,
    formatter.units.parse(text, formatter.quantity(name).unit),
  ]);
  const { second: _, second_ball: __, ...settings } = state.settings;
  actions.change({
    kind: "all",
    state: {
      ...state,
      ball,
      hand: "right",
      parameters: "",
      delivery: Object.fromEntries(amounts),
      settings: { ...settings, against, friction: { value: friction, unit: "1" }, follow: "millisecond" },
    },
  });
}
