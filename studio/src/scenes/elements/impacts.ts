/** Which impacts the scene wants computed, and which it can show. */

import { type Context, choiceSetting } from "../../context";
import { caseKey, type ElementsCase, type ElementsImpact } from "../../core/elements";
import type { LaneName, Wanted } from "../../core/lanes";
import type { Strike } from "../../core/types";
import { MESHES, type MeshName } from "../../equipment/elements";
import { outputOf, type Result } from "../../state/store";
import { ballOf, CASES, type CaseName, caseOf, type Setup, setupOf, strikeAgainst } from "./case";

/** How long a slider rests before its case is computed [ms]. */
const REST = 700;
const LANES: Record<CaseName, LaneName> = { first: "elements", second: "other-elements" };

const slotOf = (name: CaseName, mesh: MeshName): string => `elements-${name}-${mesh}`;
/** The shot of the chosen reduced model, to compare with. */
export const modelSlot = (name: CaseName): string => `model-${name}`;
export const flightSlot = (name: CaseName): string => `elements-${name}-flight`;

/** The cases that are shown, one or two. */
export const casesOf = (context: Context): CaseName[] =>
  CASES.filter((name) => name === "first" || choiceSetting(context, "second") === "on");

/** The meshes that are computed, one after the other. */
const meshesOf = (context: Context): MeshName[] =>
  MESHES.filter((mesh) => mesh === "coarse" || choiceSetting(context, "mesh") === "fine");

/** What a flight takes of a strike. */
const flown = ({ inputs, flight }: Strike): Pick<Strike, "inputs" | "flight"> => ({ inputs, flight });

/** A case by its text, for what is kept of it for the moment. */
const textOf = (input: ElementsCase | null): string => (input ? caseKey(input) : "");

export function wantedImpacts(context: Context): Wanted[] {
  const { transient } = context.model;
  return casesOf(context).flatMap((name) => {
    const setup = setupOf(context, name);
    const inputs = meshesOf(context).map((mesh) => ({ mesh, input: caseOf(context, setup, mesh) }));
    const quick: Wanted[] =
      setup.against === "plane"
        ? []
        : [{ kind: "shot", input: strikeAgainst(context, setup), slot: modelSlot(name), lane: "page" }];
    const struck = strikeAgainst(context, setup, ballOf(context, setup)?.meshes.fine.columns);
    const { impact } = shownCase(context, name);
    if (impact?.launch.ball_speed !== undefined)
      quick.push({
        kind: "flight",
        input: { ...flown(struck), launch: impact.launch },
        slot: flightSlot(name),
        lane: "page",
      });
    const last = textOf(inputs[inputs.length - 1].input);
    if (transient[`stopped-${name}`] === last) return quick;
    const rest = transient[`at-once-${name}`] === last ? 0 : REST;
    const impacts = inputs.flatMap(({ mesh, input }): Wanted[] =>
      input ? [{ kind: "elements", input, slot: slotOf(name, mesh), lane: LANES[name], rest }] : [],
    );
    return [...quick, ...impacts];
  });
}

/** How far the computation of a case has come. */
export type Progress =
  | { kind: "impossible" }
  | { kind: "stopped" }
  | { kind: "failed"; why: string }
  /** `share` is null until the first report. */
  | { kind: "going"; mesh: MeshName; share: number | null }
  | { kind: "done" };

export interface ShownCase {
  name: CaseName;
  setup: Setup;
  progress: Progress;
  /** The finest impact that there is of the case, or the last one of another. */
  impact: ElementsImpact | null;
  mesh: MeshName;
  /** Whether the impact is that of the present case. */
  isCurrent: boolean;
  /** Time that it took, with all around it [ms]. */
  milliseconds: number;
}

export function shownCase(context: Context, name: CaseName): ShownCase {
  const { model } = context;
  const setup = setupOf(context, name);
  const all = MESHES.map((mesh) => {
    const slot = slotOf(name, mesh);
    const key = textOf(caseOf(context, setup, mesh));
    const impact = outputOf(model, "elements", slot);
    const result: Result | undefined = model.results[slot];
    return { mesh, key, impact, result, isCurrent: impact?.key === key && !result?.failure };
  }).reverse();
  const current = all.find(({ isCurrent }) => isCurrent);
  const shown = current ?? all.find(({ impact }) => impact) ?? all[0];
  return {
    name,
    setup,
    progress: progressOf(context, name, all),
    impact: shown.impact,
    mesh: shown.mesh,
    isCurrent: shown.isCurrent,
    milliseconds: shown.result?.milliseconds ?? 0,
  };
}

function progressOf(
  context: Context,
  name: CaseName,
  all: { mesh: MeshName; key: string; result: Result | undefined; isCurrent: boolean }[],
): Progress {
  const asked = all.filter(({ mesh }) => meshesOf(context).includes(mesh));
  const [last] = asked;
  if (!last.key) return { kind: "impossible" };
  if (last.isCurrent) return { kind: "done" };
  if (context.model.transient[`stopped-${name}`] === last.key) return { kind: "stopped" };
  const failure = asked.find(({ result }) => result?.failure)?.result?.failure;
  if (failure) return { kind: "failed", why: failure };
  const next = [...asked].reverse().find(({ isCurrent }) => !isCurrent) ?? last;
  return { kind: "going", mesh: next.mesh, share: next.result?.share ?? null };
}

/** Ends the computation of a case, until the case is another or it is started again. */
export const stopCase = (context: Context, name: CaseName): void =>
  context.actions.keep({ [`stopped-${name}`]: lastText(context, name), [`at-once-${name}`]: "" });

/** Computes a case without waiting. */
export const startCase = (context: Context, name: CaseName): void =>
  context.actions.keep({ [`stopped-${name}`]: "", [`at-once-${name}`]: lastText(context, name) });

function lastText(context: Context, name: CaseName): string {
  const meshes = meshesOf(context);
  return textOf(caseOf(context, setupOf(context, name), meshes[meshes.length - 1]));
}
