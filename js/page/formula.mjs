// SPDX-License-Identifier: Apache-2.0
/* global escaped */
// The reader's own formula in JavaScript: judged on the question that is shown, and audited in the background. It runs
// in a worker of its own, which is ended when it takes too long.
import { badge, coded, verdictOf } from "./answers.mjs";

const forOne = 3000,
  forAudit = 120000,
  cases = 2000; // milliseconds
const examples = {
  orientation: `({ p0, p1, p }) => {
  const e = (p1[0] - p0[0]) * (p[1] - p0[1]) - (p1[1] - p0[1]) * (p[0] - p0[0]);
  return e > 0 ? "left" : e < 0 ? "right" : "on";
}`,
  point_in_polygon: `({ polygon, point: [x, y] }) => {
  let inside = false;
  polygon.forEach(([ax, ay], i) => {
    const [bx, by] = polygon[(i + 1) % polygon.length];
    if (ay > y !== by > y && x < ((bx - ax) * (y - ay)) / (by - ay) + ax) inside = !inside;
  });
  return inside ? "inside" : "outside";
}`,
};

/** The first answer that an operation may give, to begin with. */
function firstAnswer(described) {
  if (Array.isArray(described)) return described[1] === "..." ? [] : described.map(firstAnswer);
  if (typeof described === "object") {
    if (described["one of"]) return firstAnswer(described["one of"][0]);
    return Object.fromEntries(
      Object.entries(described)
        .filter(([name]) => !name.endsWith("?"))
        .map(([name, each]) => [name, firstAnswer(each)]),
    );
  }
  return described === "true | false"
    ? true
    : ["number", "index"].includes(described)
      ? 0
      : described.split(" | ")[0];
}
/** A formula to begin with. */
export const begun = ({ name, fields, answer }) =>
  examples[name] ??
  `// The answer: ${JSON.stringify(answer)}\n({ ${[fields].flat().join(", ")} }) => {\n` +
    `  return ${JSON.stringify(firstAnswer(answer))};\n}`;

export class Formula {
  #worker = null;
  #address = null;
  #asked = 0;
  #trusted = false;
  #question;

  /**
   * place: has textarea, .verdict, .audited and buttons
   * started(): a worker with the module; load(op, input): shows a question; changed(): the formula was
   */
  constructor(place, { started, load, changed }) {
    Object.assign(this, { place, started, load, changed });
    this.box = place.querySelector("textarea");
    this.box.addEventListener("input", () => {
      this.#trusted = true;
      this.changed();
      this.#later();
    });
    // Tab indents; Escape, then Tab leaves.
    let leaves = false;
    this.box.addEventListener("keydown", (event) => {
      if (event.key === "Tab" && !event.shiftKey && !leaves) {
        event.preventDefault();
        this.box.setRangeText("  ", this.box.selectionStart, this.box.selectionEnd, "end");
        this.box.dispatchEvent(new Event("input"));
      }
      leaves = event.key === "Escape";
    });
    place.addEventListener("click", ({ target }) => {
      const button = target.closest("button");
      if (button?.matches(".judge, .audit, .begin")) this.#trusted = true;
      if (button?.matches(".judge")) this.judge();
      if (button?.matches(".audit")) this.audit();
      if (button?.matches(".begin")) {
        this.box.value = "";
        this.begin();
      }
      if (button?.dataset.input) this.load(this.question.operation.name, button.dataset.input);
    });
  }

  /** Writes a formula to begin with where there is none. */
  begin() {
    if (this.text.trim()) return;
    this.box.value = begun(this.question.operation);
    this.box.dispatchEvent(new Event("input"));
  }
  get text() {
    return this.box.value;
  }
  /** A text that came with a link is not run before the reader says so. */
  set linked(text) {
    this.box.value = text;
    this.#trusted = false;
    this.#say(text ? "This formula came with the link. Read it, then press Judge it: it runs in this page." : "");
  }
  /** {operation, text} */
  set question(question) {
    const other = this.#question && question.operation !== this.#question.operation;
    if (other) {
      this.place.querySelector(".audited").innerHTML = "";
      if (this.text === begun(this.#question.operation)) this.box.value = begun(question.operation);
    }
    this.#question = question;
  }
  get question() {
    return this.#question;
  }
  /** Judges the formula on the question. */
  follow() {
    if (this.#trusted) this.judge();
  }
  #later() {
    clearTimeout(this.timer);
    this.timer = setTimeout(() => this.judge(), 250);
  }
  #say(words) {
    this.place.querySelector(".verdict").innerHTML = `<p>${escaped(words)}</p>`;
  }

  /** The address of an engine with the formula. */
  #engine() {
    if (this.#address) URL.revokeObjectURL(this.#address);
    const { name } = this.question.operation;
    const source =
      `const formula = (${this.text.trim().replace(/;$/, "")}\n);\n` +
      `export default { name: "your formula", boundary: "closed", ${name}: formula };\n`;
    this.#address = URL.createObjectURL(new Blob([source], { type: "text/javascript" }));
    return this.#address;
  }
  /** The result of a call to the worker, which is ended after so many milliseconds. */
  async #within(milliseconds, call) {
    const worker = await (this.#worker ??= this.started());
    let timer;
    const late = new Promise((_, reject) => {
      timer = setTimeout(() => {
        this.#worker = null;
        reject(new Error(`no answer within ${milliseconds / 1000} s: the formula was stopped`));
        worker.terminate();
      }, milliseconds);
    });
    try {
      return await Promise.race([call(worker), late]);
    } finally {
      clearTimeout(timer);
    }
  }

  async judge() {
    if (!this.text.trim()) return this.#say("");
    if (this.auditing) return;
    const asked = ++this.#asked, { operation, text } = this.question;
    try {
      const [judged] = await this.#within(forOne, (worker) => worker.judge(this.#engine(), operation.name, [text]));
      if (asked !== this.#asked) return;
      this.place.querySelector(".verdict").innerHTML =
        `<p>${badge(verdictOf(judged))} ${judged.answer === undefined ? "" : coded(judged.answer)}` +
        `${judged.remark && judged.remark !== judged.why ? ` <span class="small quiet">${escaped(judged.remark)}</span>` : ""}</p>` +
        (judged.why ? `<p class="small quiet">${escaped(judged.why)}</p>` : "");
    } catch (failure) {
      if (asked === this.#asked) this.#say(failure.rule ?? failure.message);
    }
  }

  async audit() {
    if (!this.text.trim() || this.auditing) return;
    const result = this.place.querySelector(".audited"), { operation } = this.question;
    this.auditing = true;
    result.innerHTML = `<p role="status">${cases} questions are asked ...</p>`;
    try {
      const { table, tally } = await this.#within(forAudit, (worker) =>
        worker.judge(this.#engine(), operation.name, cases, { summary: true }),
      );
      result.innerHTML = `<pre tabindex="0">${escaped(table.trim())}</pre>${found(tally)}`;
    } catch (failure) {
      result.innerHTML = `<p>${escaped(failure.rule ?? failure.message)}</p>`;
    } finally {
      this.auditing = false;
      this.judge();
    }
  }
}

/** An example of each way in which answers were wrong, of most cases first. */
function found(tally) {
  const ways = tally.operations
    .flatMap(({ families }) => families)
    .flatMap(({ family, ways: of }) => of.map((way) => ({ family, ...way })))
    .filter(({ example }) => example)
    .sort((a, b) => total(b.cases) - total(a.cases));
  const kinds = new Map(ways.toReversed().map((way) => [`${way.verdict} ${way.truth} ${way.answer}`, way]));
  if (!kinds.size) return "";
  return `<ul class="ways">${[...kinds.values()]
    .toReversed()
    .slice(0, 12)
    .map(
      ({ verdict, truth, answer, family, example }) =>
        `<li>${badge(verdict)} ${escaped(answer)} where ${escaped(truth)} is right, in ${escaped(family)} ` +
        `<button type="button" data-input="${escaped(JSON.stringify(example.input))}">Show</button></li>`,
    )
    .join("")}</ul>`;
}
const total = (cases) => (typeof cases === "number" ? cases : Object.values(cases).reduce((sum, n) => sum + n, 0));
