// SPDX-License-Identifier: Apache-2.0
// What needs no WebAssembly module: all sources parse, and what they do with text and with engines.
import assert from "node:assert/strict";
import { spawnSync } from "node:child_process";
import { readdirSync } from "node:fs";
import { fileURLToPath } from "node:url";

import { InvalidInput, jsonOf, textOf } from "../core.mjs";
import { engineOf, greetingOf } from "../engine.mjs";

const folder = new URL("..", import.meta.url);
const scripts = (of) => readdirSync(of).filter((name) => name.endsWith(".mjs")).map((name) => fileURLToPath(new URL(name, of)));
for (const script of [...scripts(folder), ...scripts(new URL("tests/", folder))]) {
  const { status, stderr } = spawnSync(process.execPath, ["--check", script], { encoding: "utf8" });
  assert.equal(status, 0, stderr);
}

assert.equal(jsonOf({ a: [0, -0, 1e300, 0.1], b: true, c: undefined, d: null, e: 'a "b"' }), '{"a":[0,-0.0,1e+300,0.1],"b":true,"d":null,"e":"a \\"b\\""}');
assert.equal(jsonOf([NaN, Infinity, -Infinity]), '["nan","inf","-inf"]');
assert.equal(jsonOf({ p: new Float32Array([0.5, -0]) }), '{"p":[0.5,-0.0]}');
assert.equal(textOf('{"p":[0.10]}'), '{"p":[0.10]}');

const known = { operations: () => [{ name: "orientation" }, { name: "segment_segment" }] };
const engine = { name: "mine", boundary: "closed", orientation: () => "on", helper: () => 1, segment_segment: 2 };
assert.deepEqual(greetingOf(known, engine), { engine: "mine", ops: ["orientation"], boundary: "closed" });
assert.deepEqual(greetingOf(known, engineOf({ orientation: () => "on" })).ops, ["orientation"]);
assert.equal(engineOf({ default: engine }), engine);
assert.throws(() => greetingOf(known, "mine"), TypeError);
assert.deepEqual({ ...new InvalidInput("p[0]", "finite number") }, { name: "InvalidInput", field: "p[0]", rule: "finite number" });
console.log("the sources of the npm package are as they should be");
