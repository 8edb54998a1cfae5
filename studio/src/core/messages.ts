/** What passes between the page and its workers. */

import type { Input, Kind, Output } from "./computations";
import type { Description } from "./types";

export type Request =
  | { kind: "start"; wasm: string }
  | { kind: "compute"; slot: string; computation: Kind; input: Input<Kind> };

export type Reply =
  | { kind: "ready"; description: Description }
  | { kind: "answer"; slot: string; computation: Kind; output: Output<Kind>; milliseconds: number }
  | { kind: "progress"; slot: string; share: number }
  | { kind: "broken"; slot: string | null; message: string };
