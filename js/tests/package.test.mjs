// SPDX-License-Identifier: Apache-2.0
// What users of the package have of it: node --test, in a project in which it is installed.
import assert from "node:assert/strict";
import { spawnSync } from "node:child_process";
import { mkdtempSync, readFileSync, writeFileSync } from "node:fs";
import { tmpdir } from "node:os";
import { join } from "node:path";
import test from "node:test";

import touchstone, { InvalidInput } from "touchstone";
import arbitraries from "touchstone/arbitraries";
import inWorker from "touchstone/worker";

const t = await touchstone();

const question = { p0: [0, 0], p1: [0.3, 0.3], p: [0.1, 0.1] };
const side = ({ p0, p1, p }) => (p1[0] - p0[0]) * (p[1] - p0[1]) - (p1[1] - p0[1]) * (p[0] - p0[0]);
const sideOf = (asked) => ["right", "on", "left"][1 + Math.sign(side(asked))];
const naive = { name: "naive 1.0", boundary: "closed", orientation: (asked) => ({ side: sideOf(asked) }) };

test("a question has an exact answer with a proof, and -0 is not 0", () => {
  const asked = t.ask("orientation", question);
  assert.deepEqual(asked.truth, { side: "on" });
  assert.equal(asked.robust.verdict, "agree");
  assert.equal(t.certify(asked), "");
  assert.notEqual(t.certify({ ...asked, truth: { side: "left" } }), "");
  assert.match(t.askText("orientation", { p0: [-0, 0], p1: new Float64Array([1, 1]), p: [2, 2] }), /"p0":\[-0(\.0)?,0\]/);
});

test("decimals are answered as typed", () => {
  const explained = t.explain("orientation", '{"p0":[0,0],"p1":[0.3,0.9],"p":[0.1,0.3]}');
  assert.deepEqual(explained.as_typed.truth, { side: "on" });
  assert.deepEqual(explained.truth, { side: "right" });
  assert.equal(explained.checker, "");
  assert.equal(explained.sentence, "right of the line");
});

test("what is outside the contract is refused by field and rule", () => {
  const refused = (of) => (failure) => failure instanceof InvalidInput && failure.field === of;
  assert.throws(() => t.ask("orientation", { ...question, p: [0, NaN] }), refused("p[1]"));
  assert.throws(() => t.ask("orientatoin", question), /did you mean "orientation"/);
  assert.throws(() => t.operation("orientatoin"), refused("operation"));
  assert.ok(!t.accepts("orientation", {}));
});

test("a scene is played in three arithmetics", () => {
  const scene = {
    touchstone_scene: 1, title: "a fall", gravity: [0, 0, -1], advance: { timestep: 0.5, steps: 4, option: 2 },
    bodies: [{ name: "stone", shape: { particle: {} }, position: [0, 0, 8] }],
  };
  const played = t.simulate(scene, { steps: 3 });
  assert.match(played.summary, /robust/);
  assert.match(played.page, /^<!DOCTYPE html>[^]*a fall/i);
  assert.throws(() => t.simulate(scene, { runs: ["quad"] }), (failure) => failure.field === "options.runs");
  assert.throws(() => t.simulate({ touchstone_scene: 1 }), InvalidInput);
});

test("draw is an iterator, and longer lists begin with shorter ones", () => {
  const few = [...t.draw("orientation", { cases: 300, seed: 7 })];
  assert.equal(few.length, 300);
  let seen = 0;
  for (const drawn of t.draw("orientation", { cases: Infinity, seed: 7 })) {
    assert.deepEqual(drawn, few[seen]);
    if (++seen === 300) break;
  }
  assert.ok([...t.draw("orientation", { families: ["collinear"], cases: 5 })].every((drawn) => drawn.truth.side === "on"));
});

test("an engine is judged in process, by a number of cases or by questions", async () => {
  const audit = await t.judge(naive, "orientation", 300);
  assert.equal(audit.exit_code, 1);
  assert.match(audit.table, /^touchstone audit of naive 1\.0 \(binary64\), boundary closed; 300 cases/);
  const [right, wrong] = await t.judge(naive, "orientation", [question, { p0: [0, 0], p1: [1e-200, 0], p: [0, 1e-200] }]);
  assert.equal(right.verdict, "agree");
  assert.ok(wrong.finding && wrong.cause === "rounding", JSON.stringify(wrong));
});

test("promises give the same verdicts, words stand alone, and failures are invalid", async () => {
  const options = { ops: ["orientation"], cases: 200 };
  const now = await t.audit(naive, options);
  const later = await t.audit({ ...naive, orientation: async (asked) => naive.orientation(asked) }, options);
  const counted = ({ tally }) => tally.operations[0].families.map(({ counts }) => counts);
  assert.deepEqual(counted(later), counted(now));
  const [thrown] = await t.judge({ orientation: () => { throw new Error("no"); } }, "orientation", [question]);
  assert.deepEqual([thrown.verdict, thrown.remark], ["invalid", "error: no"]);
  const [alone] = await t.judge({ orientation: () => "on" }, "orientation", [question]);
  assert.equal(alone.verdict, "agree");
  const [absent] = await t.judge({ orientation: () => undefined }, "orientation", [question]);
  assert.equal(absent.verdict, "unsupported");
  await assert.rejects(t.audit({ orientation: 3 }, options), InvalidInput);
});

test("a finding shrinks, of the formula and of an engine", async () => {
  const long = { p0: [0.1234567, -17.03125], p1: [12345.678, 0.000123], p: [3.25, 1e17] };
  const left = { orientation: () => ({ side: "right" }) };
  const { input, finished } = await t.shrink("orientation", long, { engine: left });
  assert.ok(finished && JSON.stringify(input).length < JSON.stringify(long).length, JSON.stringify(input));
  await assert.rejects(t.shrink("orientation", { p0: [0, 0], p1: [1, 0], p: [0, 1] }), InvalidInput);
});

test("figures, and maps of the neighbours", () => {
  assert.match(t.drawing("orientation", question).svg, /<svg/);
  const { fields, verdicts, truths } = t.map("orientation", question, { axes: [4, 5], side: 5 });
  assert.deepEqual(fields, ["p[0]", "p[1]"]);
  assert.deepEqual([verdicts.length, truths[2][2]], [5, "on"]);
});

test("texts: WKT in, a regression test out", () => {
  assert.equal(t.read("segment_segment", "LINESTRING (0 0, 2 0); LINESTRING (1 0, 0.10 3)"), '{"a":[[0,0],[2,0]],"b":[[1,0],[0.10,3]]}');
  assert.match(t.regressionTest("orientation", question), /my_orientation/);
});

test("vectors are told from points", () => {
  const { meanings } = t.operation("ray_triangle");
  assert.deepEqual(meanings.ray, { origin: ["place", "place", "place"], direction: ["direction", "direction", "direction"] });
});

test("a worker answers the same, and takes engines by address", async () => {
  const worker = await inWorker();
  assert.deepEqual(await worker.ask("orientation", question), t.ask("orientation", question));
  await assert.rejects(worker.ask("orientation", {}), InvalidInput);
  const source = "export const orientation = () => 'left';";
  const [judged] = await worker.judge(`data:text/javascript,${encodeURIComponent(source)}`, "orientation", [question]);
  assert.equal(judged.verdict, "wrong");
  assert.equal((await worker.draw("orientation", { cases: 3 })).length, 3);
  const waiting = worker.ask("orientation", question);
  worker.terminate();
  await assert.rejects(waiting, /^Error: the worker was ended$/);
  await assert.rejects(worker.ask("orientation", question), /^Error: the worker was ended$/);
});

test("fast-check: questions of families and raw ones, which shrink", async () => {
  const fc = await import("fast-check");
  const { questions, raw } = arbitraries(fc, t);
  fc.assert(fc.property(questions("orientation"), (asked) => t.answer("orientation", asked).side.length > 0), { numRuns: 200, seed: 1 });
  const wrong = (asked) => sideOf(asked) === t.answer("orientation", asked).side;
  const found = fc.check(fc.property(questions("orientation"), wrong), { numRuns: 2000, seed: 1 });
  assert.ok(found.failed && found.counterexample !== null);
  fc.assert(fc.property(raw("segment_segment"), (asked) => t.accepts("segment_segment", asked)), { numRuns: 100, seed: 1 });
});

const cli = join(process.cwd(), "node_modules", "touchstone", "cli.mjs");
const folder = mkdtempSync(join(tmpdir(), "touchstone-"));
const run = (given, input = "") => spawnSync(process.execPath, [cli, ...given], { encoding: "utf8", input });
function engineFile(name, source) {
  const file = join(folder, `${name}.mjs`);
  writeFileSync(file, source);
  return file;
}

test("the command has the table and the exit codes of the program", () => {
  const engine = engineFile("left", `export default { name: "left", orientation: () => "left" };`);
  const audited = run(["audit", engine, "--cases", "50", "--json", join(folder, "tally.json")]);
  assert.equal(audited.status, 1, audited.stderr);
  assert.match(audited.stdout, /^touchstone audit of left/);
  assert.equal(JSON.parse(readFileSync(join(folder, "tally.json"), "utf8")).kind, "tally");
  assert.equal(run(["audit", engine, "--cases", "50", "--fail-on", "invalid"]).status, 0);
  assert.equal(run(["audit", engine, "--ops", "ray_aabb"]).status, 3);
  assert.equal(run(["audit", join(folder, "none.mjs")]).status, 3);
  assert.equal(run(["audit"]).status, 2);
  assert.equal(run(["adit"]).status, 2);
  assert.equal(run(["audit", engine, "--case", "5"]).status, 2);
  const asked = run(["ask", "orientation"], JSON.stringify(question));
  assert.equal(asked.stdout.trim(), t.askText("orientation", question));
  assert.equal(asked.status, 0);
  assert.equal(run(["certify"], asked.stdout).stdout, "proved\n");
  assert.equal(run(["ask", "orientation"], "{}").status, 2);
  assert.match(run(["ask", "orientation"], "p0: 0 0\n").stdout, /not JSON: unexpected \\"p\\" in column 1/);
  assert.equal(run(["ask", "orientation", "--engine", engine], JSON.stringify(question)).status, 1);
});

test("the command prints -0, in questions and in a tally", () => {
  const drawn = run(["draw", "orientation", "--cases", "40"]);
  assert.match(drawn.stdout, /-0\.0/);
  assert.deepEqual(drawn.stdout.trim().split("\n").map((line) => JSON.parse(line)), [...t.draw("orientation", { cases: 40 })]);
  const engine = engineFile("wrong", "export const segment_segment = () => ({ relation: 'point', ta: -0 });");
  const file = join(folder, "tally.json");
  run(["audit", engine, "--families", "zero_length", "--cases", "20", "--json", file]);
  assert.match(readFileSync(file, "utf8"), /-0\.0/);
});

test("an engine that settles no promise cannot be run", () => {
  const audited = run(["audit", engineFile("silent", "export const orientation = () => new Promise(() => {});")]);
  assert.deepEqual([audited.status, audited.stderr], [3, "touchstone: the engine has given a promise that is never settled\n"]);
});
