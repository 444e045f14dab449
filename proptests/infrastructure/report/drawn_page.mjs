// SPDX-License-Identifier: Apache-2.0
// Runs the script of a page with figures in space in node and prints what is drawn of each figure, a line of JSON.
//
// drawn_page.mjs PAGE
import {readFileSync} from 'node:fs';
import {Element, documentOf, plain} from './browser.mjs';

const page = readFileSync(process.argv[2], 'utf8');
const places = [...page.matchAll(/<div class="space-figure" data-space="([^"]*)"/g)].map(found => {
  const place = new Element();
  place.dataset.space = plain(found[1]);
  return place;
});
globalThis.document = documentOf({'[data-space]': places});
(0, eval)(/<script>([\s\S]*)<\/script>/.exec(page)[1]);
for (const place of places) console.log(JSON.stringify(place.innerHTML));
