// SPDX-License-Identifier: Apache-2.0
// Audits packages from npm: node engine.mjs robust-segment-intersect | robust-orientation | robust-predicates | earcut
import { createRequire } from "node:module";
import { createInterface } from "node:readline";

const require = createRequire(import.meta.url);
const name = process.argv[2];

/** Where a number's sign lies, for packages that answer with a signed area. */
const side = (left) => ({ side: left > 0 ? "left" : left < 0 ? "right" : "on" });

const packages = {
  "robust-segment-intersect": () => {
    const intersect = require("robust-segment-intersect");
    return { segment_segment: ({ a, b }) => intersect(a[0], a[1], b[0], b[1]) };
  },
  // Negative for a positively oriented (counter-clockwise) triple.
  "robust-orientation": () => {
    const orient = require("robust-orientation");
    return { orientation: ({ p0, p1, p }) => side(-orient[3](p0, p1, p)) };
  },
  // Positive for counter-clockwise where y points down, so negative where it points up.
  "robust-predicates": () => {
    const { orient2d } = require("robust-predicates");
    return { orientation: ({ p0, p1, p }) => side(-orient2d(...p0, ...p1, ...p)) };
  },
  // A flat list of corners, counter-clockwise where y points up.
  earcut: async () => {
    const { default: earcut } = await import("earcut");
    const threes = (list) => Array.from({ length: list.length / 3 }, (_, i) => list.slice(3 * i, 3 * i + 3));
    return { triangulate_polygon: ({ polygon }) => ({ triangles: threes(earcut(polygon.flat())) }) };
  },
};

if (!(name in packages)) {
  console.error(`usage: node engine.mjs ${Object.keys(packages).join(" | ")}`);
  process.exit(2);
}
const operations = await packages[name]();
const version = require("./package.json").dependencies[name];
const say = (line) => process.stdout.write(JSON.stringify(line) + "\n");

let greeted = false;
for await (const line of createInterface({ input: process.stdin })) {
  if (!greeted) {
    greeted = true;
    say({ engine: `${name} ${version}`, ops: Object.keys(operations), number: "binary64", boundary: "closed", tolerance: 0 });
    continue;
  }
  const { id, op, input } = JSON.parse(line);
  try {
    say(op in operations ? { id, answer: operations[op](input) } : { id, unsupported: true });
  } catch (error) {
    say({ id, error: String(error) });
  }
}
