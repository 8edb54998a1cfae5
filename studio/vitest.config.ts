import { mergeConfig } from "vite";
import { defineConfig } from "vitest/config";
import site from "./vite.config.ts";

export default defineConfig((environment) =>
  mergeConfig(site(environment), {
    test: {
      include: ["tests/**/*.test.ts", "tests/screenshots/*.ts"],
      fileParallelism: true,
      expect: { poll: { timeout: 20_000 } },
    },
  }),
);
