import { readFileSync } from "node:fs";
import { load } from "/work/h/gold/crates/clubface-c/clubface.js";
const core = await load(readFileSync("/work/h/gold/studio/generated/clubface-fem.wasm"));
const e = JSON.parse(readFileSync("/work/h/x/elements.json"));
for (const n of ["reference","drive"]) { const t=performance.now(); const r=core.simulate(e[n].case).text; console.log(n, performance.now()-t);
 for (const [q,v] of Object.entries(e[n].values)) if (typeof r[q]==="number") console.log(q, v, r[q], Math.abs(r[q]-v)/Math.abs(v)); }
