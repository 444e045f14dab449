// SPDX-License-Identifier: Apache-2.0
// Nanoseconds that earcut takes for each ring of SHAPES (from bench/triangulation --shapes), the least of N runs, as one JSON object:
//   node bench/earcut.mjs FOLDER SHAPES N        FOLDER: where npm installed earcut (build/npm)
import fs from 'node:fs';
import path from 'node:path';
import {createRequire} from 'node:module';
import {pathToFileURL} from 'node:url';

const [folder, shapes, runs] = process.argv.slice(2);
const found = createRequire(path.resolve(folder, 'x.js')).resolve('earcut');
const earcut = (await import(pathToFileURL(found))).default;
const times = {};
for (const [name, ring] of Object.entries(JSON.parse(fs.readFileSync(shapes, 'utf8')))) {
  times[name] = Infinity;
  for (let i = 0; i < Number(runs); ++i) {
    const start = performance.now();
    earcut(ring);
    times[name] = Math.min(times[name], 1e6 * (performance.now() - start));
  }
}
console.log(JSON.stringify(times));
