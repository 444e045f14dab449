// SPDX-License-Identifier: Apache-2.0
// A button in each view of a figure saves it as an SVG file, as the reader has turned it, with the page's rules for
// figures in it, in the colours of paper.
'use strict';
function figureAsSvg(svg) {
  const copy = svg.cloneNode(true), style = document.createElementNS('http://www.w3.org/2000/svg', 'style');
  const rules = [...document.styleSheets].flatMap(sheet => [...sheet.cssRules]);
  style.textContent = rules.filter(rule => /^:root|\.fig|\.space/.test(rule.selectorText ?? ''))
      .map(rule => rule.cssText.replace('color-scheme: light dark;', '')).join('\n');
  copy.prepend(style);
  return new XMLSerializer().serializeToString(copy);
}

// How far the view goes on to the right of its frame, in percent of its width.
function beyondFrame(svg) {
  const frame = svg.querySelector('.frame'), {x, width} = svg.viewBox.baseVal;
  if (!frame || !width) return 0;
  const shift = frame.closest('[transform]')?.transform.baseVal.consolidate()?.matrix.e ?? 0;
  return 100 - 100 * (shift + frame.x.baseVal.value + frame.width.baseVal.value - x) / width;
}

document.querySelectorAll('.view').forEach((view, i) => {
  view.insertAdjacentHTML('beforeend', '<button class="save screen" type="button" title="Save as SVG">SVG</button>');
  view.style.setProperty('--beyond', beyondFrame(view.querySelector('svg')) + '%');
  view.querySelector('.save').addEventListener('click', () => {
    const link = document.createElement('a');
    link.href = URL.createObjectURL(new Blob([figureAsSvg(view.querySelector('svg'))], {type: 'image/svg+xml'}));
    link.download = `${document.title.replace(/\W+/g, '_')}_${i + 1}.svg`;
    link.click();
    URL.revokeObjectURL(link.href);
  });
});
