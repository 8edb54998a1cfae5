/** The built site on a server of its own, and a browser to look at it. */

import { existsSync, readFileSync } from "node:fs";
import { createServer, type Server } from "node:http";
import type { AddressInfo } from "node:net";
import { extname, join, normalize } from "node:path";
import { fileURLToPath } from "node:url";
import axe from "axe-core";
import { type Browser, type BrowserContext, type BrowserContextOptions, chromium, type Page } from "playwright-core";
import { afterAll, beforeAll, beforeEach } from "vitest";

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

async function startBrowser(): Promise<Browser> {
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

/** The screen and the language of tests that choose no others. */
const USUAL: BrowserContextOptions = { viewport: { width: 1280, height: 900 }, locale: "en-US" };

/** A browser for the tests of a file. Each test has a context of its own, with the usual screen but for `options`. */
export class TestBrowser {
  browser!: Browser;
  context!: BrowserContext;

  /** `timeout` is how long pages may take over what a test waits for [ms]. */
  constructor(
    private readonly options: BrowserContextOptions = {},
    private readonly timeout = 30e3,
  ) {
    beforeAll(async () => {
      this.browser = await startBrowser();
    });
    beforeEach(() => this.renew());
    afterAll(() => this.browser?.close());
  }

  /** Gives the test another context: another screen, other colours, less motion. */
  async renew(options: BrowserContextOptions = {}): Promise<void> {
    await this.context?.close();
    this.context = await this.browser.newContext({ ...USUAL, ...this.options, ...options });
    this.context.setDefaultTimeout(this.timeout);
  }

  /** Opens a page and waits until it shows `ready`: a selector, by which its scene is known to be whole. */
  async open(address: string, ready = "[data-quantity], .models td"): Promise<Opened> {
    const page = await this.context.newPage();
    const errors: string[] = [];
    page.on("console", (message) => {
      // What a graphics card that is computed in software says of its own speed is no fault of the page.
      if (message.text().includes("GL Driver Message")) return;
      if (message.type() === "error" || message.type() === "warning") errors.push(message.text());
    });
    page.on("pageerror", (error) => errors.push(String(error)));
    await page.goto(address);
    await page.locator(ready).first().waitFor({ state: "attached" });
    return { page, errors };
  }
}

/** The same, with the built site on a server. */
export class TestStudio extends TestBrowser {
  private site!: Site;

  constructor(options?: BrowserContextOptions, timeout?: number) {
    super(options, timeout);
    beforeAll(async () => {
      this.site = await Site.start();
    });
    afterAll(() => this.site?.stop());
  }

  /** Opens a link of the site, such as `#scene=map`, or a whole address. */
  override open(link: string, ready?: string): Promise<Opened> {
    return super.open(link.startsWith("#") ? this.site.address + link : link, ready);
  }
}

/** The number in SI behind a quantity on the page. */
export const siValueOf = async (page: Page, quantity: string): Promise<number> =>
  Number(await page.locator(`td[data-quantity="${quantity}"]`).first().getAttribute("data-value"));

/** All numbers on the page by the names of their quantities [SI]. */
export const quantitiesOf = (page: Page): Promise<[name: string, value: number][]> =>
  page
    .locator("td[data-quantity]")
    .evaluateAll((cells) =>
      cells.map((cell): [string, number] => [
        cell.getAttribute("data-quantity") ?? "",
        Number(cell.getAttribute("data-value")),
      ]),
    );

/** Waits until the page shows another value of a quantity, and returns it. */
export async function otherValue(page: Page, quantity: string, before: number): Promise<number> {
  await page.waitForFunction(
    ([name, value]) => document.querySelector(`td[data-quantity="${name}"]`)?.getAttribute("data-value") !== value,
    [quantity, String(before)],
  );
  return siValueOf(page, quantity);
}

/** Goes to another link within the page, as when its address is changed by hand. */
export const goTo = (page: Page, link: string): Promise<void> =>
  page.evaluate((hash) => {
    location.hash = hash;
  }, link);

/** The words of the first such element, one space between them. */
export const textOf = async (page: Page, selector: string): Promise<string> =>
  ((await page.locator(selector).first().textContent()) ?? "").replace(/\s+/g, " ").trim();

/** Drops a file on an element. */
export async function drop(page: Page, selector: string, name: string, content: string): Promise<void> {
  const data = await page.evaluateHandle(
    ([fileName, text]) => {
      const transfer = new DataTransfer();
      transfer.items.add(new File([text], fileName));
      return transfer;
    },
    [name, content],
  );
  await page.dispatchEvent(selector, "drop", { dataTransfer: data });
}

/** What axe finds wrong with the whole page, its details opened. */
export async function violations(page: Page): Promise<string[]> {
  await page.locator("details summary").evaluateAll((all) => {
    for (const summary of all) (summary.parentElement as HTMLDetailsElement).open = true;
  });
  await page.waitForTimeout(300);
  await page.evaluate(axe.source);
  return page.evaluate(async () => {
    const { violations: all } = await (globalThis as unknown as { axe: typeof axe }).axe.run();
    return all.map(({ id, nodes }) => `${id}: ${nodes.map(({ html }) => html).join("; ")}`);
  });
}

/** Moves a slider by one step of the keyboard. */
export async function slide(page: Page, label: string, key = "ArrowRight"): Promise<void> {
  await page.getByRole("slider", { name: `${label}, slider` }).press(key);
}

/** What a canvas shows, as text that changes with its picture. */
export const pictureOf = (page: Page, selector: string): Promise<string> =>
  page.locator(selector).evaluate((canvas) => (canvas as HTMLCanvasElement).toDataURL());
