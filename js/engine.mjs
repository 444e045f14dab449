// SPDX-License-Identifier: Apache-2.0
// An engine is an object: its functions have the names of operations and take the fields of a question; its other
// members are what an engine over pipes declares (docs/engines.md), with `name` for its name and version.
import { Answers, InvalidInput, jsonOf, textOf } from "./core.mjs";

const declared = ["number", "boundary", "tolerance", "pairs", "nearest", "skew_boxes", "polygons", "alternatives"];
/** Of an engine that answers with promises: the audit is made again with the answers so far, at most so many times. */
const mostRounds = 12;

/** The engine of a module: its default export, or what it exports. */
export const engineOf = (exported) => exported.default ?? exported;

const isEngine = (engine) => engine !== null && ["object", "function"].includes(typeof engine);

/** The declaration of an engine, as it would send it over a pipe. */
export function greetingOf(touchstone, engine) {
  if (!isEngine(engine)) throw new TypeError("an engine is an object with a function for each of its operations");
  const greeting = { engine: engine.name ?? "unnamed" };
  greeting.ops = touchstone.operations().map((each) => each.name).filter((name) => typeof engine[name] === "function");
  const others = Object.keys(engine).filter((name) => typeof engine[name] === "function");
  if (greeting.ops.length === 0)
    throw new InvalidInput("greeting", `engine ${greeting.engine}: it has no function with the name of an operation` +
      (others.length > 0 ? `, but ${others.join(", ")}` : ""));
  for (const field of declared) if (engine[field] !== undefined) greeting[field] = engine[field];
  return greeting;
}

/** The field of an answer that an enumerator alone belongs to. */
function fieldOf(operation, word) {
  const has = ([, words]) => typeof words === "string" && words.split(" | ").includes(word);
  return Object.entries(operation.answer).find(has)?.[0];
}

/** What a function returned, as the reply of an engine: undefined and null are "unsupported", an enumerator may stand alone. */
export function replyOf(operation, answer) {
  if (answer === undefined || answer === null) return '{"unsupported":true}';
  if (typeof answer === "string") {
    const field = fieldOf(operation, answer);
    return jsonOf({ answer: field === undefined ? answer : { [field]: answer } });
  }
  return jsonOf({ answer });
}
const replyToFailure = (failure) => jsonOf({ error: String(failure?.message ?? failure) });

/** The reply, or a promise of it. */
function asked(touchstone, engine, name, question) {
  const operation = touchstone.operation(name);
  try {
    const answer = engine[name](JSON.parse(question));
    if (typeof answer?.then !== "function") return replyOf(operation, answer);
    return answer.then((settled) => replyOf(operation, settled)).catch(replyToFailure);
  } catch (failure) {
    return replyToFailure(failure);
  }
}

/** run(replyTo) with an engine whose functions may return promises: again and again, with what has been answered. */
async function inRounds(touchstone, engine, run) {
  const known = new Map();
  for (let round = 1; ; ++round) {
    const pending = [];
    const result = run((name, question) => {
      const key = `${name} ${question}`;
      if (known.has(key)) return known.get(key);
      if (round === mostRounds) return undefined;
      const reply = asked(touchstone, engine, name, question);
      if (typeof reply === "string") return reply;
      known.set(key, undefined);  // once in a round
      pending.push(reply.then((settled) => known.set(key, settled)));
      return undefined;
    });
    if (pending.length === 0) return result;
    await Promise.all(pending);
  }
}

/** An instance of the module that also takes engines; what does so returns promises. */
export class Touchstone extends Answers {
  /** An audit as `touchstone audit` makes it: {exit_code, table, tally}. */
  async audit(engine, options = {}) {
    const greeting = greetingOf(this, engine);
    return inRounds(this, engine, (replyTo) => this.auditReplies(greeting, options, replyTo));
  }
  /** Of a number of cases the audit of one operation; of a list of questions the verdict on each answer. */
  async judge(engine, operation, cases = 2000, options = {}) {
    if (typeof cases === "number") return this.audit(engine, { ...options, ops: [operation], cases });
    const greeting = greetingOf(this, engine);
    if (typeof engine[operation] !== "function") throw new TypeError(`the engine has no function ${operation}`);
    const verdicts = [];
    for (const question of cases) {
      const text = textOf(question);
      const reply = await asked(this, engine, operation, text);
      verdicts.push(this.judgeReply(greeting, operation, text, reply));
    }
    return verdicts;
  }
  /** The shortest question on which the textbook formula, or an engine, is wrong in the same way. */
  async shrink(operation, question, { engine, ...options } = {}) {
    if (engine === undefined) return this.shrinkReplies(operation, question, options);
    const greeting = greetingOf(this, engine);
    return inRounds(this, engine, (replyTo) => this.shrinkReplies(operation, question, options, greeting, replyTo));
  }
}
