// SPDX-License-Identifier: Apache-2.0
// An engine in JavaScript: touchstone audit --engine "node examples/engine.mjs"
import { createInterface } from "node:readline";

const side = (p, q, r) => (q[0] - p[0]) * (r[1] - p[1]) - (q[1] - p[1]) * (r[0] - p[0]);

const operations = {
  orientation: ({ p0, p1, p }) => {
    const s = side(p0, p1, p);
    return { side: s > 0 ? "left" : s < 0 ? "right" : "on" };
  },
  // A plain answer to "do they meet?"
  segment_segment: ({ a, b }) =>
    side(...a, b[0]) * side(...a, b[1]) <= 0 && side(...b, a[0]) * side(...b, a[1]) <= 0,
};

const say = (line) => process.stdout.write(JSON.stringify(line) + "\n");

let greeted = false;
for await (const line of createInterface({ input: process.stdin })) {
  const { id, op, input } = JSON.parse(line);
  say(greeted ? { id, answer: operations[op](input) }
              : { engine: "textbook in JavaScript", ops: Object.keys(operations), boundary: "closed" });
  greeted = true;
}
