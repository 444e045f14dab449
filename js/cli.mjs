#!/usr/bin/env node
// SPDX-License-Identifier: Apache-2.0
// npx touchstone COMMAND: what the program `touchstone` has of these commands, with its output and its exit codes.
import { readFileSync, writeFileSync } from "node:fs";
import { resolve } from "node:path";
import { pathToFileURL } from "node:url";
import { parseArgs } from "node:util";

import { jsonOf } from "./core.mjs";
import { engineOf } from "./engine.mjs";
import touchstone, { InvalidInput } from "./index.mjs";

const usage = `npx touchstone COMMAND, of an exact reference for collision tests

  audit ENGINE.mjs     judge the functions of a module: its default export is an object, or it exports functions,
                       with the names of operations; each takes a question and returns an answer or a promise of it
    --ops A,B          operations (all that the engine has)
    --families A,B     families of inputs (all)
    --cases N          cases of each operation (2000)
    --by-cost          fewer of expensive operations
    --seed N           of the cases (1)
    --range ordinary   no numbers of extreme size
    --fail-on A,B      causes that fail: algorithm, cancellation, out_of_range, inexact, invalid ...
    --summary          a row for each operation, no families and no examples
    --json FILE        write the tally
  ask OP [FILE]        truth, certificate, robust and formula for each question, a line of JSON each
    --engine E.mjs     also what this engine answers
  draw OP              questions with their truths; --cases N (100), --seed N, --families A,B
  certify [FILE]       check claims: lines of ask
  ops [OP]             list the operations; of one its question, answer, families and an example
    --json             all of each as JSON

Exit codes: 0 nothing found, 1 findings, 2 wrong usage or input, 3 the engine cannot be run.
`;

class UsageError extends Error {}
class EngineError extends Error {}

const text = { type: "string" };
const flag = { type: "boolean" };
const options = {
  audit: { ops: text, families: text, cases: text, "by-cost": flag, seed: text, range: text, "fail-on": text, summary: flag, json: text },
  ask: { engine: text },
  draw: { cases: text, seed: text, families: text },
  certify: {},
  ops: { json: flag },
};

const namesIn = (list) => (list === undefined ? undefined : list.split(",").filter(Boolean));
function countIn(values, name, standard) {
  const given = values[name] ?? String(standard);
  if (!/^[0-9]+$/.test(given)) throw new UsageError(`--${name} ${given}: an integer from 0`);
  return Number(given);
}
const linesOf = (file) => readFileSync(file === undefined || file === "-" ? 0 : file, "utf8").split("\n").filter((line) => line.trim());

async function engineIn(file) {
  try {
    return engineOf(await import(pathToFileURL(resolve(file))));
  } catch (failure) {
    throw new EngineError(`engine ${file}: ${failure.message}`);
  }
}

const print = (line) => void process.stdout.write(`${line}\n`);

/** Each line of a file; of a refused one the field and the rule, and 2 as the exit code. */
async function eachLine(file, answer) {
  let code = 0;
  for (const [i, line] of linesOf(file).entries()) {
    try {
      code = Math.max(code, (await answer(line)) ?? 0);
    } catch (failure) {
      if (!(failure instanceof InvalidInput)) throw failure;
      print(JSON.stringify({ error: { field: failure.field, rule: failure.rule } }));
      console.error(`touchstone: ${file ?? "standard input"}: line ${i + 1}: ${failure.message}`);
      code = 2;
    }
  }
  return code;
}

const commands = {
  async audit(t, [file], values) {
    if (file === undefined) throw new UsageError("audit: expected the file of an engine");
    if (values.range !== undefined && !["all", "ordinary"].includes(values.range))
      throw new UsageError(`--range ${values.range}: all or ordinary`);
    const run = {
      ops: namesIn(values.ops), families: namesIn(values.families), cases: countIn(values, "cases", 2000),
      seed: countIn(values, "seed", 1), by_cost: values["by-cost"] ?? false, ordinary_only: values.range === "ordinary",
      fail_on: namesIn(values["fail-on"]), summary: values.summary ?? false,
      program: "npx touchstone", options: `--engine ${file}`,
    };
    const { exit_code: code, table, tally } = await t.audit(await engineIn(file), run);
    process.stdout.write(table);
    if (values.json !== undefined) writeFileSync(values.json, `${jsonOf(tally)}\n`);
    if (code === 2) console.error("touchstone: nothing was judged");
    return code;
  },
  async ask(t, [operation, file], values) {
    if (operation === undefined) throw new UsageError("ask: expected an operation");
    const engine = values.engine === undefined ? undefined : await engineIn(values.engine);
    return eachLine(file, async (line) => {
      if (engine === undefined) return print(t.askText(operation, line));
      const [{ finding, ...judged }] = await t.judge(engine, operation, [line]);
      const { truth: _, ...said } = judged;
      print(`${t.askText(operation, line).slice(0, -1)},"engine":${jsonOf({ name: engine.name ?? "unnamed", ...said })}}`);
      return finding ? 1 : 0;
    });
  },
  draw(t, [operation], values) {
    if (operation === undefined) throw new UsageError("draw: expected an operation");
    const chosen = { families: namesIn(values.families), cases: countIn(values, "cases", 100), seed: countIn(values, "seed", 1) };
    for (const drawn of t.draw(operation, chosen)) print(jsonOf(drawn));
  },
  certify(t, [file]) {
    return eachLine(file, (line) => {
      const complaint = t.certify(line);
      print(complaint === "" ? "proved" : `refused: ${complaint}`);
      return complaint === "" ? 0 : 1;
    });
  },
  ops(t, [name], values) {
    if (values.json) return print(JSON.stringify(name === undefined ? t.operations() : t.operation(name), null, 1));
    if (name === undefined) return t.operations().forEach((each) => print(`${each.name}  ${each.question}`));
    const { question, input, answer, families, example } = t.operation(name);
    for (const [what, value] of Object.entries({ question, input, answer, example, families: families.join(", ") }))
      print(`${what.padEnd(9)} ${typeof value === "string" ? value : jsonOf(value)}`);
  },
};

async function main([command, ...rest]) {
  if (command === undefined || ["help", "--help", "-h"].includes(command)) return process.stdout.write(usage), 0;
  if (!Object.hasOwn(commands, command)) throw new UsageError(`${command}: no command; npx touchstone --help lists them`);
  let parsed;
  try {
    parsed = parseArgs({ args: rest, options: options[command], allowPositionals: true });
  } catch (failure) {
    throw new UsageError(`${command}: ${failure.message}`);
  }
  return (await commands[command](await touchstone(), parsed.positionals, parsed.values)) ?? 0;
}

process.stdout.on("error", (failure) => {
  if (failure.code !== "EPIPE") throw failure;
  process.exit();  // the reader has seen enough, as head does
});
const waits = () => {  // for nothing that can still come
  console.error("touchstone: the engine has given a promise that is never settled");
  process.exit(3);
};
process.on("beforeExit", waits);
try {
  process.exitCode = await main(process.argv.slice(2));
} catch (failure) {
  const expected = failure instanceof UsageError || failure instanceof InvalidInput || failure instanceof EngineError || failure.code === "ENOENT";
  console.error(`touchstone: ${expected ? failure.message : failure.stack}`);
  process.exitCode = failure instanceof EngineError || failure.field === "greeting" || !expected ? 3 : 2;
}
process.off("beforeExit", waits);
