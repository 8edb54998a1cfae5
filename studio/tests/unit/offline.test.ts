import { expect, test } from "vitest";
import { checkComplete, serviceWorker } from "../../build/offline";

test("a file that the service worker would not keep is refused by name", () => {
  expect(() => checkComplete(["index.html"], ["assets/core.wasm", "index.html"])).toThrow("assets/core.wasm");
  expect(() => checkComplete(["index.html", "gone.js"], ["index.html"])).toThrow("gone.js");
  expect(() => checkComplete(["index.html"], ["index.html"])).not.toThrow();
});

test("the service worker names its files and is another one when they change", () => {
  expect(serviceWorker(["index.html"], "1")).toContain('["./","index.html"]');
  expect(serviceWorker(["index.html"], "1")).not.toBe(serviceWorker(["index.html"], "2"));
});
