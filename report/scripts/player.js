// SPDX-License-Identifier: Apache-2.0
// Plays the runs of a scene side by side, drawn by viewer.js: pause, step, scrub, speed; velocities, contacts, what the
// runs have as energy and momentum, how far they are apart, and marks where they part.
//
// Its data, as report/pages/simulation_page.cpp writes it:
//   timestep, stride   seconds of a step; steps between two frames
//   bodies             [{name, shape, radius, half, fixed}]
//   walls, room        [{name, normal, offset}]; least and greatest corner, or nothing
//   runs               [{name, engine, ended, frames, contacts, energy, law, scheme, decision, rounding, momentum}],
//                      each list by frame: position and velocity of each body in one list; points. An engine's
//                      rounding is all that is its own; one that ended has fewer frames than the others
//   distances          [{runs, values}]
//   partings           [{step, runs, contact}]
'use strict';
const player = (() => {
const half = 100000;  // steps of viewer.js from the middle to the end of the longest side
const mostNamed = 12, fewBodies = 4;
const dashes = ['', '6 3', '2 3', '9 2 2 2'];  // runs differ in dashes as well as in colour
const colour = i => 'q' + i % 4, dash = i => dashes[(i + Math.floor(i / 4)) % 4];
const wide = 360, high = 186, margin = {left: 62, right: 10, top: 10, bottom: 36};
const front = {cosYaw: 1, sinYaw: 0, cosPitch: 1, sinPitch: 0}, edge = 16;  // pixels around what is seen from the front

const short = x => x === 0 ? '0' :
    Math.abs(x) >= 0.001 && Math.abs(x) < 1e6 ? String(+x.toPrecision(6)) : x.toExponential(2);
const minus = text => text.replaceAll('-', '\u2212');
const shown = (run, frame) => Math.min(frame, run.frames.length - 1);
const squares = v => v.reduce((sum, x) => sum + x * x, 0);

// Where a wall is drawn, as viewer.js counts: below the middle of everything.
function footOf({normal, offset}, within) {
  const square = squares(normal), e = (normal.reduce((sum, n, i) => sum + n * within.middle[i], 0) + offset) / square;
  return placed(within.middle.map((x, i) => x - e * normal[i]), within);
}
const tipOf = ({normal}, foot) => {
  const long = half / 4 / Math.sqrt(squares(normal));
  return foot.map((x, i) => Math.round(x + normal[i] * long));
};
// A wall far from everything is left out: it would make the rest small.
const isNear = foot => foot.every(x => Math.abs(x) <= 2 * half);

// Whether all that moves stays in the plane z = 0: a wall across the plane turns nothing out of it, and one along the
// plane is never met.
const isFlat = data =>
    data.runs.every(({frames}) => frames.every(frame => frame.every((x, i) => i % 3 < 2 || x === 0))) &&
    data.walls.every(({normal: [x, y, z]}) => z === 0 || (x === 0 && y === 0));

// What every frame of every run fits into, and how fast the fastest body is. A wall does not change the scale; what is
// drawn of it lies within reach: a square whose half side is half / 2. What stays in a plane is first seen from the
// front, and fills the frame.
function extent(data) {
  const low = [Infinity, Infinity, Infinity], high = low.map(x => -x);
  let fastest = 0;
  const add = (p, reach) => p.forEach((x, i) => {
    low[i] = Math.min(low[i], x - reach[i]);
    high[i] = Math.max(high[i], x + reach[i]);
  });
  for (const {frames} of data.runs) {
    for (const frame of frames) {
      data.bodies.forEach(({shape, radius, half}, i) => {
        add(frame.slice(6 * i, 6 * i + 3), shape === 'box' ? half : [radius, radius, radius]);
        fastest = Math.max(fastest, Math.sqrt(squares(frame.slice(6 * i + 3, 6 * i + 6))));
      });
    }
  }
  for (const corner of data.room ?? []) add(corner, [0, 0, 0]);
  const middle = low.map((x, i) => (x + high[i]) / 2), side = Math.max(...low.map((x, i) => high[i] - x));
  const scale = side > 0 ? 2 * half / side : 1, corner = Math.sqrt(squares(low.map((x, i) => (high[i] - x) / 2)));
  const ends = data.walls.map(wall => [wall, footOf(wall, {middle, scale})]).filter(([, foot]) => isNear(foot))
      .map(([wall, foot]) => [foot, tipOf(wall, foot)]), feet = ends.map(([foot]) => foot);
  const reach = Math.max(1, corner * scale, ...feet.map(foot => Math.sqrt(squares(foot) + half * half / 2)));
  const flat = isFlat(data), {width, height, room} = viewer.size;
  const widest = i => Math.max(1, (high[i] - low[i]) * scale / 2, ...ends.flat().map(end => Math.abs(end[i])));
  const frontReach = room * Math.max(widest(0) / (width / 2 - edge), widest(1) / (height / 2 - edge));
  return {low, high, middle, scale, reach, fastest, flat, frontReach};
}

const placed = (p, {middle, scale}) => p.map((x, i) => Math.round((x - middle[i]) * scale));

// The names of bodies as labels: where there are many, "ball_1" and its like show their numbers alone after the first.
function shortNames(bodies) {
  const stem = name => /^(.*?)[_ ]?(\d+)$/.exec(name) ?? [name, name, name], seen = new Set();
  return bodies.map(({name}) => {
    const [, start, number] = stem(name), first = !seen.has(start);
    seen.add(start);
    return bodies.length <= fewBodies || first ? name : number;
  });
}

// The figures of one frame of a run, as viewer.js takes them; beside an engine where robust is, as a ghost.
function figures(data, run, frame, within, show) {
  const robust = run.engine && data.runs.find(({name, engine}) => name === 'robust' && !engine);
  const ghosts = robust ? ofRun(data, robust, shown(robust, frame), within, {}) : [];
  return [...ghosts.filter(({body}) => body).map(ghost => ({...ghost, label: '', whose: 'answer'})),
          ...ofRun(data, run, frame, within, show)];
}

function ofRun(data, run, frame, within, show) {
  const list = [], numbers = run.frames[frame], named = data.bodies.length <= mostNamed;
  const names = shortNames(data.bodies);
  if (data.room) list.push({kind: 'box', label: '', whose: 'question', points: data.room.map(p => placed(p, within))});
  for (const wall of data.walls) {
    const foot = footOf(wall, within);
    if (isNear(foot)) list.push({kind: 'plane', label: '', whose: 'question', points: [foot, tipOf(wall, foot)]});
  }
  data.bodies.forEach((body, i) => {
    const p = numbers.slice(6 * i, 6 * i + 3), v = numbers.slice(6 * i + 3, 6 * i + 6);
    const common = {body: true, label: named ? names[i] : `bodies[${i}]`, whose: 'question'}, at = placed(p, within);
    if (body.shape === 'particle') list.push({...common, kind: 'point', points: [at]});
    if (body.shape === 'sphere')
      list.push({...common, kind: 'sphere', points: [at], radius: Math.round(body.radius * within.scale)});
    const corner = side => placed(p.map((x, k) => x + side * body.half[k]), within);
    if (body.shape === 'box') list.push({...common, kind: 'box', points: [corner(-1), corner(1)]});
    if (show.velocities && squares(v) > 0) {
      const long = 0.4 * half / within.fastest, tip = at.map((x, k) => Math.round(x + long * v[k]));
      list.push({label: '', whose: 'question', kind: 'arrow', points: [at, tip]});
    }
  });
  return list;
}

// One frame of a run as SVG. What the reader sees keeps its size from frame to frame.
function drawn(data, run, now, within, show, turn) {
  const frame = shown(run, now);
  const drawing = new viewer.Strokes({figures: figures(data, run, frame, within, show)});
  if (show.trails) {
    drawing.style = 'aid';
    const from = Math.max(0, frame - 60);
    data.bodies.forEach((body, i) => {
      const place = k => placed(run.frames[k].slice(6 * i, 6 * i + 3), within);
      for (let k = from; k < frame && !body.fixed && data.bodies.length <= 20; ++k)
        drawing.add('edge', [place(k), place(k + 1)], {faces: []});
    });
  }
  const isFront = within.flat && turn === front;
  drawing.style = 'aid';
  for (const wall of isFront ? data.walls : []) {  // as far as one sees
    const foot = footOf(wall, within), [x, y] = wall.normal, size = Math.sqrt(x * x + y * y);
    const far = [-y, x, 0].map(v => v * within.frontReach * viewer.size.width / viewer.size.room / size);
    if (size > 0 && isNear(foot))
      drawing.add('edge', [-1, 1].map(side => foot.map((v, i) => v + side * far[i])), {faces: []});
  }
  drawing.style = 'truth';
  for (const point of run.contacts[frame])
    drawing.add('dot', [placed(point, within)], {radius: 7, ring: true});
  drawing.reach = isFront ? within.frontReach : within.reach;
  if (data.bodies.length > mostNamed) drawing.labels = [];
  return viewer.picture(drawing, turn);
}

// Round numbers from low to top, three to six of them: multiples of 1, 2 or 5 times a power of 10.
function roundNumbers(low, top) {
  const power = 10 ** Math.floor(Math.log10(top - low));
  const multiples = step => [...Array(6).keys()].map(k => +((Math.ceil(low / step) + k) * step).toPrecision(12))
      .filter(x => x <= top);
  return [2, 1, 0.5, 0.2].map(k => multiples(k * power)).find(numbers => numbers.length > 2) ?? [low, top];
}

// Lines over frames as SVG. A logarithmic axis leaves out what is 0. Series: [{name, values, style, dash}].
function plot(series, {frame, frames, marks, logarithmic, label, seconds}) {
  const all = series.flatMap(({values}) => values).filter(x => !logarithmic || x > 0);
  const last = Math.max(1, frames ?? series[0].values.length - 1), height = x => logarithmic ? Math.log10(x) : x;
  let low = Math.min(...all.map(height)), top = Math.max(...all.map(height));
  if (!all.length) low = 0, top = 1;
  if (logarithmic) low = Math.floor(low), top = low + 2 * Math.max(1, Math.ceil((Math.ceil(top) - low) / 2));
  const flat = Math.max(Math.abs(top), Math.abs(low), 1e-300) * 1e-12;
  const level = top - low < flat, middle = (low + top) / 2;
  if (level) top += flat + 1e-12, low -= flat + 1e-12;
  const x = k => +(margin.left + (wide - margin.left - margin.right) * k / last).toFixed(1);
  const y = v => +(high - margin.bottom - (high - margin.top - margin.bottom) * (v - low) / (top - low)).toFixed(1);
  const lines = series.map(({values, style, dash}) => {
    let path = '', pen = 'M';
    values.forEach((v, k) => {
      if (logarithmic && !(v > 0)) { pen = 'M'; return; }
      path += `${pen}${x(k)} ${y(height(v))}`;
      pen = 'L';
    });
    return `<path class="${style} stroke" stroke-dasharray="${dash}" d="${path || 'M0 0'}"/>`;
  });
  const column = (k, name) => `<path class="${name}" d="M${x(k)} ${margin.top}V${high - margin.bottom}"/>`;
  // Where numbers differ only far behind the point, ticks are differences from the shortest number between them.
  const close = !logarithmic && !level && top - low < 1e-3 * Math.max(Math.abs(top), Math.abs(low));
  let from = 0;
  for (let digits = 1; close && digits <= 17 && !(from >= low && from <= top); ++digits)
    from = +((low + top) / 2).toPrecision(digits);
  const signed = v => (v > 0 ? '+' : '') + (v === 0 ? '0' : v.toExponential(1));
  const tick = v => minus(logarithmic ? '1e' + Math.round(v) : close ? signed(v) : short(+v.toPrecision(5)));
  const ticks = !all.length ? [] : level ? [middle] : logarithmic ? [low, (low + top) / 2, top] :
      roundNumbers(low - from, top - from);
  const words = !all.length ? '0 throughout' : close ? 'differences from ' + minus(String(from)) : '';
  const base = words && `<text class="scale" x="${margin.left}" y="${high - 6}">${words}</text>`;
  // All plots of a page have the same axis of time, at the same height.
  const foot = high - margin.bottom, times = seconds > 0 ? roundNumbers(0, seconds) : [];
  const axis = times.map((t, i) => {
    const at = +(margin.left + (wide - margin.left - margin.right) * t / seconds).toFixed(1);
    return `<path class="tick" d="M${at} ${foot}v4"/><text class="scale" x="${at}" y="${foot + 15}" ` +
        `text-anchor="${at > wide - 20 ? 'end' : 'middle'}">${short(t)}${i + 1 === times.length ? ' s' : ''}</text>`;
  });
  return `<svg class="fig plot" viewBox="0 0 ${wide} ${high}" width="${wide}" height="${high}" role="img" ` +
      `aria-label="${escaped(label)}">` +
      ticks.map(v => `<path class="grid" d="M${margin.left} ${y(v + from)}H${wide - margin.right}"/>` +
                     `<text class="scale" x="${margin.left - 5}" y="${+(y(v + from) + 4).toFixed(1)}" ` +
                     `text-anchor="end">${tick(v)}</text>`).join('') +
      (axis.length ? `<path class="axis" d="M${margin.left} ${foot}H${wide - margin.right}"/>` : '') + axis.join('') +
      base + marks.filter(k => k <= last).map(k => column(k, 'mark')).join('') + lines.join('') + column(frame, 'now') +
      '</svg>';
}

const row = (name, value) => `<dt>${escaped(name)}</dt><dd>${escaped(minus(value))}</dd>`;
function facts(run, now) {
  const frame = shown(run, now);
  const own = run.engine ? row('drift of its own', short(run.rounding[frame])) :
      row('drift by decisions', short(run.decision[frame])) + row('drift by rounding', short(run.rounding[frame]));
  return row('energy', short(run.energy[frame])) + row('drift by law', short(run.law[frame])) +
      row('drift by scheme', short(run.scheme[frame])) + own +
      row('momentum', '(' + run.momentum[frame].map(short).join(', ') + ')') +
      (run.ended && frame < now ? `<dt>ended</dt><dd>${escaped(run.ended)}</dd>` : '');
}

function markup(data, last) {
  const svg = `<svg class="fig space turns" viewBox="0 0 400 300" role="application" tabindex="0">` +
      `<g class="turning"></g></svg>`;
  const names = data.runs.map(run => run.name);
  const ghost = run => run.engine && names.includes('robust') ?
      ' <span class="small quiet">robust as a ghost</span>' : '';
  const views = data.runs.map(run => `<figure class="run"><figcaption><b>${escaped(run.name)}</b>${ghost(run)}` +
      `</figcaption>${svg}<dl class="facts"></dl></figure>`);
  const speeds = [0.1, 0.25, 1, 4].map(x => `<option value="${x}"${x === 1 ? ' selected' : ''}>${x}\u00d7</option>`);
  const key = (name, i) => `<span class="key"><svg class="fig" width="26" height="8">` +
      `<path class="${colour(i)} stroke" stroke-dasharray="${dash(i)}" d="M0 4h26"/></svg>${escaped(name)}</span>`;
  const legend = names => `<p class="small">${names.map(key).join('')}</p>`;
  const parts = data.partings.map(({step, runs, contact}) =>
      `<li><button class="mark" data-step="${step}">step ${step}: ` +
      `${escaped(runs.join(' and '))} part at ${escaped(contact)}</button></li>`);
  return `<div class="runs">${views.join('')}</div><div class="controls" role="group" aria-label="playback">` +
      `<button class="play" aria-pressed="false">Play</button>` +
      `<button class="back" aria-label="one step back">\u22121</button>` +
      `<button class="next" aria-label="one step forward">+1</button>` +
      `<label>Speed <select class="speed">${speeds.join('')}</select></label>` +
      `<label><input type="checkbox" class="velocities" checked> velocities</label>` +
      `<label><input type="checkbox" class="trails" checked> trails</label><output class="where"></output></div>` +
      `<input class="scrub" type="range" min="0" max="${last}" value="0" aria-label="frame">` +
      `<p class="small quiet screen">Space plays and pauses, the arrow keys step, a drag turns the view. Rings are contacts.` +
      `</p>` +
      (parts.length ? `<ul class="marks">${parts.join('')}</ul>` : '') +
      `<div class="plots"><section><h2>Energy</h2><div class="energy"></div>${legend(names)}</section>` +
      `<section><h2>Momentum, its length</h2><div class="momentum"></div>${legend(names)}</section>` +
      (data.distances.length ? `<section><h2>How far apart</h2><div class="distance"></div>` +
          `${legend(data.distances.map(({runs}) => runs.join(' \u2013 ')))}</section>` : '') + '</div>';
}

// Draws the data into an element of the page and plays it as the reader asks.
function show(place, data) {
  const last = data.runs[0].frames.length - 1, within = extent(data);
  place.innerHTML = markup(data, last);
  const one = selector => place.querySelector(selector);
  const views = [...place.querySelectorAll('.run')], choice = {velocities: true, trails: true};
  const marks = data.partings.map(({step}) => step / data.stride);
  let frame = 0, clock = 0, playing = false, before = null, held = null;
  let turn = within.flat ? front : viewer.firstTurn;
  let yaw = Math.atan2(turn.sinYaw, turn.cosYaw), pitch = Math.atan2(turn.sinPitch, turn.cosPitch);
  const lines = (list, values, name) => list.map((one, i) =>
      ({name: name(one), values: values(one), style: colour(i), dash: dash(i)}));
  const energies = lines(data.runs, run => run.energy, run => run.name);
  const lengths = lines(data.runs, run => run.momentum.map(v => Math.sqrt(squares(v))), run => run.name);
  const apart = lines(data.distances, pair => pair.values, pair => pair.runs.join());
  const draw = () => {
    views.forEach((view, i) => {
      view.querySelector('.turning').innerHTML = drawn(data, data.runs[i], frame, within, choice, turn);
      view.querySelector('.facts').innerHTML = facts(data.runs[i], frame);
    });
    const common = {frame, frames: last, marks, seconds: last * data.stride * data.timestep};
    one('.energy').innerHTML = plot(energies, {...common, label: 'energy of each run by step'});
    one('.momentum').innerHTML = plot(lengths, {...common, label: 'length of the momentum of each run by step'});
    if (apart.length)
      one('.distance').innerHTML = plot(apart, {...common, logarithmic: true, label: 'distance between runs by step'});
    one('.scrub').value = frame;
    const step = frame * data.stride;
    one('.where').textContent = `step ${step} of ${last * data.stride}, ${(step * data.timestep).toFixed(3)} s`;
  };
  const go = to => {
    frame = clock = Math.max(0, Math.min(last, Math.round(to)));
    draw();
  };
  const tick = now => {
    if (!playing) return;
    if (before !== null) clock += (now - before) / 1000 / (data.timestep * data.stride) * Number(one('.speed').value);
    before = now;
    if (clock >= last) clock = last, play(false);
    if (Math.floor(clock) !== frame) frame = Math.floor(clock), draw();
    if (playing) requestAnimationFrame(tick);
  };
  const play = on => {
    playing = on;
    before = null;
    one('.play').textContent = on ? 'Pause' : 'Play';
    one('.play').setAttribute('aria-pressed', String(on));
    if (!on) return;
    if (frame === last) go(0);
    requestAnimationFrame(tick);
  };
  const stop = to => { play(false), go(to); };
  one('.play').addEventListener('click', () => play(!playing));
  one('.back').addEventListener('click', () => stop(frame - 1));
  one('.next').addEventListener('click', () => stop(frame + 1));
  one('.scrub').addEventListener('input', event => stop(Number(event.target.value)));
  for (const name of Object.keys(choice))
    one('.' + name).addEventListener('change', event => { choice[name] = event.target.checked, draw(); });
  for (const button of place.querySelectorAll('.mark'))
    button.addEventListener('click', () => stop(Number(button.dataset.step) / data.stride));
  for (const name of ['.energy', '.momentum', '.distance']) {
    one(name)?.addEventListener('click', event => {
      const box = event.currentTarget.getBoundingClientRect(), x = (event.clientX - box.left) * wide / box.width;
      stop((x - margin.left) / (wide - margin.left - margin.right) * last);
    });
  }
  place.addEventListener('keydown', event => {
    if (event.altKey || event.ctrlKey || event.metaKey || /^(SELECT|INPUT)$/.test(event.target?.tagName)) return;
    if (event.key === ' ' && event.target?.tagName !== 'BUTTON') play(!playing);
    else if (event.key === 'ArrowLeft') stop(frame - 1);
    else if (event.key === 'ArrowRight') stop(frame + 1);
    else return;
    event.preventDefault();
  });
  for (const view of views) {
    const svg = view.querySelector('svg');
    svg.addEventListener('pointerdown', event => {
      if (event.button !== 0) return;
      held = {id: event.pointerId, x: event.clientX, y: event.clientY};
      svg.setPointerCapture(event.pointerId);
    });
    svg.addEventListener('pointermove', event => {
      if (!held || held.id !== event.pointerId) return;
      yaw += (held.x - event.clientX) / 120;
      pitch = Math.max(-Math.PI / 2, Math.min(Math.PI / 2, pitch + (event.clientY - held.y) / 120));
      held = {id: held.id, x: event.clientX, y: event.clientY};
      turn = {cosYaw: Math.cos(yaw), sinYaw: Math.sin(yaw), cosPitch: Math.cos(pitch), sinPitch: Math.sin(pitch)};
      draw();
    });
    for (const end of ['pointerup', 'pointercancel', 'lostpointercapture'])
      svg.addEventListener(end, () => { held = null; });
  }
  // A page's address may name the step at which it begins: page.html#step=40.
  const named = () => /[#&]step=(\d+)/.exec(globalThis.location?.hash ?? '');
  go(named() ? named()[1] / data.stride : 0);
  globalThis.addEventListener?.('hashchange', () => named() && stop(named()[1] / data.stride));
}

return {front, extent, figures, drawn, plot, show};
})();

drawnAlone('player', player.show);
