// SPDX-License-Identifier: Apache-2.0
// The module against the test vectors and the program: node same.mjs PACKAGE VECTORS [--program TOUCHSTONE] [--share N]
//
// Of every N-th vector (1: all) truth, margin, certificate and rounded answer must be the vector's bytes, robust must
// agree and the checker accept the claim, and refuse it with another truth where one answer alone is right. With the
// program, the operations must be its own, or those of some chapters, all lines of `ask` its bytes but for what the
// textbook formula answers, and so must the questions that `draw` prints.
import { spawnSync } from "node:child_process";
import { readdirSync, readFileSync } from "node:fs";
import { join, resolve } from "node:path";
import { pathToFileURL } from "node:url";
import { parseArgs } from "node:util";

const { values, positionals: [folder, vectors] } =
  parseArgs({ allowPositionals: true, options: { program: { type: "string" }, share: { type: "string", default: "1" } } });
const { default: touchstone } = await import(pathToFileURL(resolve(folder, "index.mjs")));
const began = performance.now();
const t = await touchstone();
console.log(`ready in ${Math.round(performance.now() - began)} ms`);

let differences = 0;
function differs(what, got, wanted) {
  if (++differences <= 20) console.log(`${what}\n  got    ${got}\n  wanted ${wanted}`);
}
/** The text of a field of a line of JSON, which ends where the next of these fields begins. */
function field(line, name, ...next) {
  const begin = line.indexOf(`"${name}":`);
  const ends = next.map((each) => line.indexOf(`,"${each}":`, begin)).filter((at) => at >= 0);
  return begin < 0 ? "" : line.slice(begin, ends.length ? Math.min(...ends) : line.lastIndexOf("}"));
}
/** Large meshes of vectors are files of their own. */
const withMeshes = (input) =>
  input.replace(/"(meshes\/[^"]+)"/g, (_, file) => readFileSync(join(vectors, file), "utf8").replace(/\s+/g, ""));
function refusal(ask) {
  try {
    return ask();
  } catch (failure) {
    return `"refused":${JSON.stringify({ field: failure.field, rule: failure.rule })}`;
  }
}
function program(...given) {
  const { stdout, status, stderr } = spawnSync(values.program, given, { encoding: "utf8", maxBuffer: 1 << 30 });
  if (status === 2 || status === null) throw new Error(`${given.join(" ")}: ${stderr}`);
  return stdout.split("\n").slice(0, -1);
}
/** A line of `ask` without the formulas: those compute with the C library's sines. */
const withoutFormula = (line) => line.replace(/,"reference.*$/, "");

const listed = t.operations();
if (values.program) {
  const chapters = new Set(listed.map(({ chapter }) => chapter));
  const wanted = JSON.parse(program("ops", "--json").join("")).filter(({ chapter }) => chapters.has(chapter));
  const [here, there] = [listed, wanted].map((all) => all.map(({ name }) => name).join(" "));
  if (here !== there) differs("operations", here, there);
}
const names = new Set(listed.map(({ name }) => name));

const counted = { vectors: 0, refused: 0, lines: 0, formulas: 0, drawn: 0 };
for (const file of readdirSync(vectors).filter((name) => name.endsWith(".jsonl")).sort()) {
  const name = file.slice(0, -".jsonl".length);
  if (!names.has(name)) continue;
  const chosen = readFileSync(join(vectors, file), "utf8").split("\n").slice(0, -1).filter((_, i) => i % Number(values.share) === 0);
  const questions = [], asked = [];
  const isOneOfMany = t.operation(name).kind === "checked"; // another right answer has the same certificate
  const truths = chosen.map((line) => field(line, "truth", "rounded")).filter(Boolean);
  for (const [i, line] of chosen.entries()) {
    const wanted = field(line, "truth", "rounded");
    const input = withMeshes(field(line, "input", "truth", "refused").slice('"input":'.length));
    ++counted.vectors;
    if (!wanted) {
      const outside = refusal(() => t.askText(name, input));
      if (outside !== field(line, "refused", "flags")) differs(`${name} ${i}: refused`, outside, line);
      continue;
    }
    const got = t.askText(name, input);
    questions.push(input), asked.push(got);
    for (const [part, ...next] of [["truth", "rounded", "margin", "certificate", "robust"], ["margin", "certificate", "flags", "robust"],
                                   ["certificate", "flags", "robust"]]) {
      const [here, there] = [field(got, part, ...next), field(line, part, ...next)];
      if (here !== there) differs(`${name} ${i}: ${part}`, here, there);
    }
    const { robust } = JSON.parse(got);
    if (robust.verdict !== "agree") differs(`${name} ${i}: robust`, JSON.stringify(robust), "agree");
    if (t.certify(got) !== "") differs(`${name} ${i}: certify`, t.certify(got), "");
    const other = truths.find((each) => each !== wanted);
    if (other === undefined || isOneOfMany) continue;
    ++counted.refused;
    if (t.certify(got.replace(wanted, other)) === "") differs(`${name} ${i}: certify`, "accepted", other);
  }
  if (!values.program) continue;
  const native = spawnSync(values.program, ["ask", name], { input: questions.join("\n") + "\n", encoding: "utf8", maxBuffer: 1 << 30 });
  for (const [i, line] of native.stdout.split("\n").slice(0, -1).entries()) {
    ++counted.lines;
    if (line !== asked[i]) ++counted.formulas;
    if (withoutFormula(line) !== withoutFormula(asked[i])) differs(`${name} ${i}: ask`, asked[i], line);
  }
  const { families } = t.operation(name);
  const drawn = [...t.draw(name, { cases: 2 * families.length })];
  for (const [i, line] of program("draw", name, "--cases", String(2 * families.length)).entries()) {
    ++counted.drawn;
    const wanted = JSON.parse(line);
    for (const part of ["family", "index", "input", "truth"])
      if (JSON.stringify(drawn[i][part]) !== JSON.stringify(wanted[part])) differs(`${name}: draw ${i}`, JSON.stringify(drawn[i]), line);
  }
}
console.log(`${counted.vectors} vectors, ${counted.refused} false claims; with the program: ${counted.lines} lines of ask, of which ` +
            `${counted.formulas} differ in a formula's answer; ${counted.drawn} drawn; ${differences} differences`);
process.exitCode = differences === 0 ? 0 : 1;
