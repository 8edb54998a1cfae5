/** What passes between the page and its workers. */

import type { Input, Kind, Output } from "./computations";

export type Request =
  /** The core as a file, or as what the page has compiled of it. */
  | { kind: "start"; wasm: string | WebAssembly.Module }
  | { kind: "compute"; slot: string; computation: Kind; input: Input<Kind> };

export type Reply =
  | { kind: "ready" }
  | { kind: "answer"; slot: string; computation: Kind; output: Output<Kind>; milliseconds: number }
  | { kind: "progress"; slot: string; share: number }
  | { kind: "broken"; slot: string | null; message: string };
