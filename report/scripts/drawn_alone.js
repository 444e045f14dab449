// SPDX-License-Identifier: Apache-2.0
// What the scripts of a page that draw share: each figure is drawn alone, so that none takes others with it; labels.
'use strict';
const escaped = text => String(text).replace(/[&<>"']/g, c => '&#' + c.charCodeAt(0) + ';');

// Draws from the data of this name into each element of the page that has it. If that fails, the page says so in the
// element, with the words for readers without scripts, and the console says so too.
function drawnAlone(name, draw) {
  for (const place of document.querySelectorAll(`[data-${name}]`)) {
    const words = place.querySelector('noscript')?.textContent ?? '';
    (async () => draw(place, JSON.parse(place.dataset[name])))().catch(error => {
      console.error(error);
      const failed = `<p class="failed">This could not be drawn: ${escaped(error)}.</p>`;
      place.insertAdjacentHTML('beforeend', failed + words);
    });
  }
}

const tenths = v => Math.floor(10 * v + 0.5) / 10;

// Each text where it covers least of what is drawn, and none of the other texts; left out where there is no room.
function placedLabels(wishes, drawn, {width, height}) {
  const farther = [0, 14, 28];  // pixels from its place that a text may stand, where there is no room near to it
  const texts = [];
  let svg = '';
  for (const wish of wishes) {
    const wide = 6.9 * [...wish.text].length;
    let best = null, least = 1000, preference = 0;
    for (const [[x, y], far] of wish.places.flatMap(place => farther.map(far => [place, far]))) {
      for (const [wx, wy] of [[1, -1], [-1, -1], [1, 1], [-1, 1], [0, -1], [0, 1], [1, 0], [-1, 0]]) {
        const gap = (wx !== 0 && wy !== 0 ? 8 * 0.7 : 8) + far;
        const left = wx > 0 ? x + gap : wx < 0 ? x - gap - wide : x - wide / 2;
        const top = wy > 0 ? y + gap : wy < 0 ? y - gap - 15 : y - 15 / 2;
        const right = left + wide, bottom = top + 15;
        let price = (preference += 0.1) + 2 * far;
        if (!(left >= 2 && top >= 2 && right <= width - 2 && bottom <= height - 2)) continue;
        for (const t of texts) if (left < t.right && t.left < right && top < t.bottom && t.top < bottom) price += 1000;
        for (const [px, py] of drawn) if (px >= left && px <= right && py >= top && py <= bottom) price += 4;
        if (price < least) least = price, best = {left, top, right, bottom};
      }
    }
    if (!best) continue;
    texts.push({left: best.left - 4, top: best.top - 1, right: best.right + 4, bottom: best.bottom + 1});
    const place = `x="${tenths(best.left)}" y="${tenths(best.bottom - 3.5)}"`;
    svg += `<text class="${wish.style}" ${place}>${escaped(wish.text)}</text>`;
  }
  return svg;
}
