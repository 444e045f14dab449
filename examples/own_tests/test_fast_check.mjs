// SPDX-License-Identifier: Apache-2.0
// fast-check with questions of touchstone: npm install, then node test_fast_check.mjs. The environment variable TOUCHSTONE
// names the program where it is not on the path.
import { execFileSync } from "node:child_process";
import assert from "node:assert/strict";
import { createRequire } from "node:module";

let fc;
try {
  fc = createRequire(import.meta.url)("fast-check");
} catch {
  console.log("skipped: fast-check is not installed (npm install in this folder)");
  process.exit(77);
}

/// An arbitrary of questions with their truth; shrinks to short ones.
function questions(operation, { cases = 500, families = "", seed = 1 } = {}) {
  const options = ["draw", operation, "--cases", String(cases), "--seed", String(seed)];
  if (families) options.push("--families", families);
  const program = process.env.TOUCHSTONE ?? "touchstone";
  const lines = execFileSync(program, options, { encoding: "utf8", maxBuffer: 1 << 28 }).trimEnd().split("\n");
  return fc.constantFrom(...lines.sort((a, b) => a.length - b.length).map((line) => JSON.parse(line)));
}

/// Closed axis-aligned boxes: touching is meeting.
const boxesMeet = (a, b) => a.min.every((m, i) => m <= b.max[i]) && b.min.every((m, i) => m <= a.max[i]);
/// Taken for boxesMeet, this is a bug.
const boxesOverlap = (a, b) => a.min.every((m, i) => m < b.max[i]) && b.min.every((m, i) => m < a.max[i]);

const agrees = (meet) => ({ input, truth }) => meet(input.a, input.b) === (truth.contact !== "disjoint");
const boxes = questions("aabb_aabb");
const parameters = { seed: 1, numRuns: 500 };

fc.assert(fc.property(boxes, agrees(boxesMeet)), parameters);
console.log("boxesMeet: right");

const found = fc.check(fc.property(boxes, agrees(boxesOverlap)), parameters);
assert(found.failed, "boxes that touch were not told from boxes that do not");
assert.equal(found.counterexample[0].truth.contact, "touching");
console.log("boxesOverlap:", JSON.stringify(found.counterexample[0]));
