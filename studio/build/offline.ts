/**
 * Makes the service worker that keeps the site for use without a network.
 *
 * Its list holds what the build says it wrote and what stands in `public`. The build fails if a file of the finished
 * site is not in the list, or if the list names one that is not there: a page that lacks a file is blank offline.
 */

import { createHash } from "node:crypto";
import { readdirSync, readFileSync, writeFileSync } from "node:fs";
import { join, relative } from "node:path";
import type { Plugin } from "vite";

const NAME = "sw.js";

/** Paths of all files under a folder, with slashes. */
export function filesUnder(folder: string): string[] {
  return readdirSync(folder, { recursive: true, withFileTypes: true })
    .filter((entry) => entry.isFile())
    .map((entry) => relative(folder, join(entry.parentPath, entry.name)).replaceAll("\\", "/"))
    .sort();
}

/** Throws unless the list names exactly the files of a site. */
export function checkComplete(listed: readonly string[], present: readonly string[]): void {
  const left = present.filter((file) => !listed.includes(file));
  const gone = listed.filter((file) => !present.includes(file));
  if (left.length) throw new Error(`not kept for use offline: ${left.join(", ")}`);
  if (gone.length) throw new Error(`listed for use offline, but not built: ${gone.join(", ")}`);
}

/** The service worker of a site of these files, whose content has this digest. */
export function serviceWorker(files: readonly string[], digest: string): string {
  return `// Made by the build: keeps every file of the site, and answers from what is kept.
const CACHE = "clubface-studio-${digest}";
const FILES = ${JSON.stringify(["./", ...files])};

addEventListener("install", (event) => {
  const keep = async () => (await caches.open(CACHE)).addAll(FILES.map((file) => new Request(file, { cache: "reload" })));
  event.waitUntil(keep().then(() => skipWaiting()));
});

addEventListener("activate", (event) => {
  const clean = async () => {
    const old = (await caches.keys()).filter((name) => name.startsWith("clubface-studio-") && name !== CACHE);
    await Promise.all(old.map((name) => caches.delete(name)));
    await clients.claim();
  };
  event.waitUntil(clean());
});

addEventListener("fetch", (event) => {
  if (event.request.method !== "GET" || new URL(event.request.url).origin !== location.origin) return;
  const answer = async () => {
    const kept = await caches.open(CACHE);
    const page = event.request.mode === "navigate" ? "./" : event.request;
    return (await kept.match(page, { ignoreSearch: true })) ?? fetch(event.request);
  };
  event.respondWith(answer());
});
`;
}

export function offline(): Plugin {
  let folder = "";
  let publicFolder = "";
  return {
    name: "clubface-offline",
    apply: "build",
    configResolved(config) {
      folder = join(config.root, config.build.outDir);
      publicFolder = config.publicDir;
    },
    writeBundle(_, bundle) {
      const listed = [...Object.keys(bundle), ...filesUnder(publicFolder)].sort();
      checkComplete(listed, filesUnder(folder));
      const digest = createHash("sha256");
      for (const file of listed) digest.update(file).update(readFileSync(join(folder, file)));
      writeFileSync(join(folder, NAME), serviceWorker(listed, digest.digest("hex").slice(0, 16)));
    },
  };
}
