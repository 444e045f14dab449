// SPDX-License-Identifier: Apache-2.0
#include "report/space_script.h"

namespace touchstone::audit {

const char* const space_script = R"js(
(() => {
'use strict';
const tenths = v => Math.floor(10 * v + 0.5) / 10;
const pair = (x, y) => tenths(x) + ' ' + tenths(y);
const escaped = text => text.replace(/&/g, '&amp;').replace(/</g, '&lt;');
const diagonal = 0.7071067811865476, diagonals = [[1, -1], [-1, -1], [1, 1], [-1, 1]];

function read(data) {
  const model = {points: [], items: [], labels: []};
  for (const record of data.split(';')) {
    const [kind, ...words] = record.split(' '), style = words[0];
    if (kind === 'v') model.view = words.map(Number);
    else if (kind === 'p') model.points.push(words.map(Number));
    else if (kind !== 't') model.items.push({kind, style, n: words.slice(1).map(Number)});
    else {
      const end = 3 + Number(words[2]);
      model.labels.push({style, radius: Number(words[1]), places: words.slice(3, end).map(Number),
                         text: words.slice(end).join(' ')});
    }
  }
  return model;
}

function picture(model, cosYaw, sinYaw, cosPitch, sinPitch) {
  const [width, height, room, reach] = model.view, scale = room / reach;
  const direction = (x, y, z) => {
    const forth = sinYaw * x + cosYaw * z;
    return {x: cosYaw * x - sinYaw * z, y: cosPitch * y - sinPitch * forth, depth: sinPitch * y + cosPitch * forth};
  };
  const seen = model.points.map(p => {
    const way = direction(p[0], p[1], p[2]);
    return {x: width / 2 + way.x * scale, y: height / 2 - way.y * scale, depth: way.depth * scale};
  });
  const strokes = [], drawn = [];
  const add = (depth, svg) => strokes.push({depth, svg});
  const faces = model.items.filter(item => item.kind === 'f').map(item => {
    let area = 0, depth = 0;
    item.n.forEach((i, k) => {
      const p = seen[i], q = seen[item.n[(k + 1) % item.n.length]];
      area += p.x * q.y - q.x * p.y;
      depth += p.depth;
    });
    return {depth: depth / item.n.length, away: area > 0};
  });
  const line = (a, b, depth, style) => {
    const dx = b.x - a.x, dy = b.y - a.y, steps = Math.floor(Math.sqrt(dx * dx + dy * dy) / 5) + 1;
    for (let i = 0; i <= steps; ++i) drawn.push([a.x + i / steps * dx, a.y + i / steps * dy]);
    add(depth, `<path class="${style}" d="M${pair(a.x, a.y)}L${pair(b.x, b.y)}"/>`);
  };
  const dot = (item, radius, kind) => {
    const p = seen[item.n[0]];
    for (const dy of [-1, 0, 1]) for (const dx of [-1, 0, 1]) drawn.push([p.x + radius * dx, p.y + radius * dy]);
    add(p.depth + 0.5, `<circle class="${item.style} ${kind}" cx="${tenths(p.x)}" cy="${tenths(p.y)}" ` +
                       `r="${tenths(radius)}"/>`);
  };
  const half = (c, ux, uy, fx, fy) => {
    const k = 0.5522847498;
    return 'M' + pair(c.x + ux, c.y + uy) + 'C' + pair(c.x + ux + k * fx, c.y + uy + k * fy) + ' ' +
           pair(c.x + fx + k * ux, c.y + fy + k * uy) + ' ' + pair(c.x + fx, c.y + fy) + 'S' +
           pair(c.x - ux + k * fx, c.y - uy + k * fy) + ' ' + pair(c.x - ux, c.y - uy);
  };
  let nextFace = 0;
  const draw = {
    f(item) {
      add(faces[nextFace++].depth,
          `<path class="${item.style} face" d="M${item.n.map(i => pair(seen[i].x, seen[i].y)).join('L')}Z"/>`);
    },
    e(item) {
      const a = seen[item.n[0]], b = seen[item.n[1]], own = item.n.slice(2).map(i => faces[i]);
      const hidden = own.length > 0 && own.every(face => face.away), middle = (a.depth + b.depth) / 2;
      const nearest = Math.max(middle, ...own.map(face => face.depth));
      line(a, b, hidden ? middle : nearest, item.style + (hidden ? ' stroke hid' : ' stroke'));
    },
    a(item) {
      const a = seen[item.n[0]], b = seen[item.n[1]], depth = (a.depth + b.depth) / 2;
      const dx = b.x - a.x, dy = b.y - a.y, length = Math.sqrt(dx * dx + dy * dy);
      line(a, b, depth, item.style + ' stroke');
      if (length < 4) return;
      const back = Math.min(10, length), ux = back * dx / length, uy = back * dy / length;
      add(depth, `<path class="${item.style} head" d="M${pair(b.x, b.y)}` +
                 `L${pair(b.x - ux - 0.4 * uy, b.y - uy + 0.4 * ux)}` +
                 `L${pair(b.x - ux + 0.4 * uy, b.y - uy - 0.4 * ux)}Z"/>`);
    },
    b(item) {
      const c = seen[item.n[0]], r = item.n[1] * scale;
      let behind = '', before = '';
      for (const axis of [direction(1, 0, 0), direction(0, 1, 0), direction(0, 0, 1)]) {
        const length = Math.sqrt(axis.x * axis.x + axis.y * axis.y);
        if (length < 1e-6) continue;
        const ux = r * axis.y / length, uy = r * axis.x / length;
        const fx = -r * axis.depth * axis.x / length, fy = r * axis.depth * axis.y / length;
        behind += half(c, ux, uy, -fx, -fy);
        before += half(c, ux, uy, fx, fy);
      }
      const round = `cx="${tenths(c.x)}" cy="${tenths(c.y)}" r="${tenths(r)}"/>`;
      add(c.depth - r, `<path class="${item.style} stroke hid thin" d="${behind}"/>`);
      add(c.depth, `<circle class="${item.style} face" ${round}<circle class="${item.style} stroke" ${round}`);
      add(c.depth + 0.5, `<path class="${item.style} stroke thin" d="${before}"/>`);
      for (const [x, y] of diagonals) {
        for (const part of [0.92, 1, 1.08])
          drawn.push([c.x + part * r * (x * diagonal), c.y + part * r * (y * diagonal)]);
      }
    },
    d(item) { dot(item, item.n[1] / 10, 'dot'); },
    r(item) { dot(item, 9, 'ring'); },
  };
  for (const item of model.items) draw[item.kind](item);
  strokes.sort((a, b) => a.depth - b.depth);
  let svg = '';
  [direction(1, 0, 0), direction(0, 1, 0), direction(0, 0, 1)].forEach((axis, i) => {
    const x = 30, y = height - 30, dx = 20 * axis.x, dy = -20 * axis.y;
    svg += `<path class="tick" d="M${pair(x, y)}L${pair(x + dx, y + dy)}"/>` +
           `<text class="scale" x="${tenths(x + 1.4 * dx)}" y="${tenths(y + 1.4 * dy + 4)}" ` +
           `text-anchor="middle">${'xyz'[i]}</text>`;
  });
  return svg + strokes.map(stroke => stroke.svg).join('') + labels(model, seen, drawn, scale, width, height);
}

// Each text where it covers least of what is drawn and of the other texts.
function labels(model, seen, drawn, scale, width, height) {
  const texts = [];
  let svg = '';
  for (const label of model.labels) {
    const r = label.radius * scale, c = seen[label.places[0]], wide = 6.9 * [...label.text].length;
    const round = diagonals.map(([x, y]) => [c.x + r * (x * diagonal), c.y + r * (y * diagonal)]);
    const places = (label.radius > 0 ? round : []).concat(label.places.map(i => [seen[i].x, seen[i].y]));
    let best = null, least = 1000, preference = 0;
    for (const [x, y] of places) {
      for (const [wx, wy] of [[1, -1], [-1, -1], [1, 1], [-1, 1], [0, -1], [0, 1], [1, 0], [-1, 0]]) {
        const gap = wx !== 0 && wy !== 0 ? 8 * 0.7 : 8;
        const left = wx > 0 ? x + gap : wx < 0 ? x - gap - wide : x - wide / 2;
        const top = wy > 0 ? y + gap : wy < 0 ? y - gap - 15 : y - 15 / 2;
        const right = left + wide, bottom = top + 15;
        preference += 0.1;
        if (!(left >= 2 && top >= 2 && right <= width - 2 && bottom <= height - 2)) continue;
        let price = preference;
        for (const t of texts) if (left < t.right && t.left < right && top < t.bottom && t.top < bottom) price += 100;
        for (const [px, py] of drawn) if (px >= left && px <= right && py >= top && py <= bottom) price += 4;
        if (price < least) least = price, best = {left, top, right, bottom};
      }
    }
    if (!best) continue;
    texts.push({left: best.left - 4, top: best.top - 1, right: best.right + 4, bottom: best.bottom + 1});
    svg += `<text class="${label.style}" x="${tenths(best.left)}" y="${tenths(best.bottom - 3.5)}">` +
           `${escaped(label.text)}</text>`;
  }
  return svg;
}

for (const svg of document.querySelectorAll('svg.space')) {
  const model = read(svg.dataset.space), group = svg.querySelector('.turning');
  const [, , , , cosYaw, sinYaw, yawOver, cosPitch, sinPitch, pitchOver] = model.view;
  const first = [cosYaw / yawOver, sinYaw / yawOver, cosPitch / pitchOver, sinPitch / pitchOver];
  let yaw = 0, pitch = 0, held = null, waiting = false;
  const start = () => {
    yaw = Math.atan2(first[1], first[0]);
    pitch = Math.atan2(first[3], first[2]);
  };
  const show = turn => { group.innerHTML = picture(model, ...turn); };
  const turn = (byYaw, byPitch) => {
    yaw += byYaw;
    pitch = Math.max(-Math.PI / 2, Math.min(Math.PI / 2, pitch + byPitch));
    if (waiting) return;
    waiting = true;
    requestAnimationFrame(() => {
      waiting = false;
      show([Math.cos(yaw), Math.sin(yaw), Math.cos(pitch), Math.sin(pitch)]);
    });
  };
  start();
  svg.classList.add('turns');
  svg.setAttribute('tabindex', '0');
  svg.setAttribute('role', 'application');
  svg.setAttribute('aria-roledescription', 'figure that turns');
  svg.insertAdjacentHTML('afterend',
      '<p class="screen small quiet turn-hint">Drag to turn it, or use the arrow keys; Home turns it back.</p>');
  svg.addEventListener('pointerdown', event => {
    if (event.button !== 0) return;
    held = {id: event.pointerId, x: event.clientX, y: event.clientY};
    svg.setPointerCapture(event.pointerId);
  });
  svg.addEventListener('pointermove', event => {
    if (!held || held.id !== event.pointerId) return;
    turn((held.x - event.clientX) / 120, (event.clientY - held.y) / 120);
    held.x = event.clientX;
    held.y = event.clientY;
  });
  for (const end of ['pointerup', 'pointercancel', 'lostpointercapture']) {
    svg.addEventListener(end, () => { held = null; });
  }
  svg.addEventListener('keydown', event => {
    if (event.altKey || event.ctrlKey || event.metaKey) return;
    const step = Math.PI / 24;
    if (event.key === 'ArrowLeft') turn(step, 0);
    else if (event.key === 'ArrowRight') turn(-step, 0);
    else if (event.key === 'ArrowUp') turn(0, -step);
    else if (event.key === 'ArrowDown') turn(0, step);
    else if (event.key === 'Home') { start(); show(first); }
    else return;
    event.preventDefault();
  });
}
})();
)js";

}  // namespace touchstone::audit
