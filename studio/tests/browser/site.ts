/** The built site on a server of its own, and a browser to look at it. */

import { existsSync, readFileSync } from "node:fs";
import { createServer, type Server } from "node:http";
import type { AddressInfo } from "node:net";
import { extname, join, normalize } from "node:path";
import { fileURLToPath } from "node:url";
import { type Browser, type BrowserContext, chromium, type Page } from "playwright-core";

const DIST = fileURLToPath(new URL("../../dist/", import.meta.url));
const CHROMIUM = process.env.CHROMIUM ?? "/usr/bin/chromium";
const TYPES: Record<string, string> = {
  ".html": "text/html",
  ".js": "text/javascript",
  ".css": "text/css",
  ".json": "application/json",
  ".wasm": "application/wasm",
  ".svg": "image/svg+xml",
};

export async function startBrowser(): Promise<Browser> {
  if (!existsSync(CHROMIUM))
    throw new Error(`${CHROMIUM} is not there: install Debian's package chromium, or name a browser by CHROMIUM=...`);
  return chromium.launch({ executablePath: CHROMIUM, args: ["--no-sandbox"] });
}

export class Site {
  private constructor(
    private readonly server: Server,
    readonly address: string,
  ) {}

  static async start(): Promise<Site> {
    if (!existsSync(join(DIST, "index.html"))) throw new Error("dist is not there: run make studio-build");
    const server = createServer((request, response) => {
      const { pathname } = new URL(request.url ?? "/", "http://localhost");
      const file = join(DIST, normalize(pathname === "/" ? "/index.html" : decodeURIComponent(pathname)));
      if (!file.startsWith(DIST) || !existsSync(file)) {
        response.writeHead(404).end();
        return;
      }
      response.writeHead(200, { "content-type": TYPES[extname(file)] ?? "application/octet-stream" });
      response.end(readFileSync(file));
    });
    await new Promise<void>((resolve) => server.listen(0, "127.0.0.1", resolve));
    return new Site(server, `http://127.0.0.1:${(server.address() as AddressInfo).port}/`);
  }

  async stop(): Promise<void> {
    this.server.closeAllConnections();
    await new Promise((resolve) => this.server.close(resolve));
  }
}

/** A page, and what its console says is wrong. */
export interface Opened {
  page: Page;
  errors: string[];
}

export async function open(context: BrowserContext, address: string): Promise<Opened> {
  const page = await context.newPage();
  const errors: string[] = [];
  page.on("console", (message) => {
    if (message.type() === "error" || message.type() === "warning") errors.push(message.text());
  });
  page.on("pageerror", (error) => errors.push(String(error)));
  await page.goto(address);
  await page.locator("[data-quantity], .models td").first().waitFor({ state: "attached" });
  return { page, errors };
}

/** The number in SI behind a quantity on the page. */
export const siValueOf = async (page: Page, quantity: string): Promise<number> =>
  Number(await page.locator(`td[data-quantity="${quantity}"]`).first().getAttribute("data-value"));

/** Waits until the page shows another value of a quantity, and returns it. */
export async function otherValue(page: Page, quantity: string, before: number): Promise<number> {
  await page.waitForFunction(
    ([name, value]) => document.querySelector(`td[data-quantity="${name}"]`)?.getAttribute("data-value") !== value,
    [quantity, String(before)],
  );
  return siValueOf(page, quantity);
}
