// SPDX-License-Identifier: Apache-2.0
// Draws figures in space as SVG, and turns them: with a mouse, a finger or the arrow keys. Orthographic, y up.
//
// A model, as report/figures/space_model.cpp writes it into a page:
//   title    what a screen reader says
//   figures  [{kind, label, whose, points, radius, faces}], by kind with these points:
//              point, sphere (its centre): one; segment: its ends; arrow: start, tip; box: least and greatest corner;
//              plane: a point of it, then the tip of its normal; polygon, mesh: their vertices;
//              circle, of figures in a plane that the reader faces: its centre
//            whose: question, truth or answer; radius: of a sphere or circle; faces: of a mesh, as places in points,
//            counter-clockwise as seen from outside; of a node of a structure also node, how deep it is, and entered,
//            whether a search went on to what is in it: thin lines, thinner the deeper, filled where it was entered;
//            of one that moves also moves: how far from its points it is at t = -1, and at t = 1
//   spans    what x, y and z span, in words
//   bar      [length, words]: a round length, where one scale holds for all axes
//   remarks  further lines below
//   lens     a second model, of what is around a gap too narrow to be seen (report/figures/space_lens.cpp), with
//              mark, the place of the gap among the points of the first; reach, how far from its middle it shows;
//              turn, its first view; of each figure places, where its label may stand; none are its points where the
//              lens holds nothing of it
// Points are integers, 100,000 from the middle of the figures to the end of their longest side: coordinates between
// 5e-324 and 1e308 are brought to them exactly, before they get here.
'use strict';
const viewer = (() => {
const width = 400, height = 300, room = 134;  // pixels; room: from the middle to what is farthest from it
const small = 2500;  // steps: about three pixels
const mostLabels = 40, mostPlaces = 12, longestNumbered = 20, manyStrokes = 400, manyFaces = 450;
const mostNames = 7;  // of more, arrows bear numbers, and a legend has their names
const pointDot = 4.2, endDot = 3.2, centreDot = 1.8, ringRadius = 9, nearer = 0.5;
// Of facets, edge-on and facing the reader.
const outside = [[70, 96, 128], [205, 219, 235]], inside = [[130, 62, 10], [232, 160, 98]];
const diagonals = [[1, -1], [-1, -1], [1, 1], [-1, 1]].map(way => way.map(x => x * 0.7071067811865476));
// Fractions and not angles, so that every browser begins with the same picture.
const firstTurn = {cosYaw: 15 / 17, sinYaw: 8 / 17, cosPitch: 12 / 13, sinPitch: 5 / 13};

const pair = (x, y) => tenths(x) + ' ' + tenths(y);
const plus = (p, v, times = 1) => p.map((x, i) => x + times * v[i]);
const minus = (p, q) => p.map((x, i) => x - q[i]);
const length = v => Math.sqrt(v.reduce((sum, x) => sum + x * x, 0));
const cross = (v, w) => [v[1] * w[2] - v[2] * w[1], v[2] * w[0] - v[0] * w[2], v[0] * w[1] - v[1] * w[0]];
const between = (p, q, t) => plus(p, minus(q, p), t);
const text = (x, y, anchor, words) => words &&
    `<text class="scale" x="${tenths(x)}" y="${tenths(y)}" text-anchor="${anchor}">${escaped(words)}</text>`;

// Strokes of the pen for figures, in steps: they stay the same however the reader turns them.
class Strokes {
  constructor(model) {
    this.strokes = [], this.labels = [];
    const listOf = figure => figure.label.split('[')[0], size = {};
    for (const figure of model.figures) size[listOf(figure)] = 1 + (size[listOf(figure)] ?? 0);
    let part = -1, before;
    for (const figure of model.figures) {
      const list = listOf(figure);
      // Each part of the question has a colour; a list is one part.
      if (figure.whose === 'question' && figure.label && list !== before) ++part, before = list;
      this.node = figure.node !== undefined, this.empty = this.node && !figure.entered;
      this.style = this.node ? 'node' + ['', ' deep', ' deepest'][Math.min(2, figure.node >> 1)]
          : {truth: 'truth', answer: 'said'}[figure.whose] ?? (figure.label ? 'q' + part % 4 : 'aid');
      if (!figure.points.length) continue;  // a lens holds nothing of it
      const middles = this[figure.kind](figure, figure.points);
      const places = (figure.places ?? middles).slice(0, mostPlaces);
      // The first element of a list bears its name, the others their numbers; of a long list the first alone is named.
      const number = figure.label.slice(list.length), long = size[list] > longestNumbered;
      const first = number === '' || number === '[0]';
      const whose = figure.whose === 'truth' ? 'truth' : '', name = long ? list : figure.label;
      const label = first ? [whose, name].filter(Boolean).join(': ') : long ? '' : number;
      // Figures of the truth without a name, and parts of one shape, such as a capsule's segment and balls.
      const again = this.labels.some(other => other.text === label && other.style === this.style);
      if (label && !again && places.length && this.labels.length < mostLabels)
        this.labels.push({style: this.style, text: label, places, radius: figure.radius ?? 0, kind: figure.kind});
    }
    const arrows = this.labels.filter(({kind}) => kind === 'arrow');
    const numbered = this.labels.length > mostNames && arrows.length > 2 ? arrows : [];
    this.legend = numbered.map(({style, text}, i) => ({style, text, number: String(i + 1)}));
    numbered.forEach((label, i) => { label.text = this.legend[i].number; });
    this.mark = model.lens?.mark;
    this.reach = model.reach ?? Math.max(1, ...this.strokes.map(stroke =>
        Math.max(...stroke.points.map(length)) + (stroke.kind === 'ball' ? stroke.radius : 0)));
  }

  add(kind, points, more = {}) {
    const stroke = {kind, style: this.style, points, ...more};
    this.strokes.push(stroke);
    return stroke;
  }
  dot(point, radius) { this.add('dot', [point], {radius}); }
  dotIfSmall(points) {
    if (!this.node && points.every(p => minus(p, points[0]).every(x => Math.abs(x) <= small))) this.dot(points[0], endDot);
  }
  // Faces with their edges. An edge knows its faces, so that it is drawn as hidden where all of them look away.
  solid(faces, closed) {
    const edges = new Map(), order = new Map();
    for (const corners of faces) {
      const face = this.add('face', corners, {empty: this.empty});
      corners.forEach((p, i) => {
        const q = corners[(i + 1) % corners.length];
        for (const end of [p, q]) if (!order.has(end)) order.set(end, order.size);
        const name = [order.get(p), order.get(q)].sort().join();
        if (!edges.has(name)) edges.set(name, {ends: [p, q], faces: []});
        edges.get(name).faces.push(face);
      });
    }
    // With one face it is a rim, which nothing of its surface hides.
    for (const edge of edges.values())
      this.add('edge', edge.ends, {faces: closed && edge.faces.length > 1 ? edge.faces : []});
    return [...edges.values()].map(({ends: [p, q]}) => between(p, q, 0.5));
  }

  // Each returns where its label may stand.
  point({whose}, [p]) {
    this.add('dot', [p], whose === 'truth' ? {radius: ringRadius, ring: true} : {radius: pointDot});
    return [p];
  }
  segment({label, kind}, [p, q]) {
    if (kind === 'arrow' && length(minus(q, p)) === 0) return this.dot(p, endDot), [];
    this.add(kind === 'arrow' ? 'arrow' : 'edge', [p, q], {faces: []});
    if (label) this.dot(p, endDot);
    if (label && kind === 'segment') this.dot(q, endDot);
    return [0.5, 0.3, 0.7, 0.85, 0.15].map(t => between(p, q, t));
  }
  arrow(figure, points) { return this.segment(figure, points); }
  polygon(figure, points) {
    const middles = this.solid([points], false);
    this.dotIfSmall(points);
    return middles;
  }
  box(figure, [low, high]) {
    const corners = [...Array(8).keys()].map(i => low.map((x, axis) => i >> axis & 1 ? high[axis] : x));
    const faces = [[0, 4, 6, 2], [1, 3, 7, 5], [0, 1, 5, 4], [2, 6, 7, 3], [0, 2, 3, 1], [4, 5, 7, 6]];
    const middles = this.solid(faces.map(face => face.map(i => corners[i])), true);
    this.dotIfSmall([low, high]);
    return middles;
  }
  sphere({radius}, [centre]) {
    if (!this.node) this.dot(centre, radius > small ? centreDot : endDot);
    if (radius > 0) this.add('ball', [centre], {radius, empty: this.empty});
    return [centre];
  }
  circle({radius}, [centre]) {
    this.add('disc', [centre], {radius});
    this.dot(centre, radius > small ? centreDot : endDot);
    return [centre];
  }
  // A square about its point. Across: the axis that is least along the normal; of equal ones the first, so that a level
  // plane lies along x and z.
  plane(figure, [foot, tip]) {
    const normal = minus(tip, foot), sizes = normal.map(Math.abs), least = sizes.indexOf(Math.min(...sizes));
    const across = cross(normal, [0, 1, 2].map(axis => axis === least ? 1 : 0)), along = cross(normal, across);
    const half = v => v.map(x => 2 * x * length(normal) / length(v));
    const [u, v] = [half(across), half(along)];
    const corners = [[1, 1], [-1, 1], [-1, -1], [1, -1]].map(([s, t]) => plus(plus(foot, u, s), v, t));
    const middles = this.solid([corners], false);
    this.add('arrow', [foot, tip]);
    return [...corners, ...middles];
  }
  // What edges would hide: opaque faces, lit from the reader's side, another colour inside.
  facets(faces) {
    for (const corners of faces) this.add('facet', corners);
    return [...Array(mostPlaces).keys()].map(i => faces[Math.floor(i * faces.length / mostPlaces)][0]);
  }
  mesh({faces}, points) {
    // A face may name a vertex that is not there: the input is refused, and drawn without it.
    const whole = faces.filter(face => face.every(i => i < points.length)), used = new Set(whole.flat());
    if (whole.length > manyFaces) return this.facets(whole.map(face => face.map(i => points[i])));
    const middles = this.solid(whole.map(face => face.map(i => points[i])), true);
    points.forEach((p, i) => { if (!used.has(i)) this.dot(p, endDot); });
    this.dotIfSmall(points);
    return middles.length ? middles : points.slice(0, 1);
  }
}

// Everything that turns, from the farthest to the nearest. Depth grows towards the reader.
function picture(drawing, {cosYaw, sinYaw, cosPitch, sinPitch}) {
  const scale = room / drawing.reach;
  const direction = ([x, y, z]) => {
    const forth = sinYaw * x + cosYaw * z;
    return {x: cosYaw * x - sinYaw * z, y: cosPitch * y - sinPitch * forth, depth: sinPitch * y + cosPitch * forth};
  };
  const axes = [[1, 0, 0], [0, 1, 0], [0, 0, 1]].map(direction);
  const seen = p => {
    const way = direction(p);
    return {x: width / 2 + way.x * scale, y: height / 2 - way.y * scale, depth: way.depth * scale};
  };
  const parts = [], drawn = [], facing = new Map(), add = (depth, svg) => parts.push({depth, svg});
  const path = (style, d) => `<path class="${style}" d="${d}"/>`;
  const line = (a, b, depth, style) => {
    const dx = b.x - a.x, dy = b.y - a.y, steps = Math.floor(Math.sqrt(dx * dx + dy * dy) / 5) + 1;
    for (let i = 0; i <= steps; ++i) drawn.push([a.x + i / steps * dx, a.y + i / steps * dy]);
    add(depth, path(style, `M${pair(a.x, a.y)}L${pair(b.x, b.y)}`));
  };
  // Half an ellipse from c + u over c + f to c - u, as two Bezier curves.
  const half = (c, ux, uy, fx, fy) => {
    const k = 0.5522847498;
    return 'M' + pair(c.x + ux, c.y + uy) + 'C' + pair(c.x + ux + k * fx, c.y + uy + k * fy) + ' ' +
           pair(c.x + fx + k * ux, c.y + fy + k * uy) + ' ' + pair(c.x + fx, c.y + fy) + 'S' +
           pair(c.x - ux + k * fx, c.y - uy + k * fy) + ' ' + pair(c.x - ux, c.y - uy);
  };
  const draw = {
    face({style, empty}, corners, stroke) {
      if (!empty) add(facing.get(stroke).depth, path(style + ' face', 'M' + corners.map(p => pair(p.x, p.y)).join('L') + 'Z'));
    },
    facet(stroke, corners) {
      const spokes = corners.slice(1).map(p => [p.x - corners[0].x, p.y - corners[0].y, p.depth - corners[0].depth]);
      const normal = spokes.slice(1).reduce((sum, v, i) => plus(sum, cross(spokes[i], v)), [0, 0, 0]);
      const [dark, light] = normal[2] > 0 ? inside : outside;  // pixels go downwards
      const colour = `rgb(${between(dark, light, Math.abs(normal[2]) / (length(normal) || 1)).map(Math.round)})`;
      parts.push({depth: corners.reduce((sum, p) => sum + p.depth, 0) / corners.length, facet: true, svg: `<path ` +
          `class="facet" fill="${colour}" stroke="${colour}" d="M${corners.map(p => pair(p.x, p.y)).join('L')}Z"/>`});
    },
    edge({style, faces}, [a, b]) {
      const own = faces.map(face => facing.get(face)), hidden = own.length > 0 && own.every(face => face.away);
      const middle = (a.depth + b.depth) / 2, nearest = Math.max(middle, ...own.map(face => face.depth));
      // What is seen lies above its own faces.
      line(a, b, hidden ? middle : nearest, style + (hidden ? ' stroke hid' : ' stroke'));
    },
    arrow({style}, [a, b]) {
      const depth = (a.depth + b.depth) / 2, dx = b.x - a.x, dy = b.y - a.y, long = Math.sqrt(dx * dx + dy * dy);
      line(a, b, depth, style + ' stroke');
      if (long < 4) return;
      const back = Math.min(10, long), ux = back * dx / long, uy = back * dy / long;
      add(depth, path(style + ' head', `M${pair(b.x, b.y)}L${pair(b.x - ux - 0.4 * uy, b.y - uy + 0.4 * ux)}` +
                                       `L${pair(b.x - ux + 0.4 * uy, b.y - uy - 0.4 * ux)}Z`));
    },
    // Its outline, the equator and the meridians across x and z; the half behind of each lighter.
    ball({style, radius, empty}, [c]) {
      const r = radius * scale;
      let behind = '', before = '';
      for (const axis of axes) {
        const long = Math.sqrt(axis.x * axis.x + axis.y * axis.y);
        if (long < 1e-6) continue;
        const ux = r * axis.y / long, uy = r * axis.x / long;
        const fx = -r * axis.depth * axis.x / long, fy = r * axis.depth * axis.y / long;
        behind += half(c, ux, uy, -fx, -fy), before += half(c, ux, uy, fx, fy);
      }
      const round = `cx="${tenths(c.x)}" cy="${tenths(c.y)}" r="${tenths(r)}"/>`;
      add(c.depth - r, path(style + ' stroke hid thin', behind));
      if (!empty) add(c.depth, `<circle class="${style} face" ${round}`);
      add(c.depth, `<circle class="${style} stroke" ${round}`), add(c.depth + nearer, path(style + ' stroke thin', before));
      for (const [x, y] of diagonals)
        for (const part of [0.92, 1, 1.08]) drawn.push([c.x + part * r * x, c.y + part * r * y]);
    },
    disc({style, radius}, [c]) {
      const round = `cx="${tenths(c.x)}" cy="${tenths(c.y)}" r="${tenths(radius * scale)}"/>`;
      add(c.depth, `<circle class="${style} face" ${round}<circle class="${style} stroke" ${round}`);
    },
    dot({style, radius, ring}, [p]) {
      for (const dy of [-1, 0, 1]) for (const dx of [-1, 0, 1]) drawn.push([p.x + radius * dx, p.y + radius * dy]);
      add(p.depth + nearer, `<circle class="${style} ${ring ? 'ring' : 'dot'}" cx="${tenths(p.x)}" ` +
                            `cy="${tenths(p.y)}" r="${tenths(radius)}"/>`);
    },
  };
  const points = new Map(drawing.strokes.map(stroke => [stroke, stroke.points.map(seen)]));
  for (const [stroke, corners] of points) {
    if (stroke.kind !== 'face') continue;
    const next = i => corners[(i + 1) % corners.length];
    // Pixels go downwards: what is counter-clockwise to the reader has a negative area.
    const area = corners.reduce((sum, p, i) => sum + p.x * next(i).y - next(i).x * p.y, 0);
    facing.set(stroke, {away: area > 0, depth: corners.reduce((sum, p) => sum + p.depth, 0) / corners.length});
  }
  for (const [stroke, corners] of points) draw[stroke.kind](stroke, corners, stroke);
  // What else is drawn is seen through facets.
  parts.sort((a, b) => (b.facet ?? false) - (a.facet ?? false) || a.depth - b.depth);
  const tripod = axes.map((axis, i) => {
    const [x, y, dx, dy] = [30, height - 30, 20 * axis.x, -20 * axis.y];
    return path('tick', `M${pair(x, y)}L${pair(x + dx, y + dy)}`) +
           text(x + 1.4 * dx, y + 1.4 * dy + 4, 'middle', 'xyz'[i]);
  });
  const wishes = drawing.labels.map(label => {
    const places = label.places.map(seen).map(p => [p.x, p.y]), r = label.radius * scale;
    if (!places.length) return {...label, places};
    const round = diagonals.map(([x, y]) => [places[0][0] + r * x, places[0][1] + r * y]);
    return {...label, places: label.radius > 0 ? [...round, ...places] : places};
  });
  const mark = drawing.mark && seen(drawing.mark);
  const lens = mark ? `<path class="lens" d="M${pair(mark.x - 6, mark.y - 6)}h12v12h-12z"/>` : '';
  return tripod.join('') + parts.map(part => part.svg).join('') + lens + placedLabels(wishes, drawn, {width, height});
}

// Strokes at a time: straight from where a figure is at t = -1 to its points, and on to where it is at t = 1.
const strokesAt = (model, t) => new Strokes({...model, figures: model.figures.map(figure => !figure.moves ? figure :
    {...figure, points: figure.points.map(p => plus(p, figure.moves[t < 0 ? 0 : 1], Math.abs(t)))})});
// In the scale of all times.
const toScale = model => clock(model) ?
    {...model, reach: Math.max(...[-1, 0, 1].map(t => strokesAt(model, t).reach))} : model;

// A slider for time, where something moves.
function clock({figures}) {
  const moving = figures.filter(({moves}) => moves), first = moving.some(({moves}) => length(moves[0]) > 0) ? -1 : 0;
  return moving.length === 0 ? '' : `<p class="screen small time"><button class="play">Play</button> <label>time ` +
      `<input type="range" min="${first}" max="1" step="0.01" value="0"></label> <output>t = 0</output></p>`;
}

// The frame with the first view, and below it what does not turn.
function framed(model, drawing, name = 'whole') {
  const own = drawing.strokes.filter(({kind, style}) => kind !== 'facet' && !style.startsWith('node'));
  const line = i => height + 14 + 15 * i, many = own.length > manyStrokes ? ' many' : '', wide = width + 16;
  const below = Math.max(model.spans.length, model.remarks.length + (model.bar ? 1 : 0));
  const legend = drawing.legend.map((one, i) => `<text class="${one.style}" x="${i % 2 * width / 2}" ` +
      `y="${line(below + (i >> 1))}">${one.number} ${escaped(one.text)}</text>`);
  const high = line(below + (legend.length + 1 >> 1));
  const bar = ([steps, words]) => {
    const long = tenths(steps * room / drawing.reach);
    if (long > width / 2) return '';  // a single point has no scale
    return `<path class="tick" d="M${tenths(width - long)} ${height + 7}v6m0 -3h${long}m0 -3v6"/>` +
           text(width - long - 6, line(0), 'end', words);
  };
  return `<svg xmlns="http://www.w3.org/2000/svg" class="fig space turns ${name}" role="application" tabindex="0" ` +
      `aria-roledescription="figure that turns" viewBox="0 0 ${wide} ${high}" width="${wide}" height="${high}">` +
      `<title>${escaped(model.title)}</title><g transform="translate(8 8)">` +
      `<rect class="frame" width="${width}" height="${height}"/><svg width="${width}" height="${height}">` +
      `<g class="turning${many}">${picture(drawing, model.turn ?? firstTurn)}</g></svg>` +
      model.spans.map((span, i) => text(0, line(i), 'start', span)).join('') + (model.bar ? bar(model.bar) : '') +
      model.remarks.map((remark, i) => text(width, line(model.bar ? i + 1 : i), 'end', remark)).join('') +
      legend.join('') + `</g></svg>`;
}

// Draws the model and its lens into an element of the page; each turns as the reader asks.
function show(place, model) {
  const drawings = Object.entries({whole: toScale(model), ...(model.lens && {magnified: model.lens})})
      .map(([name, of]) => ({name, of, drawing: strokesAt(of, 0)}));
  place.innerHTML = '<div class="views">' + drawings.map(({name, of, drawing}) =>
      `<div class="view">${framed(of, drawing, name)}${clock(of)}</div>`).join('') + '</div>' +
      `<p class="screen small quiet turn-hint">Drag to turn it, or use the arrow keys; Home turns it back.</p>`;
  for (const {name, of, drawing} of drawings) {
    const draw = turning(place.querySelector('.' + name), place.querySelector(`.${name} .turning`), drawing,
                         of.turn ?? firstTurn);
    if (clock(of)) ticking(place, t => draw(strokesAt(of, t)));
  }
}

// Two seconds for a unit of time.
function ticking(place, draw) {
  const slider = place.querySelector('.time input'), words = place.querySelector('.time output');
  let played = 0;  // how often it was begun, or stopped
  const go = t => { words.textContent = `t = ${+Number(t).toFixed(2)}`, draw(Number(t)); };
  const run = (mine, since) => requestAnimationFrame(now => {
    if (mine !== played) return;
    slider.value = Math.min(1, Number(slider.min) + (now - (since ?? now)) / 2000);
    go(slider.value);
    if (slider.value < 1) run(mine, since ?? now);
  });
  slider.addEventListener('input', () => { ++played, go(slider.value); });
  place.querySelector('.time .play').addEventListener('click', () => run(++played));
}

// Returns what shows other strokes in the same view.
function turning(svg, group, drawing, first) {
  let yaw, pitch, held = null, waiting = false, last = first;
  const draw = turn => { group.innerHTML = picture(drawing, last = turn); };
  const start = () => {
    yaw = Math.atan2(first.sinYaw, first.cosYaw), pitch = Math.atan2(first.sinPitch, first.cosPitch);
  };
  const turn = (byYaw, byPitch) => {
    yaw += byYaw, pitch = Math.max(-Math.PI / 2, Math.min(Math.PI / 2, pitch + byPitch));
    if (waiting) return;
    waiting = true;
    requestAnimationFrame(() => {
      waiting = false;
      draw({cosYaw: Math.cos(yaw), sinYaw: Math.sin(yaw), cosPitch: Math.cos(pitch), sinPitch: Math.sin(pitch)});
    });
  };
  start();
  svg.addEventListener('pointerdown', event => {
    if (event.button !== 0) return;
    held = {id: event.pointerId, x: event.clientX, y: event.clientY};
    svg.setPointerCapture(event.pointerId);
  });
  svg.addEventListener('pointermove', event => {
    if (!held || held.id !== event.pointerId) return;
    turn((held.x - event.clientX) / 120, (event.clientY - held.y) / 120);
    held.x = event.clientX, held.y = event.clientY;
  });
  for (const end of ['pointerup', 'pointercancel', 'lostpointercapture'])
    svg.addEventListener(end, () => { held = null; });
  svg.addEventListener('keydown', event => {
    if (event.altKey || event.ctrlKey || event.metaKey) return;
    const step = Math.PI / 24;
    const way = {ArrowLeft: [step, 0], ArrowRight: [-step, 0], ArrowUp: [0, -step], ArrowDown: [0, step]}[event.key];
    if (way) turn(...way);
    else if (event.key === 'Home') start(), draw(first);
    else return;
    event.preventDefault();
  });
  return strokes => { drawing = strokes, draw(last); };
}

return {firstTurn, size: {width, height, room}, Strokes, picture, show};
})();

drawnAlone('space', viewer.show);
