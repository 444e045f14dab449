// SPDX-License-Identifier: Apache-2.0
// What the scripts of a page that draw share: each figure is drawn alone, so that none takes others with it.
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
