/** How long a saved file stays in memory: some browsers read it only after they have asked where it goes [ms]. */
const KEPT = 60e3;

/** Saves a file by the browser. */
export function download(blob: Blob, name: string): void {
  const link = document.createElement("a");
  link.href = URL.createObjectURL(blob);
  link.download = name;
  link.click();
  setTimeout(() => URL.revokeObjectURL(link.href), KEPT);
}
