// SPDX-License-Identifier: Apache-2.0
/** Records calls of one's own functions, with their answers, in a log (docs/own_inputs.md), in Node and in browsers.
 *
 *   const recording = new Recording(await toFile("app.jsonl"), { engine: "my app 1.0", oneIn: 100 });
 *   const meets = recording.recorded("segment_segment", ["a", "b"], (a, b) => ...);
 *   ...
 *   recording.close();
 *
 * In a browser, `const lines = []` with `new Recording((text) => lines.push(text))` keeps the log, and
 * `new Blob(lines)` is its file. What was not written before the process ends is lost; the log then has no end mark.
 */

/** A sink that appends to a file of Node's; what it has taken is in the file when it returns. */
export async function toFile(name) {
  const { openSync, writeSync } = await import("node:fs");
  const file = openSync(name, "w");
  return (text) => writeSync(file, text);
}

const bufferSize = 1 << 16;
const reserve = 200; // characters that the end mark may take

/** Numbers that JSON has no number for are texts: "nan", "inf", "-inf"; and -0 keeps its sign. Typed arrays are lists. */
function written(value) {
  if (typeof value === "number") {
    if (Object.is(value, -0)) return "-0.0";
    if (Number.isFinite(value)) return String(value);
    return Number.isNaN(value) ? '"nan"' : value > 0 ? '"inf"' : '"-inf"';
  }
  if (ArrayBuffer.isView(value)) value = Array.from(value);
  if (Array.isArray(value)) return `[${value.map(written).join(",")}]`;
  if (value !== null && typeof value === "object")
    return `{${Object.entries(value).map(([key, part]) => `${asciiText(key)}:${written(part)}`).join(",")}}`;
  return typeof value === "string" ? asciiText(value) : JSON.stringify(value ?? null) ?? "null";
}

const asciiText = (text) =>
  JSON.stringify(text).replace(/[\u007f-\uffff]/g, (c) => "\\u" + c.charCodeAt(0).toString(16).padStart(4, "0"));

export class Recording {
  #write; #options; #lines = []; #size = 0; #total = 0; #full = false; #sites = new Map(); #near = Infinity;
  #end = { seen: 0, written: 0, sampled_out: 0, lost: 0 };

  /** write: takes text. engine: name and version of what is recorded; boundary: "closed" or "open"; tolerance. oneIn:
   * of each function one call in so many is written, at random; first: its first calls all; near: so are calls whose
   * nearness() is less. most: characters of the log; calls for which there is no room are counted as lost. */
  constructor(write, { engine = "", boundary, tolerance, oneIn = 1, first = 0, near = 0, most = 2 ** 30 } = {}) {
    this.#write = write;
    this.#options = { oneIn, first, near, most };
    const sampled = { one_in: oneIn, ...(first && { first }), ...(near && { near }) };
    const header = { touchstone_log: 1, engine, ...(boundary && { boundary }), ...(tolerance && { tolerance }), sampled };
    this.#put([written(header) + "\n"]);
  }

  /** How near to degenerate the call is that is recorded next: |determinant| / error bound. The least counts. */
  nearness(value) {
    this.#near = Math.min(this.#near, value);
  }

  /** The function; its calls are recorded as calls of an operation, its arguments under the names of these fields. It
   * returns true or false, or the whole answer as an object; undefined is not recorded; an exception is, as an error. */
  recorded(operation, fields, called, site = called.name) {
    const line = (question, rest) =>
      `{"op":${written(operation)},"input":${question},${rest}` + (site ? `,"site":${written(site)}}\n` : "}\n");
    return (...arguments_) => {
      let rest;
      try {
        const answer = called(...arguments_);
        if (answer !== undefined) rest = () => `"answer":${written(answer)}`;
        return answer;
      } catch (error) {
        rest = () => `"error":${written(String(error?.message ?? error))}`;
        throw error;
      } finally {
        if (rest && this.#wants(called)) {
          try {
            const parts = fields.map((field, i) => `${written(field)}:${written(arguments_[i])}`);
            this.#take(line(`{${parts.join(",")}}`, rest()));
          } catch {
            ++this.#end.lost; // what has no JSON: the program that is recorded goes on
          }
        }
      }
    };
  }

  close() {
    this.#flush();
    this.#write(written({ end: this.#end }) + "\n");
    this.#full = true;
  }

  #wants(called) {
    const near = this.#near;
    this.#near = Infinity;
    ++this.#end.seen;
    if (this.#options.oneIn > 1) {
      const site = this.#sites.get(called) ?? { seen: 0, leftOutNext: 0 };
      this.#sites.set(called, site);
      if (++site.seen > this.#options.first && !(near < this.#options.near)) {
        if (site.leftOutNext > 0) {
          --site.leftOutNext;
          ++this.#end.sampled_out;
          return false;
        }
        site.leftOutNext = Math.floor(Math.random() * (2 * this.#options.oneIn - 1));
      }
    }
    if (this.#full) ++this.#end.lost;
    return !this.#full;
  }

  #take(line) {
    this.#lines.push(line);
    this.#size += line.length;
    if (this.#size >= bufferSize) this.#flush();
  }

  #flush() {
    const written = this.#put(this.#lines);
    this.#end.written += written;
    this.#end.lost += this.#lines.length - written;
    this.#lines = [];
    this.#size = 0;
  }

  /** All lines at once, or those for which there is room. */
  #put(lines) {
    let count = 0, total = this.#total;
    while (count < lines.length && !this.#full) {
      if (total + lines[count].length + reserve > this.#options.most) this.#full = true;
      else total += lines[count++].length;
    }
    if (count > 0) this.#write(lines.slice(0, count).join(""));
    this.#total = total;
    return count;
  }
}
