/** Learn: eight lessons, each a claim, its pictures, and a question that the sliders answer. */

import { html, nothing, type TemplateResult } from "lit-html";
import { amountSetting, type Context, choiceSetting, type Scene } from "../../context";
import { settingField } from "../../parts/field";
import { CONDITIONS } from "../../state/conditions";
import type { SettingValue } from "../../state/settings";
import { outputOf } from "../../state/store";
import { type Lesson, LessonResult, Setup, type Slider } from "./lesson";
import { LESSONS } from "./lessons";
import { LEARN_SETTINGS, LESSON_SLIDERS } from "./settings";
import "./learn.css";

export const learnScene: Scene = {
  view,
  wanted: (context) => {
    const lesson = lessonOf(context);
    const setup = new Setup(context, lesson);
    const at = Object.fromEntries(lesson.sliders.map(({ setting }) => [setting, setup.at(setting)]));
    const [steady, curves] = [lesson.steady?.(setup), lesson.curves?.(setup)];
    return [
      { kind: "lessonCases", slot: `cases of ${lesson.name}`, input: { at, cases: lesson.cases(setup) } },
      ...(steady
        ? [
            {
              kind: "lessonCases",
              slot: `steady of ${lesson.name}`,
              input: { at: {}, cases: steady },
              lane: "batch",
            } as const,
          ]
        : []),
      ...(curves
        ? [{ kind: "lessonCurves", slot: `curves of ${lesson.name}`, input: curves, lane: "batch" } as const]
        : []),
    ];
  },
};

const lessonOf = (context: Context): Lesson =>
  LESSONS.find(({ name }) => name === choiceSetting(context, "lesson")) ?? LESSONS[0];

/** Sliders as they stand when a lesson begins. */
const fresh = (): Record<string, SettingValue | null> =>
  Object.fromEntries(Object.keys(LESSON_SLIDERS).map((name) => [name, null]));

/** Opens a lesson from its beginning, and goes to its title. */
function open({ actions }: Context, { name }: Lesson): void {
  actions.change({ kind: "settings", settings: { ...fresh(), lesson: name } });
  document.querySelector<HTMLElement>("#lesson")?.focus();
}

function view(context: Context): TemplateResult {
  const lesson = lessonOf(context);
  const place = LESSONS.indexOf(lesson);
  return html`
    <div class="learn">
      ${listOf(context, lesson)}
      <article aria-labelledby="lesson">
        <h2 id="lesson" tabindex="-1">${place + 1}. ${lesson.title}</h2>
        ${lessonView(context, lesson)}
        ${steps(context, place)}
      </article>
    </div>
  `;
}

const listOf = (context: Context, lesson: Lesson): TemplateResult => html`
  <nav class="lessons" aria-label="Lessons">
    <ol>
      ${LESSONS.map(
        (each) => html`<li>
          <button
            type="button"
            aria-current=${each === lesson ? "true" : nothing}
            @click=${() => open(context, each)}
          >
            <span>${each.title}</span>
          </button>
        </li>`,
      )}
    </ol>
    <p class="remark">Each takes a minute. The golfer is right-handed, and the air still.</p>
  </nav>
`;

function steps(context: Context, place: number): TemplateResult {
  const step = (label: string, lesson: Lesson | undefined): TemplateResult =>
    html`<button type="button" ?disabled=${!lesson} @click=${() => lesson && open(context, lesson)}>${label}</button>`;
  return html`<div class="steps" role="group" aria-label="Go through the lessons">
    ${step("Previous lesson", LESSONS[place - 1])} ${step("Next lesson", LESSONS[place + 1])}
  </div>`;
}

function lessonView(context: Context, lesson: Lesson): TemplateResult {
  const results = outputOf(context.model, "lessonCases", `cases of ${lesson.name}`);
  if (!results) return html`<p aria-busy="true">The lesson is being computed …</p>`;
  const failure = Object.values(results.cases).find((each) => each.failure)?.failure;
  const curves = outputOf(context.model, "lessonCurves", `curves of ${lesson.name}`) ?? {};
  const steady = outputOf(context.model, "lessonCases", `steady of ${lesson.name}`)?.cases ?? {};
  const content = failure ? null : lesson.content(new LessonResult(context, lesson, results, curves, steady));
  return html`
    <div class="lesson">
      <section class="claim" aria-label="The claim">${content?.text ?? nothing}</section>
      <section class="exercise" aria-labelledby="question">
        <h3 id="question">Question</h3>
        <p class="question">${content?.question ?? nothing}</p>
        ${lesson.sliders.map((slider) => sliderField(context, slider))}
        <p class="so-far">${content?.now ?? html`This strike cannot be computed: ${failure?.message}.`}</p>
        <p class=${content?.isSolved ? "verdict solved" : "verdict"} role="status">
          ${content?.isSolved ? "Solved." : "Not solved yet."}
        </p>
        <details class="answer" ?open=${content?.isSolved}><summary>Show the answer</summary><p>${content?.answer ?? nothing}</p></details>
        ${takeToShot(context, lesson)}
      </section>
      <section class="drawn" aria-label="Pictures of this strike">${content?.pictures ?? nothing}</section>
      ${content?.sources ? html`<p class="remark">Published figures: ${content.sources.join("; ")}.</p>` : nothing}
    </div>
  `;
}

function sliderField(context: Context, { setting, label, range }: Slider): TemplateResult {
  const { units } = context.formatter;
  const { usual } = LEARN_SETTINGS[setting];
  const unit = typeof usual === "string" ? "1" : usual.unit;
  const [least, most] = range.map((text) => units.toSi(units.parse(text, unit)));
  return settingField(context, { name: setting, label, range: [least, most] });
}

function takeToShot(context: Context, lesson: Lesson): TemplateResult {
  const { state, actions } = context;
  const take = (): void => {
    const moved = (kind: "input" | "condition") =>
      lesson.sliders.flatMap(({ [kind]: name, setting }) =>
        name ? [[name, amountSetting(context, setting)] as const] : [],
      );
    const own = { ...LEARN_SETTINGS, ...CONDITIONS };
    const kept = Object.entries(state.settings).filter(([name]) => !Object.hasOwn(own, name));
    actions.change({
      kind: "all",
      state: {
        ...state,
        ...lesson.chosen,
        scene: "shot",
        parameters: "",
        hand: "right",
        delivery: { ...lesson.delivery, ...Object.fromEntries(moved("input")) },
        settings: Object.fromEntries([...kept, ...moved("condition")]),
      },
    });
  };
  return html`
    <div class="take">
      <button type="button" @click=${take}>Take this strike to the Shot scene</button>
      ${lesson.left ? html`<small>${lesson.left}</small>` : nothing}
    </div>
  `;
}
