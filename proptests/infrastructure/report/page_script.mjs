// SPDX-License-Identifier: Apache-2.0
// Runs the script of a page with failure maps in node, and does what a reader does. Each step ("click M X Y",
// "key NAME [shift]", "drag DX DY": pixels of maps and lenses 512 and 150 wide) prints one line of JSON: what the page
// shows then.
//
// page_script.mjs PAGE FIRST-HASH STEP...
import {readFileSync} from 'node:fs';
import {Element, documentOf, plain} from './browser.mjs';

const [file, hash, ...steps] = process.argv.slice(2);
const page = readFileSync(file, 'utf8');

class Section extends Element {
  insertAdjacentHTML(_, html) {
    this.parts['.lens-view'] = html.match(/class="lens-view"/g).map(() => new Element(150));
    this.parts['.answers'] = [new Element()];
  }
}

const section = new Section();
section.dataset.map = plain(/<div class="mapped" data-map="([^"]*)"/.exec(page)[1]);
section.parts['.map img'] = [...page.matchAll(/<div class="map">.*?<img [^>]*? src="([^"]*)"/gs)].map(found => {
  const image = new Element(512);
  image.frame = new Element(512);
  image.attributes.src = found[1];
  return image;
});
globalThis.document = documentOf({'[data-map]': [section]});
globalThis.location = {hash};
globalThis.matchMedia = () => ({addEventListener() {}});
(0, eval)(/<script>([\s\S]*)<\/script>/.exec(page)[1]);
while (section.dataset.walk !== 'ready') await new Promise(resolve => setImmediate(resolve));

const images = section.parts['.map img'], lenses = section.parts['.lens-view'];
const show = () => {
  const html = section.parts['.answers'][0].innerHTML;
  const rows = [...html.matchAll(/<tr[^>]*><th[^>]*>(.*?)<\/th><td>(.*?)<\/td><td>(.*?)<\/td><\/tr>/g)];
  console.log(JSON.stringify({
    input: plain(/<pre class="input">(.*?)<\/pre>/.exec(html)?.[1] ?? ''),
    repeat: plain(/<pre class="repeat">(.*?)<\/pre>/.exec(html)?.[1] ?? ''),
    answers: rows.map(row => row.slice(1).map(plain)),
    cross: images.map(image => [image.frame.child.style.left, image.frame.child.style.top]),
    scrolled: section.scrolled ?? false,
  }));
};
show();
for (const step of steps) {
  const [what, a, b, c] = step.split(' ');
  if (what === 'click') {
    images[a].frame.send('pointerdown', {clientX: +b, clientY: +c});
    images[a].frame.send('pointerup', {});
  } else if (what === 'key') {
    images[0].frame.send('keydown', {key: a, shiftKey: b === 'shift'});
  } else if (what === 'drag') {
    lenses[0].send('pointerdown', {clientX: 75, clientY: 75});
    lenses[0].send('pointermove', {clientX: 75 + +a, clientY: 75 + +b});
    lenses[0].send('pointerup', {});
  }
  show();
}
