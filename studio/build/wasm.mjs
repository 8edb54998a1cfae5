// Copies the core for browsers without what only a debugger reads, and says what is in it.
//
//     node build/wasm.mjs clubface.wasm browser/clubface.wasm

import { readFileSync, writeFileSync } from "node:fs";
import { brotliCompressSync, gzipSync } from "node:zlib";

const SECTIONS = [
  "custom",
  "type",
  "import",
  "function",
  "table",
  "memory",
  "global",
  "export",
  "start",
  "element",
  "code",
  "data",
  "data count",
];
const HEADER = 8;

/** A number in LEB128 at a place, and the place behind it. */
function leb(bytes, at) {
  let [value, shift, place] = [0, 0, at];
  for (;;) {
    const byte = bytes[place];
    value |= (byte & 0x7f) << shift;
    place += 1;
    if (byte < 0x80) return [value >>> 0, place];
    shift += 7;
  }
}

/** The sections of a module: name, and the bytes from its number to its end. */
function sections(bytes) {
  const result = [];
  for (let at = HEADER; at < bytes.length; ) {
    const [size, body] = leb(bytes, at + 1);
    const name = SECTIONS[bytes[at]] ?? `section ${bytes[at]}`;
    result.push({ name, isCustom: bytes[at] === 0, bytes: bytes.subarray(at, body + size) });
    at = body + size;
  }
  return result;
}

const [from, to] = process.argv.slice(2);
const whole = readFileSync(from);
const kept = sections(whole).filter(({ isCustom }) => !isCustom);
const module = Buffer.concat([whole.subarray(0, HEADER), ...kept.map(({ bytes }) => bytes)]);
await WebAssembly.compile(module);
writeFileSync(to, module);

const kilobytes = (size) => `${(size / 1e3).toFixed(0)} kB`;
const parts = kept
  .filter(({ bytes }) => bytes.length > 10e3)
  .map(
    ({ name, bytes }) =>
      `${name} ${kilobytes(bytes.length)} (${kilobytes(gzipSync(bytes, { level: 9 }).length)} by gzip)`,
  );
console.log(
  `core: ${kilobytes(module.length)}, ${kilobytes(gzipSync(module, { level: 9 }).length)} by gzip, ` +
    `${kilobytes(brotliCompressSync(module).length)} by brotli; ${parts.join(", ")}; ` +
    `left out: names, ${kilobytes(whole.length - module.length)}`,
);
