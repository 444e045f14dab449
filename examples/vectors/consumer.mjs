// SPDX-License-Identifier: Apache-2.0
// Test vectors from JavaScript: node consumer.mjs VECTORS prints the id of every vector that a function below gets wrong.
import { readFileSync } from "node:fs";

const functions = {
  orientation: ({ p0, p1, p }) => {
    const cross = (p1[0] - p0[0]) * (p[1] - p0[1]) - (p1[1] - p0[1]) * (p[0] - p0[0]);
    return { side: cross > 0 ? "left" : cross < 0 ? "right" : "on" };
  },
  line_point_at: ({ line: { origin, direction }, t }) => ({ point: origin.map((o, i) => o + t * direction[i]) }),
};

// The unit in the last place of a finite double, by its exponent.
const view = new DataView(new ArrayBuffer(8));
const ulp = (x) => (view.setFloat64(0, x), 2 ** (Math.max((view.getUint16(0) >> 4) & 0x7ff, 1) - 1075));
const number = (x) => (x === "inf" ? Infinity : x === "-inf" ? -Infinity : x);

// Words are equal; numbers are at most two units in the last place apart. "inf" is the double infinity.
function same(mine, right) {
  if (typeof mine === "number") {
    const exact = number(right);
    return mine === exact || (Number.isFinite(exact) && Math.abs(mine - exact) <= 2 * ulp(exact));
  }
  if (typeof right !== "object") return mine === right;
  const names = Object.keys(right);
  return Object.keys(mine).length === names.length && names.every((name) => same(mine[name], right[name]));
}

for (const [name, answer] of Object.entries(functions)) {
  let asked = 0, wrong = 0;
  for (const line of readFileSync(`${process.argv[2]}/${name}.jsonl`, "utf8").trim().split("\n")) {
    const { id, input, rounded, flags, refused } = JSON.parse(line);
    if (refused) continue; // outside the contract: what you do there is yours to say
    asked++;
    if (!same(answer(input), rounded)) wrong++, console.log([id, ...flags].join(" "));
  }
  console.log(`${name}: ${asked} asked, ${wrong} wrong`);
}
