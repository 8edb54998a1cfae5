/** Undo and redo. While a slider is moved, all its values are one step. */

export interface Timeline<T> {
  past: readonly T[];
  present: T;
  future: readonly T[];
  /** Name of the change that is still going on, whose next value replaces the last; null where none is. */
  going: string | null;
}

const MOST_STEPS = 200;

export const begin = <T>(present: T): Timeline<T> => ({ past: [], present, future: [], going: null });

/** Adds a step; `going` names a change whose values are one step until one comes that is not going. */
export function step<T>(timeline: Timeline<T>, present: T, going: string | null = null): Timeline<T> {
  if (going !== null && timeline.going === going) return { ...timeline, present, future: [] };
  const past = [...timeline.past, timeline.present].slice(-MOST_STEPS);
  return { past, present, future: [], going };
}

/** Ends a change that was going on. */
export const settle = <T>(timeline: Timeline<T>): Timeline<T> => ({ ...timeline, going: null });

export function undo<T>({ past, present, future, going }: Timeline<T>): Timeline<T> {
  if (!past.length) return { past, present, future, going };
  return { past: past.slice(0, -1), present: past[past.length - 1], future: [present, ...future], going: null };
}

export function redo<T>({ past, present, future, going }: Timeline<T>): Timeline<T> {
  if (!future.length) return { past, present, future, going };
  return { past: [...past, present], present: future[0], future: future.slice(1), going: null };
}
