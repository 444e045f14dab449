// SPDX-License-Identifier: Apache-2.0
// Walks over a failure map: a click, a drag or the arrow keys choose a square, and the page says which question
// it is and what was answered. The data of a map is what report/pages/html_map.cpp writes into its section.
(() => {
'use strict';
const around = 7, cells = 2 * around + 1, imageSide = 256;

// The palette indices of a PNG as this program writes it: 8 bits a pixel, no filter, not interlaced.
async function indices(uri) {
  const bytes = Uint8Array.from(atob(uri.slice(uri.indexOf(',') + 1)), c => c.charCodeAt(0));
  const view = new DataView(bytes.buffer), parts = [];
  for (let at = 8; at < bytes.length; at += view.getUint32(at) + 12) {
    if (view.getUint32(at + 4) === 0x49444154) parts.push(bytes.subarray(at + 8, at + 8 + view.getUint32(at)));
  }
  const rows = new Blob(parts).stream().pipeThrough(new DecompressionStream('deflate'));
  return new Uint8Array(await new Response(rows).arrayBuffer());
}

async function walk(section, map) {
  const xs = map.xs.split(' '), ys = map.ys.split(' ');
  const side = map.side, wide = imageSide / side;  // squares, and the pixels of one
  const within = n => Math.max(0, Math.min(side - 1, n));
  const images = [...section.querySelectorAll('.map img')];
  const pixels = await Promise.all(images.map(image => indices(image.getAttribute('src'))));
  const answer = (m, column, row) => map.maps[m].classes[pixels[m][wide * row * (imageSide + 1) + 1 + wide * column] >> 1];
  const filled = (text, column, row) => text.replace('{x}', xs[column]).replace('{y}', ys[row]);
  let column = side / 2, row = side / 2 - 1;

  section.insertAdjacentHTML('beforeend', `<div class="walk"><p class="small quiet screen">` +
      `Click or drag on a map, or use the arrow keys: each square is a question, and here is what was answered. ` +
      `The squares show the numbers next to it, one by one; drag the point there.</p>` +
      `<div class="lenses">${map.maps.map(one => `<figure><svg class="lens-view" viewBox="0 0 ${cells} ${cells}">` +
      `</svg><figcaption>${escaped(one.who)}</figcaption></figure>`).join('')}</div>` +
      `<div class="answers" aria-live="polite"></div></div>`);
  const lenses = [...section.querySelectorAll('.lens-view')], answers = section.querySelector('.answers');
  const crosses = images.map(image => {
    const cross = document.createElement('i');
    cross.className = 'cross';
    image.closest('.map').append(cross);
    return cross;
  });

  const show = () => {
    const percent = n => (100 * (n + 0.5) / side).toFixed(3) + '%';
    for (const cross of crosses) cross.style.left = percent(column), cross.style.top = percent(row);
    lenses.forEach((lens, m) => {
      const left = column - around, top = row - around;
      lens.innerHTML = `<image href="${images[m].currentSrc || images[m].src}" x="${-left}" y="${-top}" ` +
          `width="${side}" height="${side}" style="image-rendering:pixelated"/>` +
          `<circle class="point" cx="${around + 0.5}" cy="${around + 0.5}" r="0.42"/>`;
    });
    const truth = answer(1, column, row);
    if (!truth) {
      answers.innerHTML = '<p>Outside the contract: no question.</p>';
      return;
    }
    const row_of = (who, one) => `<tr><th scope="row">${escaped(who)}</th><td>${escaped(one.says)}</td><td>` +
        `<span class="badge ${one.verdict}">${one.verdict}</span></td></tr>`;
    answers.innerHTML = `<p>${escaped(map.x)} = <code>${xs[column]}</code>, ${escaped(map.y)} = ` +
        `<code>${ys[row]}</code></p><table class="said"><tbody><tr class="truth"><th scope="row">truth, exact</th>` +
        `<td>${escaped(truth.verdict === 'agree' ? truth.says : 'see below')}</td><td></td></tr>` +
        map.maps.map((one, m) => row_of(one.who, answer(m, column, row))).join('') + `</tbody></table>` +
        `<p class="small quiet">The input, and the line that asks it again:</p>` +
        `<pre class="input">${escaped(filled(map.input, column, row))}</pre>` +
        `<pre class="repeat">${escaped(filled(map.repeat, column, row))}</pre>`;
  };
  const go = (c, r) => {
    column = within(c);
    row = within(r);
    show();
  };
  const hold = (element, move) => {
    let held = null;
    element.addEventListener('pointerdown', event => {
      if (event.button !== 0) return;
      held = {id: event.pointerId, x: event.clientX, y: event.clientY, column, row};
      element.setPointerCapture(event.pointerId);
      move(event, held);
      event.preventDefault();
    });
    element.addEventListener('pointermove', event => { if (held && held.id === event.pointerId) move(event, held); });
    for (const end of ['pointerup', 'pointercancel', 'lostpointercapture']) {
      element.addEventListener(end, () => { held = null; });
    }
  };
  const keys = event => {
    const far = event.shiftKey ? side / 16 : 1;
    const way = {ArrowLeft: [-far, 0], ArrowRight: [far, 0], ArrowUp: [0, -far], ArrowDown: [0, far]}[event.key];
    if (!way || event.altKey || event.ctrlKey || event.metaKey) return;
    go(column + way[0], row + way[1]);
    event.preventDefault();
  };
  for (const image of images) {
    const frame = image.closest('.map');
    frame.tabIndex = 0;
    frame.classList.add('walked');
    frame.addEventListener('keydown', keys);
    hold(frame, event => {
      const box = image.getBoundingClientRect();
      go(Math.floor((event.clientX - box.left) / box.width * side),
         Math.floor((event.clientY - box.top) / box.height * side));
    });
  }
  // The point is dragged against a grid that stands still while it is held.
  for (const lens of lenses) {
    lens.tabIndex = 0;
    lens.addEventListener('keydown', keys);
    hold(lens, (event, held) => {
      const cell = lens.getBoundingClientRect().width / cells;
      go(held.column + Math.round((event.clientX - held.x) / cell),
         held.row + Math.round((event.clientY - held.y) / cell));
    });
  }
  matchMedia('(prefers-color-scheme:dark)').addEventListener('change', show);
  const asked = /^#map=(\d+),(\d+)$/.exec(location.hash);
  if (asked) section.scrollIntoView();
  go(...(asked ? asked.slice(1).map(Number) : map.start));
  section.dataset.walk = 'ready';
}

if (typeof DecompressionStream === 'undefined') return;
drawnAlone('map', walk);
})();
