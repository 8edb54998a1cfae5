import { readFileSync } from "node:fs";
import { fileURLToPath } from "node:url";
import { defineConfig, type Plugin } from "vite";
import { offline } from "./build/offline.ts";

const path = (name: string): string => fileURLToPath(new URL(name, import.meta.url));

/** Entries that are built as one script each, with the core within: browsers load neither modules nor cores from files. */
const SCRIPTS: Record<string, string> = { "from-file": "src/main.ts", live: "src/live.ts" };

/** Puts the worker into the script, too, and the page of the live picture next to its script. */
const withWorker = (name: string): Plugin => ({
  name: "clubface-one-script",
  enforce: "pre",
  resolveId(source, importer) {
    return source.endsWith("?worker") ? this.resolve(`${source}&inline`, importer, { skipSelf: true }) : null;
  },
  generateBundle() {
    if (name === "live")
      this.emitFile({ type: "asset", fileName: "live.html", source: readFileSync(path("live.html"), "utf8") });
  },
});

export default defineConfig(({ mode }) => ({
  // The site runs in any folder of any server.
  base: "./",
  resolve: { alias: { "clubface-core": path("../crates/clubface-c/clubface.js") } },
  server: { fs: { allow: [".."] } },
  // From files, only classic workers start.
  worker: { format: mode in SCRIPTS ? ("iife" as const) : ("es" as const) },
  ...(mode in SCRIPTS
    ? {
        publicDir: false as const,
        define: { "process.env.NODE_ENV": '"production"' },
        build: {
          target: "es2022",
          emptyOutDir: false,
          chunkSizeWarningLimit: 10_000,
          lib: {
            entry: SCRIPTS[mode],
            formats: ["iife" as const],
            name: "clubfaceStudio",
            fileName: () => `${mode}.js`,
            cssFileName: mode,
          },
        },
        plugins: [withWorker(mode)],
      }
    : {
        build: { target: "es2022", assetsInlineLimit: 0, chunkSizeWarningLimit: 400 },
        plugins: [offline()],
      }),
}));
