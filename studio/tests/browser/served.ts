/** The built site as `clubface studio` serves it, in a process that a test may kill. */

import { type ChildProcess, spawn } from "node:child_process";
import { mkdtempSync, rmSync } from "node:fs";
import { createConnection, type Socket } from "node:net";
import { tmpdir } from "node:os";
import { join } from "node:path";
import { createInterface } from "node:readline";
import { fileURLToPath } from "node:url";
import { PYTHON } from "./command-line";

const DIST = fileURLToPath(new URL("../../dist/", import.meta.url));

/** A folder for the files of a server. */
export const newFolder = (): string => mkdtempSync(join(tmpdir(), "clubface-studio-"));
export const removeFolder = (folder: string): void => rmSync(folder, { recursive: true, force: true });

export class Served {
  private constructor(
    private readonly process: ChildProcess,
    readonly address: string,
    /** Ports by protocol, where live shots are taken. */
    readonly ports: Record<string, number>,
  ) {}

  /** Starts a server in a folder; `options` are those of the command. */
  static async start(folder: string, ...options: string[]): Promise<Served> {
    const child = spawn(PYTHON, ["-m", "clubface", "studio", "--port", "0", ...options], {
      cwd: folder,
      env: { ...process.env, CLUBFACE_STUDIO_SITE: DIST },
      stdio: ["ignore", "pipe", "pipe"],
    });
    const lines: string[] = [];
    createInterface({ input: child.stderr }).on("line", (line) => lines.push(line));
    const address = await new Promise<string>((resolve, reject) => {
      createInterface({ input: child.stdout }).once("line", resolve);
      child.once("exit", () => reject(new Error(`the server has ended: ${lines.join("\n")}`)));
    });
    const ports: Record<string, number> = {};
    for (const line of lines) {
      const [, protocol, port] = /clubface: ([a-z-]+): \S+:(\d+)$/.exec(line) ?? [];
      if (protocol) ports[protocol] = Number(port);
    }
    return new Served(child, address, ports);
  }

  /** Ends it as a failure of the machine does. */
  async kill(): Promise<void> {
    if (this.process.exitCode !== null || this.process.signalCode !== null) return;
    const ended = new Promise((resolve) => this.process.once("exit", resolve));
    this.process.kill("SIGKILL");
    await ended;
  }
}

/** A monitor that speaks GSPro Open Connect. */
export class Monitor {
  private shots = 0;

  private constructor(private readonly socket: Socket) {}

  static async connect(port: number): Promise<Monitor> {
    const socket = createConnection(port, "127.0.0.1");
    await new Promise((resolve, reject) => socket.once("connect", resolve).once("error", reject));
    return new Monitor(socket);
  }

  /** Sends a shot, and returns the code of the answer. */
  async send(parts: Record<string, unknown>): Promise<number> {
    this.shots += 1;
    const answer = new Promise<string>((resolve) => this.socket.once("data", (data) => resolve(String(data))));
    const message = { DeviceID: "radar", Units: "Yards", ShotNumber: this.shots, APIversion: "1", ...parts };
    this.socket.write(JSON.stringify(message));
    return (JSON.parse(await answer) as { Code: number }).Code;
  }

  close(): void {
    this.socket.destroy();
  }
}
