// SPDX-License-Identifier: Apache-2.0
// The functions of c/touchstone.h over the WebAssembly module, for node, pages and workers alike.

/** Input outside the contract, with the field and the rule that it breaks. */
export class InvalidInput extends Error {
  constructor(field, rule) {
    super(field ? `${field}: ${rule}` : rule);
    this.name = "InvalidInput";
    this.field = field;
    this.rule = rule;
  }
}

/** JSON that keeps what JSON.stringify drops: the sign of -0, "nan" and "inf" of answers, the elements of typed arrays. */
export function jsonOf(value) {
  if (typeof value === "number") {
    if (Number.isNaN(value)) return '"nan"';
    if (!Number.isFinite(value)) return value > 0 ? '"inf"' : '"-inf"';
    return Object.is(value, -0) ? "-0.0" : String(value);
  }
  if (ArrayBuffer.isView(value)) return jsonOf([...value]);
  if (Array.isArray(value)) return `[${value.map((each) => jsonOf(each ?? null)).join(",")}]`;
  if (typeof value !== "object" || value === null) return JSON.stringify(value);
  const fields = Object.entries(value).filter(([, field]) => field !== undefined && typeof field !== "function");
  return `{${fields.map(([name, field]) => `${JSON.stringify(name)}:${jsonOf(field)}`).join(",")}}`;
}
/** A question or claim as text; a text is taken as it stands, so that its decimals stay as they were typed. */
export const textOf = (value) => (typeof value === "string" ? value : jsonOf(value));

// struct touchstone_error of c/touchstone_robust.h in wasm32.
const error = { field: 4, rule: 4 + 128, size: 4 + 128 + 512 };
const [ok, , refused] = [0, 1, 2];

/** The calls of the module: module.call("ask", ...) is touchstone_ask. */
class Calls {
  constructor(module) {
    this.module = module;
    this.error = module._malloc(error.size);
    this.result = module._malloc(4);
  }

  /** Calls with texts (copied), null, numbers and BigInts as they are, then `tail` (the result's place and the error's). */
  run(name, given, tail) {
    const module = this.module;
    const copies = [];
    try {
      const passed = given.map((value) => {
        if (value === null) return 0;
        if (typeof value !== "string") return value;
        const size = module.lengthBytesUTF8(value) + 1;
        copies.push(module._malloc(size));
        module.stringToUTF8(value, copies.at(-1), size);
        return copies.at(-1);
      });
      return module[`_touchstone_${name}`](...passed, ...tail);
    } finally {
      for (const copy of copies) module._free(copy);
    }
  }

  failed(code) {
    const [field, rule] = [error.field, error.rule].map((at) => this.module.UTF8ToString(this.error + at));
    return code === ok + 1 ? new InvalidInput(field, rule) : new Error(rule);
  }

  text(name, ...given) {
    const code = this.run(name, given, [this.result, this.error]);
    if (code !== ok) throw this.failed(code);
    const at = this.module.getValue(this.result, "*");
    const text = this.module.UTF8ToString(at);
    this.module._touchstone_free(at);
    return text;
  }

  json(name, ...given) {
    return JSON.parse(this.text(name, ...given));
  }

  complaint(claim) {
    const code = this.run("certify", [claim], [this.error]);
    if (code === ok) return "";
    const failure = this.failed(code);
    if (code !== refused) throw failure;
    return failure.message;
  }
}

/** What one instance of the module answers. Questions and claims are objects, or texts of JSON. */
export class Answers {
  #calls;
  #operations;

  constructor(module) {
    this.#calls = new Calls(module);
  }

  /** All operations of the catalogue, as `touchstone ops --json` lists them. */
  operations() {
    return (this.#operations ??= this.#calls.json("operations"));
  }
  operation(name) {
    const found = this.operations().find((each) => each.name === name);
    if (!found) this.#calls.text("answer", name, "{}");  // throws, with the name that may have been meant
    return found;
  }

  /** The answer of `robust`: right, in doubles. */
  answer(operation, question) {
    return this.#calls.json("answer", operation, textOf(question));
  }
  /** The exact truth with its certificate, a claim for `certify`. */
  truth(operation, question) {
    return this.#calls.json("truth", operation, textOf(question));
  }
  /** The line of `touchstone ask`: truth, certificate, robust and the textbook formula with the verdict on each. */
  ask(operation, question) {
    return JSON.parse(this.askText(operation, question));
  }
  /** The same as text, byte for byte. */
  askText(operation, question) {
    return this.#calls.text("ask", operation, textOf(question));
  }
  /** The same with what people read: sentences, reasons, the truth as typed, the formula in float, the checker. */
  explain(operation, question) {
    return this.#calls.json("explain", operation, textOf(question));
  }
  /** Figures of a question, of its truth, and of an answer if there is one. */
  drawing(operation, question, answer) {
    return this.#calls.json("drawing", operation, textOf(question), answer === undefined ? null : textOf(answer));
  }
  /** A question in JSON, from a text in JSON, WKT or GeoJSON; its decimals stay as they were typed. */
  read(operation, text) {
    return this.#calls.text("read", operation, text);
  }
  /** A regression test of a question, as a file for "catch2", "gtest", "pytest", "jest" or "rust". */
  regressionTest(operation, question, framework = "jest") {
    return this.#calls.text("regression_test", operation, textOf(question), framework);
  }
  /** Verdicts and truths of the questions around one, in which the numbers of these two places move by ulps. */
  map(operation, question, { axes, side = 41, float = false } = {}) {
    const [first, second] = axes ?? this.operation(operation).axes;
    return this.#calls.json("map", operation, textOf(question), first, second, side, float ? 1 : 0);
  }
  /** A scene, played as `touchstone simulate` plays it: the summary, and the page that shows the runs side by side. */
  simulate(scene, options = {}) {
    return this.#calls.json("simulate", textOf(scene), jsonOf(options));
  }
  /** "" if the certificate proves the claim's truth, otherwise the checker's complaint. */
  certify(claim) {
    return this.#calls.complaint(textOf(claim));
  }

  /** Questions within the contract, degenerate on purpose, each with its truth: those of `touchstone draw`. */
  *draw(operation, { families = [], cases = 100, seed = 1 } = {}) {
    const most = BigInt(cases === Infinity ? Number.MAX_SAFE_INTEGER : cases);
    let given = 0;
    // A longer list begins with the shorter one.
    for (let asked = 256n; BigInt(given) < most; asked *= 2n) {
      const lines = this.#calls
        .text("draw", operation, families.join(","), asked < most ? asked : most, BigInt(seed)).split("\n").slice(given, -1);
      for (const line of lines) yield JSON.parse(line);
      given += lines.length;
    }
  }
  /** The question that bytes draw from a family; it may lie outside the contract. */
  replay(operation, family, bytes) {
    const { module } = this.#calls;
    const at = module._malloc(bytes.length + 1);
    try {
      bytes.forEach((byte, i) => module.setValue(at + i, byte, "i8"));
      return this.#calls.json("replay", operation, family, at, bytes.length);
    } finally {
      module._free(at);
    }
  }
  /** Whether a question is within the contract. */
  accepts(operation, question) {
    try {
      this.answer(operation, question);
      return true;
    } catch (failure) {
      if (failure instanceof InvalidInput) return false;
      throw failure;
    }
  }

  /** The verdict on an engine's reply to one question: greeting and reply as over pipes (docs/engines.md). */
  judgeReply(greeting, operation, question, reply) {
    return this.#calls.json("judge", textOf(greeting), operation, textOf(question), textOf(reply));
  }
  /** An audit of replyTo(operation, question), texts of JSON; undefined leaves a question unasked. */
  auditReplies(greeting, options, replyTo) {
    return this.#called(replyTo, (engine) => this.#calls.json("audit", jsonOf(options), textOf(greeting), engine, 0));
  }
  /** The shortest question on which the formula, or the engine of a greeting, is wrong in the same way. */
  shrinkReplies(operation, question, options = {}, greeting = null, replyTo) {
    const shrunk = (engine) =>
      this.#calls.json("shrink", operation, textOf(question), jsonOf(options), greeting && textOf(greeting), engine, 0);
    return replyTo ? this.#called(replyTo, shrunk) : shrunk(0);
  }

  /** Calls with a function of the module's table, of type touchstone_engine. */
  #called(replyTo, call) {
    const { module } = this.#calls;
    let reply = 0;
    let thrown;
    const engine = module.addFunction((user, operation, question) => {
      module._free(reply);
      reply = 0;
      let text;
      try {
        text = replyTo(module.UTF8ToString(operation), module.UTF8ToString(question));
      } catch (failure) {
        thrown ??= failure;
      }
      if (text === undefined || thrown) return 0;
      const size = module.lengthBytesUTF8(text) + 1;
      reply = module._malloc(size);
      module.stringToUTF8(text, reply, size);
      return reply;
    }, "iiii");
    try {
      return call(engine);
    } finally {
      module.removeFunction(engine);
      module._free(reply);
      if (thrown) throw thrown;
    }
  }
}
