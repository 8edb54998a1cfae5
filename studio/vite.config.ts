import { fileURLToPath } from "node:url";
import { defineConfig } from "vite";
import { offline } from "./build/offline.ts";

const core = fileURLToPath(new URL("../crates/clubface-c/clubface.js", import.meta.url));

export default defineConfig({
  // The site runs in any folder of any server.
  base: "./",
  resolve: { alias: { "clubface-core": core } },
  server: { fs: { allow: [".."] } },
  worker: { format: "es" },
  build: { target: "es2022", assetsInlineLimit: 0, chunkSizeWarningLimit: 400 },
  plugins: [offline()],
});
