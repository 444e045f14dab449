// SPDX-License-Identifier: Apache-2.0
// Figures of the deck whose points the reader drags: the textbook formula in float, in double and exactly, beside the
// truth. Points lie on tenths, which doubles round, so what looks like a touch seldom is one.
//
// A figure, as drag_figures.js has them by name:
//   start    its points, in units of 100 pixels, y up; names: of the points
//   draw     the points -> shapes: [style, kind, ...], kind one of the keys of `shape`
//   answer   an arithmetic and the points in it -> the formula's answer in words; one formula for all arithmetics
//   truth    the same by the definition, in exact arithmetic, where the formula is not right even so
//   measure  the answer is a number alone: no case to look for that breaks it
'use strict';
const drag = (() => {
const width = 400, height = 300, unit = 100, most = 4000;

// A double is a fraction, and so are sums, products and quotients. Over 0 it is no number: nothing is less or greater.
const exact = {
  of: x => {
    let d = 1n;
    for (; !Number.isInteger(x); x *= 2) d *= 2n;
    return {n: BigInt(x), d};
  },
  add: (a, b) => ({n: a.n * b.d + b.n * a.d, d: a.d * b.d}),
  sub: (a, b) => ({n: a.n * b.d - b.n * a.d, d: a.d * b.d}),
  mul: (a, b) => ({n: a.n * b.n, d: a.d * b.d}),
  div: (a, b) => b.n < 0n ? {n: -a.n * b.d, d: -a.d * b.n} : {n: a.n * b.d, d: a.d * b.n},
  less: (a, b) => a.d > 0n && b.d > 0n && a.n * b.d < b.n * a.d,
  equal: (a, b) => a.d > 0n && b.d > 0n && a.n * b.d === b.n * a.d,
  value: a => a.d === 0n ? NaN : Number((a.n << 200n) / a.d) / 2 ** 200,
};
const rounding = round => ({
  of: round, add: (a, b) => round(a + b), sub: (a, b) => round(a - b), mul: (a, b) => round(a * b),
  div: (a, b) => round(a / b), less: (a, b) => a < b, equal: (a, b) => a === b, value: a => a,
});
const float = rounding(Math.fround), double = rounding(x => x);
// What formulas are written with.
for (const N of [exact, float, double]) {
  N.zero = N.of(0), N.one = N.of(1);
  N.within = (low, x, high) => !N.less(x, low) && !N.less(high, x) && N.equal(x, x);
  N.sign = x => N.less(x, N.zero) ? -1 : N.less(N.zero, x) ? 1 : 0;
  N.minus = (p, q) => p.map((x, i) => N.sub(x, q[i]));
  N.plus = (p, t, v) => p.map((x, i) => N.add(x, N.mul(t, v[i])));
  N.dot = (v, w) => N.add(N.mul(v[0], w[0]), N.mul(v[1], w[1]));
  N.cross = (v, w) => N.sub(N.mul(v[0], w[1]), N.mul(v[1], w[0]));
  N.side = (a, b, p) => N.cross(N.minus(b, a), N.minus(p, a));  // E of p. 16-17
  N.max = (a, b) => N.less(a, b) ? b : a;
  N.min = (a, b) => N.less(b, a) ? b : a;
}

const tenths = v => Math.round(10 * v) / 10;
const x = p => tenths(p[0] * unit), y = p => tenths(height - p[1] * unit);
const path = (style, d) => `<path class="${style} stroke" stroke-width="2" d="${d}"/>`;
const through = (...points) => 'M' + points.map(p => `${x(p)} ${y(p)}`).join('L');
const straight = (style, a, b) => path(style, through(a, b));
const beyond = (a, b, t) => a.map((u, i) => u + t * (b[i] - u));
const far = (a, b) => 8 / Math.max(0.1, Math.hypot(b[0] - a[0], b[1] - a[1]));
const shape = {
  segment: straight,
  line: (style, a, b) => straight(style, beyond(a, b, -far(a, b)), beyond(a, b, far(a, b))),
  ray: (style, a, b) => straight(style, a, beyond(a, b, far(a, b))),
  arrow: (style, a, b) => {
    const [u, v] = [b[0] - a[0], b[1] - a[1]], long = Math.hypot(u, v);
    if (long < 0.04) return '';
    const side = s => [b[0] - (0.11 * u - s * 0.045 * v) / long, b[1] - (0.11 * v + s * 0.045 * u) / long];
    return straight(style, a, b) + `<path class="${style} head" d="${through(b, side(1), side(-1))}Z"/>`;
  },
  polygon: (style, ...ring) => {
    const d = through(...ring) + 'Z';
    return `<path class="${style} area" d="${d}"/>` + path(style, d);
  },
  box: (style, [left, low], [right, high]) =>
      shape.polygon(style, [left, low], [right, low], [right, high], [left, high]),
  circle: (style, p, r) => {
    const round = `cx="${x(p)}" cy="${y(p)}" r="${tenths(r * unit)}"/>`;
    return `<circle class="${style} area" ${round}<circle class="${style} stroke" stroke-width="2" ${round}`;
  },
  point: (style, p) => `<circle class="${style} dot" cx="${x(p)}" cy="${y(p)}" r="4"/>`,
};

// Who answers what, with these points.
function answers(figure, points) {
  const by = (N, answer) => answer(N, points.map(p => p.map(N.of)));
  const rows = Object.entries({float, double}).map(([name, N]) => ['the formula in ' + name, by(N, figure.answer)]);
  if (!figure.truth) return [...rows, ['the truth: the formula, exactly', by(exact, figure.answer)]];
  return [...rows, ['the formula, exactly', by(exact, figure.answer)], ['the truth', by(exact, figure.truth)]];
}

// Points on tenths with which the formula in double answers another thing than the truth; none where none is found.
function breaking(figure, seed) {
  let state = seed;
  const next = n => (state = (state * 1103515245 + 12345) % 2147483648, Math.floor(state / 2147483648 * n));
  for (let i = 0; i < most; ++i) {
    const points = figure.start.map(() => [(2 + next(37)) / 10, (2 + next(27)) / 10]);
    if (new Set(points.map(String)).size < points.length) continue;
    const rows = answers(figure, points);
    if (rows[1][1] !== rows.at(-1)[1]) return points;
  }
  return null;
}

function drawn(figure, points) {
  const shapes = figure.draw(points, double).map(([style, kind, ...rest]) => shape[kind](style, ...rest));
  const round = (style, p, r) => `<circle class="${style}" cx="${x(p)}" cy="${y(p)}" r="${r}"/>`;
  const handles = points.map((p, i) => {
    const name = escaped(figure.names[i]), left = p[0] > 3.2;
    return `<g class="handle" data-point="${i}" tabindex="0" role="slider" aria-label="${name}" ` +
        `aria-valuetext="${p.join(', ')}">${round('grip', p, 13)}${round('q0 dot', p, 4.5)}<text class="q0" ` +
        `text-anchor="${left ? 'end' : 'start'}" x="${x(p) + (left ? -8 : 8)}" y="${Math.max(14, y(p) - 8)}">` +
        `${name}</text></g>`;
  });
  return shapes.join('') + handles.join('');
}

function show(place, name) {
  const figure = drag_figures[name];
  let points = figure.start, held = null, seed = 1;
  const size = `width="${width}" height="${height}"`;
  place.innerHTML = `<div class="view"><svg xmlns="http://www.w3.org/2000/svg" class="fig drag" role="group" ` +
      `viewBox="0 0 ${width} ${height}" ${size}><rect class="frame" ${size}/><g class="moving"></g></svg></div>` +
      `<div class="dragged"><table class="said"><tbody></tbody></table>` +
      `<p class="screen"><button class="reset" type="button">As it was</button> ` +
      (figure.measure ? '' : `<button class="break" type="button">Find points that break it</button> `) +
      `<output class="small quiet"></output></p><p class="screen small quiet">Drag the points, or move one with ` +
      `the arrow keys. Each coordinate is a tenth, as a double.</p></div>`;
  const one = selector => place.querySelector(selector);
  const svg = one('svg'), group = one('.moving');
  const draw = () => {
    group.innerHTML = drawn(figure, points);
    const rows = answers(figure, points), truth = rows.at(-1)[1];
    const badge = '<span class="badge rounding">wrong</span>';
    one('tbody').innerHTML = rows.map(([who, said], i) => `<tr class="${i + 1 === rows.length ? 'truth' : ''}">` +
        `<th scope="row">${who}</th><td>${escaped(said)}</td>` +
        `<td>${said === truth || figure.measure ? '' : badge}</td></tr>`).join('');
  };
  const move = (i, p) => {
    const on = (v, end) => Math.min(end, Math.max(0, Math.round(10 * v) / 10));
    points = points.map((q, k) => k === i ? [on(p[0], width / unit), on(p[1], height / unit)] : q);
    draw();
  };
  svg.addEventListener('pointerdown', event => {
    const handle = event.target.closest('.handle');
    if (!handle || event.button !== 0) return;
    held = Number(handle.dataset.point);
    svg.setPointerCapture(event.pointerId);
  });
  svg.addEventListener('pointermove', event => {
    if (held === null) return;
    const box = svg.getBoundingClientRect(), scale = width / unit / box.width;
    move(held, [(event.clientX - box.left) * scale, height / unit - (event.clientY - box.top) * scale]);
  });
  for (const end of ['pointerup', 'pointercancel']) svg.addEventListener(end, () => { held = null; });
  svg.addEventListener('keydown', event => {
    const way = {ArrowLeft: [-1, 0], ArrowRight: [1, 0], ArrowUp: [0, 1], ArrowDown: [0, -1]}[event.key];
    const handle = event.target.closest('.handle');
    if (!way || !handle) return;
    const i = Number(handle.dataset.point);
    move(i, points[i].map((u, k) => u + way[k] / 10));
    group.querySelector(`[data-point="${i}"]`).focus();
    event.preventDefault();
  });
  one('.reset').addEventListener('click', () => { points = figure.start, one('output').textContent = '', draw(); });
  one('.break')?.addEventListener('click', () => {
    const found = breaking(figure, seed++);
    one('output').textContent = found ? '' : `None of ${most.toLocaleString('en')} tries breaks it.`;
    if (found) points = found, draw();
  });
  draw();
}

return {exact, float, double, answers, breaking, drawn, show};
})();
