// SPDX-License-Identifier: Apache-2.0
// Packages from npm make the steps of a scene: touchstone simulate SCENE --engine "node simulate.mjs NAME", a name of
// `packages` below (docs/simulate.md).
import { createRequire } from "node:module";
import { createInterface } from "node:readline";

console.log = console.error;  // what a package prints is no answer
const require = createRequire(import.meta.url);

/** Each with the file that has `hello` and `start(scene)`, which returns {step(met), body(i)}. `met(a, b)` says that an
 * impulse was used between them, a wall having the number of bodies added to its place. */
const packages = {
  "planck": "./steps_planck.mjs",
  "matter-js": "./steps_matter.mjs",
  "cannon-es": "./steps_cannon.mjs",
  "@dimforge/rapier3d-compat": "./steps_rapier3d.mjs",
};

const name = process.argv[2];
if (!(name in packages)) {
  console.error(`usage: simulate.mjs ${Object.keys(packages).join(" | ")}`);
  process.exit(2);
}
const { hello, start } = await import(packages[name]);

/** package.json is not among the exports of each package. */
function version() {
  const folder = require.resolve.paths(name).map((path) => `${path}/${name}/package.json`);
  for (const file of folder) {
    try {
      return require(file).version;
    } catch {
      continue;
    }
  }
  return "?";
}

const say = (line) => process.stdout.write(JSON.stringify(line) + "\n");
let engine, bodies = 0;
for await (const line of createInterface({ input: process.stdin })) {
  const said = JSON.parse(line);
  if (said.scene) {
    say({ engine: `${name} ${version()}`, ...hello });
    for (const wall of said.scene.walls) {
      const length = Math.hypot(...wall.normal);
      wall.normal = wall.normal.map((x) => x / length);
      wall.offset /= length;
    }
    bodies = said.scene.bodies.length;
    engine = await start(said.scene);
    continue;
  }
  const pairs = new Map();
  engine.step((a, b) => pairs.set(`${Math.min(a, b)} ${Math.max(a, b)}`, [Math.min(a, b), Math.max(a, b)]));
  const contacts = [...pairs.values()].filter(([a]) => a < bodies).map(([body, other]) =>
    (other < bodies ? { body, other } : { body, wall: other - bodies }));
  say({ step: said.step, bodies: Array.from({ length: bodies }, (_, i) => engine.body(i)), contacts });
}
