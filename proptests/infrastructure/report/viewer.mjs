// SPDX-License-Identifier: Apache-2.0
// What report/scripts/viewer.js draws of a model, and how it turns. Expected places follow from its projection: from before, x
// is to the right and y up, and what is farthest from the middle is 134 pixels from it.
import assert from 'node:assert/strict';
import test from 'node:test';
import {Element, defined, documentOf, plain} from './browser.mjs';

const files = ['drawn_alone.js', 'viewer.js'], [viewer] = defined('viewer', files, documentOf({}));
const fromBefore = {cosYaw: 1, sinYaw: 0, cosPitch: 1, sinPitch: 0};
const end = 100000, o = [0, 0, 0], x = [end, 0, 0], y = [0, end, 0], z = [0, 0, end];

const figure = (kind, points, more = {}) => ({kind, label: kind, whose: 'question', points, ...more});
const modelOf = (...figures) => ({title: 'a title', figures, spans: ['x: 0', 'y: 0', 'z: 0'], remarks: []});
const drawn = (figures, turn = viewer.firstTurn) => viewer.picture(new viewer.Strokes(modelOf(...figures)), turn);
const count = (svg, pattern) => (svg.match(new RegExp(pattern, 'g')) ?? []).length;
const strokes = svg => ({
  faces: count(svg, ' face"'), edges: count(svg, ' stroke( hid)?" d='), hidden: count(svg, ' stroke hid" d='),
  heads: count(svg, ' head"'), dots: count(svg, ' dot"'), rings: count(svg, ' ring"'),
});
const texts = svg => [...svg.matchAll(/<text class="(q\d|truth|said|aid)"[^>]*>(.*?)<\/text>/g)].map(
    found => [found[1], plain(found[2])]);
const none = {faces: 0, edges: 0, hidden: 0, heads: 0, dots: 0, rings: 0};
const tetrahedron = figure('mesh', [o, x, y, z], {faces: [[0, 2, 1], [0, 1, 3], [0, 3, 2], [1, 2, 3]]});

for (const [one, wanted] of [
  [figure('point', [x]), {dots: 1}],
  [figure('segment', [o, x]), {edges: 1, dots: 2}],
  [figure('arrow', [o, x]), {edges: 1, heads: 1, dots: 1}],
  [figure('plane', [o, y]), {faces: 1, edges: 5, heads: 1}],
  [figure('polygon', [x, y, z]), {faces: 1, edges: 3}],
  [figure('box', [o, [end, end, end]]), {faces: 6, edges: 12, hidden: 3}],
  [figure('sphere', [o], {radius: end}), {faces: 1, edges: 0, dots: 1}],
  [tetrahedron, {faces: 4, edges: 6, hidden: 3}],
]) {
  test(`viewer: ${one.kind} is drawn, with its label`, () => {
    const svg = drawn([one]);
    assert.deepEqual(strokes(svg), {...none, ...wanted});
    assert.deepEqual(texts(svg), [['q0', one.kind]]);
  });
}

test('viewer: a sphere is an outline with an equator and meridians', () => {
  const svg = drawn([figure('sphere', [o], {radius: end})], fromBefore);
  assert.equal(count(svg, '<circle class="q0 stroke" cx="200" cy="150" r="134"/>'), 1);
  assert.equal(count(svg, 'stroke thin"'), 1);
  assert.equal(count(svg, 'stroke hid thin"'), 1);
});

test('viewer: the truth is a ring and says so, an answer has a colour of its own', () => {
  const svg = drawn([figure('point', [x]), figure('point', [y], {whose: 'truth'}),
                     figure('point', [z], {whose: 'answer', label: 'answered'}),
                     tetrahedron, {...tetrahedron, whose: 'truth', label: ''}]);
  assert.equal(strokes(svg).rings, 1);
  assert.deepEqual(texts(svg), [['q0', 'point'], ['truth', 'truth: point'], ['said', 'answered'], ['q1', 'mesh'],
                                ['truth', 'truth']]);
});

test('viewer: a list has one colour and one name, an auxiliary line has none', () => {
  const list = [...Array(3).keys()].map(i => figure('point', [[end - i * 60000, 0, 0]], {label: `points[${i}]`}));
  const svg = drawn([...list, figure('segment', [o, y], {label: ''}), figure('point', [z])]);
  assert.deepEqual(texts(svg), [['q0', 'points[0]'], ['q0', '[1]'], ['q0', '[2]'], ['q1', 'point']]);
  assert.equal(count(svg, 'class="aid stroke"'), 1);
  const bare = [0, 1].map(i => figure('point', [[i * end, 0, 0]], {label: `[${i}]`}));
  assert.deepEqual(texts(drawn(bare)), [['q0', '[0]'], ['q0', '[1]']]);
  const long = [...Array(21).keys()].map(i => figure('point', [[i * 4000, 0, 0]], {label: `points[${i}]`}));
  assert.deepEqual(texts(drawn(long)), [['q0', 'points']]);
});

test('viewer: a node of a structure is a thin line, thinner the deeper, and filled where a search entered it', () => {
  const box = [o, [end, end, end]], node = (depth, entered, kind = 'box', points = box, more = {}) =>
      figure(kind, points, {label: '', node: depth, entered, ...more});
  const passed = drawn([node(0, true)]), left = drawn([node(3, false)]), deepest = drawn([node(4, false)]);
  assert.deepEqual([count(passed, 'class="node face"'), count(passed, 'class="node stroke( hid)?"')], [6, 12]);
  assert.deepEqual([count(left, ' face"'), count(left, 'class="node deep stroke( hid)?"')], [0, 12]);
  assert.equal(count(deepest, 'class="node deepest stroke( hid)?"'), 12);
  const ball = entered => drawn([node(1, entered, 'sphere', [o], {radius: end})]);
  assert.deepEqual([count(ball(true), '<circle class="node face"'), count(ball(false), ' face"')], [1, 0]);
  assert.equal(strokes(ball(true)).dots, 0);  // a node has no dots, not even a small one
  assert.equal(strokes(drawn([node(0, true, 'box', [o, [9, 9, 9]]), figure('point', [x])])).dots, 1);
  // It takes no colour from what the question consists of.
  assert.deepEqual(texts(drawn([node(0, true), figure('point', [x])])), [['q0', 'point']]);
});

test('viewer: figures of the truth without a name are named once', () => {
  const truth = at => figure('point', [at], {label: '', whose: 'truth'});
  assert.deepEqual(texts(drawn([truth(x), truth(y)])), [['truth', 'truth']]);
});

test('viewer: the parts of one shape bear its name once, and another shape of that name its own', () => {
  const capsule = [figure('segment', [o, y]), ...[o, y].map(at => figure('sphere', [at], {radius: 900}))];
  const named = capsule.map(part => ({...part, label: 'capsule'}));
  const other = figure('point', [z], {label: 'capsule', whose: 'answer'});
  assert.deepEqual(texts(drawn([...named, other])), [['q0', 'capsule'], ['said', 'capsule']]);
});

test('viewer: a label is no markup', () => {
  const svg = drawn([figure('point', [x], {label: '<b>&"'})]);
  assert.ok(!svg.includes('<b>'));
  assert.deepEqual(texts(svg), [['q0', '<b>&"']]);
});

test('viewer: from the front x is to the right and y up; a quarter turn brings z there', () => {
  const place = (p, turn) =>
      /<circle class="q0 dot" cx="(.*?)" cy="(.*?)"/.exec(drawn([figure('point', [p])], turn)).slice(1, 3).map(Number);
  const quarter = {...fromBefore, cosYaw: 0, sinYaw: 1}, above = {...fromBefore, cosPitch: 0, sinPitch: 1};
  assert.deepEqual(place(x, fromBefore), [334, 150]);
  assert.deepEqual(place(y, fromBefore), [200, 16]);
  assert.deepEqual(place(z, fromBefore), [200, 150]);
  assert.deepEqual(place(z, quarter), [66, 150]);
  assert.deepEqual(place(z, above), [200, 284]);
  assert.deepEqual(place(y, above), [200, 150]);
  assert.deepEqual(place(x, {...above, cosYaw: 0, sinYaw: 1}), [200, 284]);
});

test('viewer: a plane is a square about its point, twice its normal to each side', () => {
  // From straight above, its corners are farthest from the middle: 134 / sqrt(2) pixels in each direction.
  const plane = figure('plane', [o, [0, 40000, 0]]), above = drawn([plane], {...fromBefore, cosPitch: 0, sinPitch: 1});
  const corners = / face" d="M(.*?)Z"/.exec(above)[1].split('L').sort();
  assert.deepEqual(corners, ['105.2 244.8', '105.2 55.2', '294.8 244.8', '294.8 55.2']);
  assert.match(drawn([plane], fromBefore), / head" d="M200 102.6L/);  // 150 - 134 / (2 sqrt(2))
});

test('viewer: nearer figures are drawn later', () => {
  for (const points of [[z, [0, 0, -end]], [[0, 0, -end], z]]) {
    const kinds = points.map(p => figure(p[2] > 0 ? 'point' : 'sphere', [p], {radius: 10}));
    const svg = drawn(kinds, fromBefore);
    assert.ok(svg.indexOf('r="4.2"') > svg.indexOf('r="3.2"'));
  }
});

test('viewer: nothing hides the rim of an open surface', () => {
  const away = figure('mesh', [x, y, z], {faces: [[0, 2, 1]]});
  assert.deepEqual(strokes(drawn([away])), {...none, faces: 1, edges: 3});
});

test('viewer: labels do not cover one another', () => {
  const near = [0, 900, 1800].map(at => figure('point', [[at, 0, 0]], {label: `a long label ${at}`}));
  const svg = drawn([...near, figure('point', [x])], fromBefore);
  const boxes = [...svg.matchAll(/<text class="q\d" x="(.*?)" y="(.*?)">(.*?)</g)]
      .map(([, left, base, words]) => ({left: +left, right: +left + 6.9 * words.length, bottom: +base + 3.5}));
  assert.equal(boxes.length, 4);
  for (const a of boxes)
    for (const b of boxes)
      assert.ok(a === b || a.right <= b.left || b.right <= a.left || Math.abs(a.bottom - b.bottom) >= 15);
});

test('viewer: a mesh is drawn without a face that names no vertex', () => {
  const mesh = figure('mesh', [o, x], {faces: [[0, 1, 7]]});
  assert.deepEqual(strokes(drawn([mesh])), {...none, dots: 2});
});

test('viewer: a figure outside a lens is not drawn, and the next one keeps its colour', () => {
  const kinds = ['point', 'segment', 'arrow', 'plane', 'polygon', 'box', 'sphere', 'mesh'];
  for (const kind of kinds) {
    const svg = drawn([figure(kind, [], {radius: end, faces: [], places: []}), figure('point', [x], {label: 'seen'})]);
    assert.deepEqual([strokes(svg), texts(svg)], [{...none, dots: 1}, [['q1', 'seen']]], kind);
  }
});

test('viewer: a figure that cannot be drawn says so in text, and the figures after it are drawn', () => {
  const place = (space, words) => {
    const made = Object.assign(new Element(), {dataset: {space}});
    made.parts.noscript = [{textContent: words}];
    return made;
  };
  const whole = JSON.stringify(modelOf(tetrahedron));
  const places = [place(whole, 'A'), place('{"figures":[{}]}', '<p>B</p>'), place(whole, 'C')], told = [];
  const {error} = console;
  console.error = failed => told.push(failed);
  defined('viewer', files, documentOf({'[data-space]': places}));
  return new Promise(setImmediate).then(() => {
    console.error = error;
    assert.deepEqual(places.map(one => count(one.innerHTML, ' face"')), [4, 0, 4]);
    assert.match(plain(places[1].innerHTML), /^This could not be drawn: TypeError: .*\.B$/);
    assert.doesNotMatch(places[0].innerHTML + places[2].innerHTML, /could not/);
    assert.deepEqual(told.map(failed => failed.name), ['TypeError']);
  });
});

test('viewer: a figure that is too small to see gets a dot, and a single point is in the middle', () => {
  const small = figure('polygon', [x, [end - 9, 0, 0], [end, 9, 0]]), far = figure('point', [o]);
  assert.equal(strokes(drawn([small, far])).dots, 2);
  assert.match(drawn([figure('point', [o])]), /cx="200" cy="150"/);
});

test('viewer: every number is finite, also when figures coincide', () => {
  const kinds = [figure('segment', [o, o]), figure('arrow', [o, o]), figure('polygon', [o, o, o]),
                 figure('box', [o, o]), figure('sphere', [o], {radius: 0}),
                 figure('mesh', [o, o, o], {faces: [[0, 1, 2]]}),
                 figure('plane', [[3 * end, -3 * end, 1], [3 * end, -3 * end, 40001]])];
  for (const one of [...kinds.map(kind => [kind]), kinds, []])
    for (const turn of [viewer.firstTurn, fromBefore]) assert.doesNotMatch(drawn(one, turn), /NaN|Infinity|undefined/);
});

test('viewer: a lens is a second figure with a view of its own, and a mark is where it magnifies', () => {
  const lens = {...modelOf(figure('mesh', [x, y, z], {faces: [[0, 1, 2]], label: 'near', places: [o]})), reach: end,
                mark: x, turn: fromBefore, spans: ['around near, 8 wide; gap 1']};
  const place = new Element();
  viewer.show(place, {...modelOf(figure('point', [x])), lens});
  assert.equal(count(place.innerHTML, '<svg xmlns'), 2);
  assert.equal(count(place.innerHTML, 'class="lens"'), 1);
  assert.equal(count(place.innerHTML, 'turn-hint'), 1);
  assert.match(place.innerHTML, /around near, 8 wide; gap 1/);
  assert.match(place.innerHTML, /M334 150L200 16L200 150Z/);  // its corners, 134 pixels from the middle
});

test('viewer: a label for which there is no room is left out', () => {
  const crowd = [...Array(20).keys()].map(at => figure('point', [[at, 0, 0]], {label: `a label that is rather long ${at}`}));
  const left = texts(drawn([...crowd, figure('point', [x])], fromBefore)).length;
  assert.ok(left > 4 && left < 21, `${left} labels`);
});

// A figure on a page, what it shows, and the frames that it asks for.
function shown(...figures) {
  const place = new Element(), group = place.querySelector('.whole .turning'), svg = place.querySelector('.whole');
  const frames = [];
  globalThis.requestAnimationFrame = frame => frames.push(frame);
  viewer.show(place, modelOf(...figures));
  const first = /<g class="turning">(.*?)<\/g>/s.exec(place.innerHTML)[1];
  group.innerHTML = first;
  return {first, svg, place, waiting: () => frames.length, now(time) {
    for (const frame of frames.splice(0)) frame(time);
    return group.innerHTML;
  }};
}

test('viewer: the first view uses no function that browsers implement differently', () => {
  const {sin, cos} = Math, refused = () => { throw new Error('asked'); };
  Object.assign(Math, {sin: refused, cos: refused});
  try {
    assert.equal(shown(tetrahedron).first, drawn([tetrahedron]));
  } finally {
    Object.assign(Math, {sin, cos});
  }
});

test('viewer: the arrow keys rotate the figure, and Home rotates it back', () => {
  const page = shown(tetrahedron), press = (key, more = {}) => page.svg.send('keydown', {key, ...more});
  const views = ['ArrowLeft', 'ArrowUp', 'ArrowRight', 'ArrowDown'].map(key => {
    assert.ok(press(key));
    return page.now();
  });
  assert.equal(new Set([page.first, ...views.slice(0, 3)]).size, 4);
  assert.equal(views[3], page.first);
  press('ArrowLeft');
  press('ArrowLeft');
  assert.notEqual(page.now(), page.first);
  assert.ok(press('Home'));
  assert.equal(page.now(), page.first);
  assert.ok(!press('Tab') && !press('ArrowLeft', {ctrlKey: true}));
  assert.equal(page.now(), page.first);
});

test('viewer: it rotates no further than to the view from straight above or below', () => {
  const page = shown(tetrahedron), turned = (key, times) => {
    for (let i = 0; i < times; ++i) page.svg.send('keydown', {key});
    return page.now();
  };
  assert.equal(turned('ArrowDown', 24), turned('ArrowDown', 3));
  assert.notEqual(turned('ArrowUp', 1), turned('ArrowUp', 1));
});

test('viewer: a drag rotates it with the pointer that holds it, until the pointer is released', () => {
  const page = shown(tetrahedron), send = (type, clientX, clientY, more = {}) =>
      page.svg.send(type, {clientX, clientY, ...more});
  send('pointermove', 50, 50);
  send('pointerdown', 10, 10, {button: 2});
  send('pointermove', 50, 50);
  assert.equal(page.now(), page.first);
  send('pointerdown', 10, 10);
  send('pointermove', 50, 50, {pointerId: 2});
  assert.equal(page.now(), page.first);
  send('pointermove', 50, 10);
  const turned = page.now();
  assert.notEqual(turned, page.first);
  send('pointermove', 10, 10);
  assert.equal(page.now(), page.first);
  for (const end of ['pointerup', 'pointercancel', 'lostpointercapture']) {
    send('pointerdown', 10, 10);
    send(end, 10, 10);
    send('pointermove', 50, 10);
    assert.equal(page.now(), page.first);
  }
});

test('viewer: a moving figure is where the clock says, in one scale, and rotates with the rest', () => {
  const still = figure('point', [y]), moves = [[-end, 0, 0], [0, 0, 2 * end]];
  const ball = figure('point', [o], {label: 'ball', moves});
  const page = shown(still, ball), slider = page.place.querySelector('.time input');
  const words = page.place.querySelector('.time output');
  const place = () => / class="q1 dot" cx="(.*?)" cy="(.*?)"/.exec(page.now()).slice(1, 3).map(Number);
  const at = t => (slider.value = String(t), slider.send('input', {}), place());
  assert.match(page.place.innerHTML, /<input type="range" min="-1" max="1"/);
  // Half as large as a figure that stands still: at t = 1 it is twice as far from the middle as anything else.
  const turned = p => {
    const svg = viewer.picture(Object.assign(new viewer.Strokes(modelOf(figure('point', [p]))), {reach: 2 * end}),
                               viewer.firstTurn);
    return /cx="(.*?)" cy="(.*?)"/.exec(svg).slice(1, 3).map(Number);
  };
  const wanted = [[0, o], [-1, [-end, 0, 0]], [-0.5, [-end / 2, 0, 0]], [1, [0, 0, 2 * end]], [0.25, [0, 0, end / 2]]];
  for (const [t, p] of wanted) assert.deepEqual(at(t), turned(p), `t = ${t}`);
  assert.equal(words.textContent, 't = 0.25');
  const before = page.now();
  page.svg.send('keydown', {key: 'ArrowLeft'});
  assert.notEqual(page.now(), before);
  page.svg.send('keydown', {key: 'Home'});
  assert.deepEqual(at(0.25), turned([0, 0, end / 2]));
});

test('viewer: Play runs from the first time to t = 1 and stops there; a step of the reader stops it', () => {
  const ball = figure('point', [o], {moves: [[0, 0, 0], [end, 0, 0]]}), page = shown(figure('point', [x]), ball);
  const slider = page.place.querySelector('.time input'), play = page.place.querySelector('.time .play');
  assert.match(page.place.innerHTML, /<input type="range" min="0" max="1"/);
  slider.min = '0';
  play.send('click', {});
  page.now(5000);
  assert.equal(Number(slider.value), 0);
  page.now(6000);
  assert.equal(Number(slider.value), 0.5);
  slider.send('input', {});
  page.now(6500);
  assert.equal(Number(slider.value), 0.5);
  play.send('click', {});
  page.now(7000);
  play.send('click', {});  // once more: it begins again, and one clock runs
  page.now(7500);
  assert.equal(Number(slider.value), 0);
  assert.equal(page.waiting(), 1);
  for (const now of [8000, 9000, 11000, 12000]) page.now(now);
  assert.equal(Number(slider.value), 1);
  assert.equal(page.waiting(), 0);
});

test('viewer: a figure in which nothing moves has no clock', () => {
  assert.doesNotMatch(shown(tetrahedron).place.innerHTML, /range/);
});

test('viewer: below the frame are the spans, then a bar of the stated length, then remarks', () => {
  const place = new Element();
  viewer.show(place, {...modelOf(figure('segment', [o, x])), bar: [end / 2, '0.5'], remarks: ['a remark']});
  const below = plain(place.innerHTML.replace(/<g class="turning">.*?<\/g>/s, '').replaceAll('</text>', '\n'));
  for (const line of ['x: 0', 'y: 0', 'z: 0', '0.5', 'a remark']) assert.ok(below.includes(line));
  assert.match(place.innerHTML, /<path class="tick" d="M333 307v6m0 -3h67m0 -3v6"\/>/);
  assert.match(place.innerHTML, /<title>a title<\/title>/);
});

test('viewer: a mesh of many faces is opaque, its inside has another colour, and marked places show through it', () => {
  // A fan of triangles across the x-y plane, which turns to the reader, and one that turns away behind it.
  const rays = 500, fan = [...Array(rays).keys()].map(i => [0, 1 + i, 1 + (i + 1) % rays]);
  const ring = depth => [[0, 0, depth], ...[...Array(rays).keys()].map(i =>
      [end * Math.cos(2 * Math.PI * i / rays), end * Math.sin(2 * Math.PI * i / rays), depth].map(Math.round))];
  const front = figure('mesh', ring(end / 2), {faces: fan});
  const svg = drawn([front, figure('segment', [[0, 0, -end], [end, 0, -end]])], fromBefore);
  assert.deepEqual([count(svg, 'class="facet" fill="rgb\\(205,219,235\\)"'), count(svg, ' face"')], [rays, 0]);
  assert.ok(svg.lastIndexOf('facet') < svg.indexOf(' stroke"'));  // although it is behind the mesh
  assert.deepEqual(texts(svg), [['q0', 'mesh'], ['q1', 'segment']]);
  const back = drawn([{...front, faces: fan.map(face => [...face].reverse())}], fromBefore);
  assert.equal(count(back, 'class="facet" fill="rgb\\(232,160,98\\)"'), rays);
  const few = drawn([{...front, faces: fan.slice(0, 450)}], fromBefore);
  assert.deepEqual([count(few, 'facet'), count(few, ' face"')], [0, 450]);
});

test('viewer: an arrow without length has no name; many names go into a legend, and the arrows are numbered', () => {
  const arrows = [...Array(7).keys()].map(i => figure('arrow', [o, [end, i * 9000, 0]], {label: `velocity of ${'abcdefg'[i]}`}));
  const nothing = figure('arrow', [x, x], {label: 'at rest'});
  const few = new viewer.Strokes(modelOf(...arrows, nothing));
  assert.deepEqual(few.labels.map(label => label.text), arrows.map(arrow => arrow.label));
  assert.deepEqual(few.legend, []);
  const many = new viewer.Strokes(modelOf(figure('sphere', [o], {radius: end}), ...arrows, nothing));
  assert.deepEqual(many.labels.map(label => label.text), ['sphere', '1', '2', '3', '4', '5', '6', '7']);
  assert.deepEqual(many.legend.map(({number, text}) => `${number} ${text}`),
                   arrows.map((arrow, i) => `${i + 1} ${arrow.label}`));
  const place = new Element();
  viewer.show(place, modelOf(figure('sphere', [o], {radius: end}), ...arrows));
  assert.match(plain(place.innerHTML), /7 velocity of g/);
});
