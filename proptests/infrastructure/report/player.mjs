// SPDX-License-Identifier: Apache-2.0
// What report/scripts/player.js shows of runs, and how it plays them.
import assert from 'node:assert/strict';
import test from 'node:test';
import {Element, defined, documentOf, plain} from './browser.mjs';

const [viewer, player] = defined('viewer, player', ['drawn_alone.js', 'viewer.js', 'player.js'], documentOf({}));
const count = (svg, pattern) => (svg.match(new RegExp(pattern, 'g')) ?? []).length;
const all = {velocities: true, trails: true}, bare = {velocities: false, trails: false};

// A ball that moves along x by 1 a frame, and a box that rests; the second run is half a unit behind in the last frame.
const ball = {name: 'ball', shape: 'sphere', radius: 0.5, half: [0, 0, 0], fixed: false};
const box = {name: 'box', shape: 'box', radius: 0, half: [1, 2, 1], fixed: true};
const run = (name, late) => ({
  name,
  frames: [0, 1, 2, 3 - late].map(x => [x, 0, 0, 2, 0, 0, 9, 0, 0, 0, 0, 0]),
  contacts: [[], [], [[2.5, 0, 0]], []],
  energy: [2, 2, 2, 2 - late], law: [0, 0, 0, 0], scheme: [0, 0, 0, -late], decision: [0, 0, 0, 0],
  rounding: [0, 0, 1e-17, 1e-17],
  momentum: [[2, 0, 0], [2, 0, 0], [2, 0, 0], [2, 0, 0]],
});
const data = (more = {}) => ({
  timestep: 0.5, stride: 1, bodies: [ball, box], walls: [{name: 'floor', normal: [0, 3, 0], offset: 6}],
  runs: [run('float', 0.5), run('double', 0)], distances: [{runs: ['float', 'double'], values: [0, 0, 0, 0.5]}],
  partings: [{step: 3, runs: ['float', 'double'], contact: 'ball and box'}], ...more,
});

test('player: the view contains every frame of every run', () => {
  const {low, high, middle, scale, fastest} = player.extent(data());
  assert.deepEqual([low, high], [[-0.5, -2, -1], [10, 2, 1]]);
  assert.deepEqual(middle, [4.75, 0, 0]);
  assert.equal(scale, 200000 / 10.5);
  assert.equal(fastest, 2);
  assert.deepEqual(player.extent(data({room: [[-9, -9, -9], [11, 9, 9]]})).low, [-9, -9, -9]);
});

test('player: bodies are drawn at their place and in their size', () => {
  const one = data(), within = player.extent(one);
  const [floor, sphere, arrow, solid] = player.figures(one, one.runs[1], 1, within, all);
  assert.equal(floor.kind, 'plane');
  // The floor lies at y = -2, under the middle.
  assert.deepEqual(floor.points, [[0, Math.round(-2 * within.scale), 0], [0, Math.round(-2 * within.scale) + 25000, 0]]);
  assert.deepEqual([sphere.kind, sphere.points, sphere.radius],
                   ['sphere', [[Math.round(-3.75 * within.scale), 0, 0]], Math.round(0.5 * within.scale)]);
  assert.deepEqual([arrow.kind, arrow.points[1][0] - arrow.points[0][0]], ['arrow', 40000]);
  assert.deepEqual([solid.kind, solid.points],
                   ['box', [[3.25, -2, -1], [5.25, 2, 1]].map(p => p.map(x => Math.round(x * within.scale)))]);
  assert.equal(player.figures(one, one.runs[1], 1, within, bare).length, 3);
});

test('player: a wall that is far away is left out, and a room is a box', () => {
  const far = data({walls: [{name: 'far', normal: [0, 1, 0], offset: 1000}]}), within = player.extent(far);
  assert.ok(player.figures(far, far.runs[0], 0, within, bare).every(({kind}) => kind !== 'plane'));
  const room = data({walls: [], room: [[-1, -2, -1], [10, 2, 1]]});
  assert.equal(player.figures(room, room.runs[0], 0, player.extent(room), bare)[0].kind, 'box');
});

test('player: a contact is a ring in its own frame, a trail the places before', () => {
  const one = data(), within = player.extent(one);
  const svg = (frame, show) => player.drawn(one, one.runs[0], frame, within, show, viewer.firstTurn);
  assert.deepEqual([0, 1, 2, 3].map(frame => count(svg(frame, bare), ' ring"')), [0, 0, 1, 0]);
  assert.deepEqual([0, 1, 2, 3].map(frame => count(svg(frame, all), 'aid stroke"') - count(svg(frame, bare), 'aid stroke"') - 1),
                   [0, 1, 2, 3]);  // one more is the velocity
});

test('player: every number is finite, also when bodies rest or coincide', () => {
  const still = {name: 'only', frames: [[1, 1, 1, 0, 0, 0]], contacts: [[[1, 1, 1]]], energy: [0], law: [0],
                 scheme: [0], decision: [0], rounding: [0], momentum: [[0, 0, 0]]};
  const point = {name: 'p', shape: 'particle', radius: 0, half: [0, 0, 0], fixed: false};
  const one = {timestep: 1, stride: 1, bodies: [point], walls: [], runs: [still], distances: [], partings: []};
  const svg = player.drawn(one, still, 0, player.extent(one), all, viewer.firstTurn);
  const lines = player.plot([{name: 'a', values: [0], style: 'q0', dash: ''}], {frame: 0, marks: [], label: ''});
  const none = player.plot([{name: 'a', values: [0], style: 'q0', dash: ''}],
                           {frame: 0, marks: [], label: '', logarithmic: true});
  for (const drawn of [svg, lines, none]) assert.doesNotMatch(drawn, /NaN|Infinity|undefined/);
});

test('player: a plot spans its least to its greatest value, and marks where runs part', () => {
  const svg = player.plot([{name: 'a', values: [1, 3, 2], style: 'q0', dash: ''}], {frame: 1, marks: [2, 9], label: '<x>'});
  assert.match(svg, /d="M62 150L206 10L350 80"/);
  assert.equal(count(svg, 'class="mark"'), 1);
  assert.match(svg, /class="now" d="M206 10V150"/);
  assert.match(svg, /aria-label="&#60;x&#62;"/);
  assert.deepEqual([...svg.matchAll(/<text[^>]*>(.*?)<\/text>/g)].map(found => found[1]), ['1', '2', '3']);
});

test('player: a wall is drawn no larger than the frame', () => {
  const bounce = {...run('float', 0), frames: [0, 2].map(y => [0, y, 0, 0, 0, 0])};
  const point = {name: 'p', shape: 'particle', radius: 0, half: [0, 0, 0], fixed: false};
  const one = data({bodies: [point], walls: [{name: 'floor', normal: [0, 1, 0], offset: 0}], runs: [bounce]});
  const within = player.extent(one), [{points: [foot, tip]}] = player.figures(one, bounce, 0, within, bare);
  // The square about the foot, as viewer.js draws it: twice as far to its sides as the normal is long.
  const corner = [foot[0] + 2 * (tip[1] - foot[1]), foot[1], foot[2] + 2 * (tip[1] - foot[1])];
  assert.ok(Math.hypot(...corner) <= within.reach);
  assert.ok(Math.hypot(...corner) > 0.99 * within.reach);
});

test('player: a scene in a plane is first viewed from the front, and fills the frame', () => {
  const one = data({walls: [{name: 'floor', normal: [0, 1, 0], offset: 2}]}), within = player.extent(one);
  assert.ok(within.flat);
  const svg = player.drawn(one, one.runs[1], 0, within, bare, player.front);
  // The ball, 0.5 from the left end of 10.5, and 2 of 4 above the floor: 368 pixels are as wide as all that is drawn.
  const [, x, y, r] = /<circle[^>]*cx="([\d.]+)" cy="([\d.]+)" r="([\d.]+)"/.exec(svg) ?? /x/.exec(svg);
  assert.ok(Math.abs(x - (16 + 0.5 / 10.5 * 368)) < 0.1 && Math.abs(y - 150) < 0.1, `${x} ${y} ${r}`);
  // The floor from one end of the frame to the other.
  assert.match(svg, /M600 220.1L-200 220.1"/);
  const deep = (more, frame) => player.extent(data({...more, runs: [{...run('double', 0), frames: [frame]}]})).flat;
  const still = [0, 0, 0, 1, 0, 0, 9, 0, 0, 0, 0, 0], moving = [0, 0, 0, 1, 0, 1, 9, 0, 0, 0, 0, 0];
  assert.ok(deep({}, still) && !deep({}, moving));
  assert.ok(deep({walls: [{name: 'w', normal: [0, 0, 1], offset: 1}]}, still));
  assert.ok(!deep({walls: [{name: 'w', normal: [0, 1, 1], offset: 1}]}, still));
});

test('player: next to an engine robust is drawn as a ghost, without names and arrows', () => {
  const engine = {...run('engine', 0.5), engine: true};
  const one = data({runs: [run('double', 0), run('robust', 0), engine]});
  const within = player.extent(one), said = frame => player.figures(one, engine, frame, within, all)
      .filter(({whose}) => whose === 'answer');
  assert.deepEqual(said(3).map(({kind, label}) => [kind, label]), [['sphere', ''], ['box', '']]);
  assert.deepEqual(said(3)[0].points, player.figures(one, one.runs[1], 3, within, bare)[1].points);
  assert.ok(player.figures(one, one.runs[1], 3, within, all).every(({whose}) => whose === 'question'));
  const alone = data({runs: [run('double', 0), engine]});
  assert.ok(player.figures(alone, engine, 3, within, all).every(({whose}) => whose === 'question'));
  assert.match(plain(shown(one).place.innerHTML), /engine robust as a ghost/);
});

test('player: all plots have one axis of seconds, at one height', () => {
  const axis = more => [...player.plot([{name: 'a', values: [1, 3, 2], style: 'q0', dash: ''}],
                                       {frame: 0, marks: [], label: '', seconds: 10, ...more})
      .matchAll(/<text class="scale" x="([\d.]+)" y="165"[^>]*>(.*?)<\/text>/g)].map(found => found.slice(1));
  assert.deepEqual(axis({}), [['62', '0'], ['206', '5'], ['350', '10 s']]);
  assert.deepEqual(axis({logarithmic: true}), axis({}));
});

test('player: ticks are round numbers within the plot', () => {
  const ticks = values => [...player.plot([{name: 'a', values, style: 'q0', dash: ''}], {frame: 0, marks: [], label: ''})
      .matchAll(/<text[^>]*>(.*?)<\/text>/g)].map(found => found[1]);
  assert.deepEqual(ticks([19.077, 23.527]), ['20', '21', '22', '23']);
  assert.deepEqual(ticks([-0.12, 9.81]), ['0', '2', '4', '6', '8']);
  assert.deepEqual(ticks([0.31298, 8.9015]), ['2', '4', '6', '8']);
  assert.deepEqual(ticks([100, 900]), ['200', '400', '600', '800']);
  assert.deepEqual(ticks([9.9, 10.1]), ['9.9', '10', '10.1']);
});

test('player: among many bodies of one name, later ones show only their number', () => {
  const bodies = ['wall', 'ball_1', 'ball_2', 'cue', 'ball_10'].map(name => ({...ball, name}));
  const names = count => {
    const one = data({bodies: bodies.slice(0, count)}), frame = bodies.flatMap((_, i) => [i, 0, 0, 0, 0, 0]);
    return player.figures(one, {frames: [frame]}, 0, player.extent(data()), bare).filter(({label}) => label)
        .map(({label}) => label);
  };
  assert.deepEqual(names(5), ['wall', 'ball_1', '2', 'cue', '10']);
  assert.deepEqual(names(3), ['wall', 'ball_1', 'ball_2']);
});

test('player: if numbers differ only far behind the decimal point, ticks show the difference', () => {
  const svg = player.plot([{name: 'a', values: [4.5, 4.5 - 2e-6], style: 'q0', dash: ''}], {frame: 0, marks: [], label: ''});
  assert.deepEqual([...svg.matchAll(/<text[^>]*>(.*?)<\/text>/g)].map(found => found[1]),
                   ['\u22122.0e\u22126', '\u22121.0e\u22126', '0', 'differences from 4.5']);
});

test('player: a constant has one tick, and a logarithmic plot of zeros says so', () => {
  const texts = (values, logarithmic) =>
      [...player.plot([{name: 'a', values, style: 'q0', dash: ''}], {frame: 0, marks: [], label: '', logarithmic})
          .matchAll(/<text[^>]*>(.*?)<\/text>/g)].map(found => found[1]);
  assert.deepEqual(texts([2, 2], false), ['2']);
  assert.deepEqual(texts([0, 0], true), ['0 throughout']);
  assert.deepEqual(texts([1, 5], true), ['1e0', '1e1', '1e2']);
});

test('player: a logarithmic plot leaves out what is 0', () => {
  const svg = player.plot([{name: 'a', values: [0, 1e-8, 0, 1e-4, 1e-2], style: 'q0', dash: ''}],
                          {frame: 0, marks: [], label: '', logarithmic: true});
  assert.match(svg, /d="M134 150M278 56.7L350 10"/);
  assert.match(svg, />1e\u22128</);
});

test('player: an engine that ended stays where it ended, and its lines end there', () => {
  const short = {...run('engine', 0), engine: true, ended: 'step 2: no answer'};
  for (const list of ['frames', 'contacts', 'energy', 'law', 'scheme', 'decision', 'rounding', 'momentum'])
    short[list] = short[list].slice(0, 2);
  const one = data(), within = player.extent(one);
  assert.equal(player.drawn(one, short, 3, within, bare, viewer.firstTurn),
               player.drawn(one, short, 1, within, bare, viewer.firstTurn));
  const svg = player.plot([{name: 'engine', values: short.energy, style: 'q0', dash: ''}],
                          {frame: 3, frames: 3, marks: [], label: ''});
  // Two of four frames: a third of the way from 62 to 350.
  assert.match(svg, /d="M62 [\d.]+L158 [\d.]+"/);
  const page = shown(data({runs: [run('robust', 0), short]}));
  const facts = i => plain(page.place.parts['.run'][i].querySelector('.facts').innerHTML);
  assert.doesNotMatch(facts(1), /ended/);
  for (let i = 0; i < 3; ++i) page.click('.next');
  assert.match(facts(1), /drift of its own.*ended.*step 2: no answer/s);
  assert.doesNotMatch(facts(0), /ended|of its own/);
});

// The page, with the parts that it asks for, and the frames of animation that it waits for.
function shown(one = data()) {
  const place = new Element(), frames = [];
  globalThis.requestAnimationFrame = frame => frames.push(frame);
  const mark = new Element();
  mark.dataset.step = '3';
  Object.assign(place.parts, {'.run': one.runs.map(() => new Element()), '.mark': [mark]});
  place.querySelector('.speed').value = '1';
  player.show(place, one);
  const part = name => place.querySelector(name);
  return {
    place, mark, part,
    click: (name, more = {}) => part(name).send('click', more),
    where: () => part('.where').textContent,
    now(time) { for (const frame of frames.splice(0)) frame(time); },
  };
}

test('player: it begins at the start, with a view, facts and plots for each run, and no markup from names', () => {
  const page = shown(data({bodies: [{...ball, name: '<b>'}, box]}));
  assert.equal(page.where(), 'step 0 of 3, 0.000 s');
  assert.match(plain(page.place.innerHTML), /float.*double.*Play.*step 3: float and double part at ball and box/s);
  for (const view of page.place.parts['.run']) {
    assert.match(view.querySelector('.turning').innerHTML, /<circle/);
    assert.doesNotMatch(view.querySelector('.turning').innerHTML, /<b>/);
    assert.match(plain(view.querySelector('.facts').innerHTML), /energy2.*scheme0/);
  }
  for (const name of ['.energy', '.momentum', '.distance']) assert.match(page.part(name).innerHTML, /<svg/);
});

test('player: buttons, keys, the slider, a mark and a click in a plot go to a step, and no further than the ends', () => {
  const page = shown(), at = () => Number(/step (\d+)/.exec(page.where())[1]);
  page.click('.back');
  assert.equal(at(), 0);
  page.click('.next');
  assert.equal(at(), 1);
  assert.ok(page.place.send('keydown', {key: 'ArrowRight'}));
  assert.equal(at(), 2);
  assert.ok(page.place.send('keydown', {key: 'ArrowLeft'}));
  assert.equal(at(), 1);
  assert.ok(!page.place.send('keydown', {key: 'ArrowRight', ctrlKey: true}));
  assert.ok(!page.place.send('keydown', {key: 'ArrowRight', target: {tagName: 'INPUT'}}));
  page.part('.scrub').send('input', {target: {value: '0'}});
  assert.equal(at(), 0);
  page.mark.send('click', {});
  assert.equal(at(), 3);
  page.click('.next');
  assert.equal(at(), 3);
  page.part('.energy').width = 360;
  page.click('.energy', {clientX: 206, currentTarget: page.part('.energy')});
  assert.equal(at(), 2);
});

test('player: a page whose address names a step begins there, and goes there when the address changes', () => {
  const listeners = {};
  globalThis.addEventListener = (name, listener) => { listeners[name] = listener; };
  try {
    globalThis.location = {hash: '#step=2'};
    const page = shown();
    assert.equal(page.where(), 'step 2 of 3, 1.000 s');
    globalThis.location.hash = '#step=99';
    listeners.hashchange();
    assert.equal(page.where(), 'step 3 of 3, 1.500 s');
    globalThis.location.hash = '#energy';
    listeners.hashchange();
    assert.equal(page.where(), 'step 3 of 3, 1.500 s');
    assert.equal(shown().where(), 'step 0 of 3, 0.000 s');
  } finally {
    delete globalThis.location;
    delete globalThis.addEventListener;
  }
});

test('player: it plays in real time, scaled by its speed, and stops at the end', () => {
  const page = shown(), play = page.part('.play');
  page.click('.play');
  assert.deepEqual([play.textContent, play.attributes['aria-pressed']], ['Pause', 'true']);
  page.now(1000);
  page.now(1400);
  assert.match(page.where(), /^step 0 /);
  page.now(1500);  // half a second is a step
  assert.match(page.where(), /^step 1 /);
  page.part('.speed').value = '4';
  page.now(1625);
  assert.match(page.where(), /^step 2 /);
  page.now(9000);
  assert.match(page.where(), /^step 3 /);
  assert.equal(play.textContent, 'Play');
  assert.ok(page.place.send('keydown', {key: ' '}));  // from the end it begins anew
  assert.match(page.where(), /^step 0 /);
  assert.ok(page.place.send('keydown', {key: ' '}));
  page.now(10000);
  page.now(20000);
  assert.match(page.where(), /^step 0 /);
});

test('player: a drag rotates every run alike; velocities and trails can be switched off', () => {
  const page = shown(), [first, second] = page.place.parts['.run'], views = () =>
      [first, second].map(view => view.querySelector('.turning').innerHTML);
  const before = views();
  const send = (type, clientX, more = {}) => first.querySelector('svg').send(type, {clientX, clientY: 10, ...more});
  send('pointermove', 90);
  assert.deepEqual(views(), before);
  send('pointerdown', 10);
  send('pointermove', 90);
  const turned = views();
  assert.notEqual(turned[0], before[0]);
  assert.equal(turned[0], turned[1]);  // they are alike at the start
  send('pointerup', 90);
  send('pointermove', 10);
  assert.deepEqual(views(), turned);
  page.part('.velocities').send('change', {target: {checked: false}});
  assert.equal(count(views()[0], ' head"'), 1);  // that of the floor
});

test('player: a long run shows every second step', () => {
  const page = shown(data({stride: 2}));
  page.click('.next');
  assert.equal(page.where(), 'step 2 of 6, 1.000 s');
});
