/** Sizes of pictures and letters, whether motion is wanted, and the time from a moved slider to the drawn answer. */

type Observer = (widths: Record<string, number>) => void;

let observer: Observer = () => undefined;
let widths: Record<string, number> = {};
const watched = new Set<Element>();

const sizes = new ResizeObserver((entries) => {
  const before = widths;
  widths = { ...widths };
  for (const { target, contentRect } of entries) {
    const name = (target as HTMLElement).dataset.sized;
    if (name) widths[name] = Math.round(contentRect.width);
  }
  if (JSON.stringify(before) !== JSON.stringify(widths)) observer(widths);
});

/** Watches every element that carries `data-sized`. */
export function watchWidths(): void {
  for (const element of watched) {
    if (element.isConnected) continue;
    sizes.unobserve(element);
    watched.delete(element);
  }
  for (const element of document.querySelectorAll("[data-sized]")) {
    if (watched.has(element)) continue;
    watched.add(element);
    sizes.observe(element);
  }
}

/** The size of the page's letters [px]. */
export const rootSize = (): number => Number.parseFloat(getComputedStyle(document.documentElement).fontSize);

const USUAL_LETTERS = 16;

/** How much larger than usual the letters of the page are; pictures are drawn as much larger. */
export const letterZoom = (): number => rootSize() / USUAL_LETTERS;

/** Width of a picture that has not been measured yet [px]. */
export const USUAL_WIDTH = 640;

/** Whether the system asks for less motion. */
export const isMotionReduced = (): boolean => matchMedia("(prefers-reduced-motion: reduce)").matches;

const MOST_TIMES = 1000;
/** The latest times from an input event to the page that shows its answer [ms], for the browser tests. */
const times: { toDrawn: number[]; toFrame: number[] } = { toDrawn: [], toFrame: [] };

function keep(list: number[], time: number): void {
  list.push(time);
  if (list.length > MOST_TIMES) list.shift();
}

let since: number | null = null;

export const measure = {
  times,
  onWidths(next: Observer): void {
    observer = next;
  },
  /** Notes when an event came that asks for an answer. */
  asked(event: Event): void {
    since ??= event.timeStamp;
  },
  /** Notes that its answer has been drawn. */
  answered(): void {
    if (since === null) return;
    const begun = since;
    since = null;
    keep(times.toDrawn, performance.now() - begun);
    requestAnimationFrame(() => keep(times.toFrame, performance.now() - begun));
  },
};

Object.assign(globalThis, { studioTimes: times });
