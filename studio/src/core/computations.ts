/** What the workers compute: a new computation is a function of the core and its input, and one line here. */

import type { LoadedCore } from "clubface-core";
import { compareModels, computeFlight, computeShot, computeSlopes } from "./compute";
import { computeContributions } from "./contributions";
import { computeAverage, computeDesign, computeLimits, computeOptimum } from "./design";
import { simulateElements } from "./elements";
import { mapFaces } from "./face-map";
import { computeLessonCases, computeLessonCurves } from "./lessons";
import { computeAir, computeBag, computeDispersion } from "./range";

/** Takes the share that is done of a computation that takes long. */
export type Report = (share: number) => void;

export const COMPUTATIONS = {
  shot: computeShot,
  slopes: computeSlopes,
  flight: computeFlight,
  contributions: computeContributions,
  comparison: compareModels,
  elements: simulateElements,
  lessonCases: computeLessonCases,
  lessonCurves: computeLessonCurves,
  bag: computeBag,
  dispersion: computeDispersion,
  air: computeAir,
  faceMap: mapFaces,
  design: computeDesign,
  limits: computeLimits,
  average: computeAverage,
  optimum: computeOptimum,
};

export type Kind = keyof typeof COMPUTATIONS;
export type Input<K extends Kind> = Parameters<(typeof COMPUTATIONS)[K]>[1];
export type Output<K extends Kind> = ReturnType<(typeof COMPUTATIONS)[K]>;

type Computation = (core: LoadedCore, input: Input<Kind>, report: Report) => Output<Kind>;

/** Computes one of them; `input` is that of the same kind. */
export const compute = (core: LoadedCore, kind: Kind, input: Input<Kind>, report: Report): Output<Kind> =>
  (COMPUTATIONS[kind] as unknown as Computation)(core, input, report);
