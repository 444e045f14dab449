// SPDX-License-Identifier: Apache-2.0
// The figures of the deck that are dragged: arithmetic, answers worked out by hand, and points that break a formula.
import assert from 'node:assert/strict';
import test from 'node:test';
import {readFileSync} from 'node:fs';
import {defined, documentOf} from './browser.mjs';

const files = ['drawn_alone.js', 'drag.js', 'drag_trees.js', 'drag_figures.js'];
const [drag, figures] = defined(['drag', 'drag_figures'], files, documentOf({}));
const {exact} = drag;
const said = (name, points, who = -1) => drag.answers(figures[name], points).at(who)[1];
const inDouble = 1;

test('drag: exact numbers are the doubles themselves, and nothing is less or greater than what is divided by 0', () => {
  const [a, b, c] = [0.1, 0.2, 0.3].map(exact.of);
  assert.equal(0.1 + 0.2, 0.30000000000000004);
  assert(exact.less(c, exact.add(a, b)));  // 0.1 and 0.2 lie above their decimals, 0.3 below
  assert(exact.equal(exact.div(exact.of(3), exact.of(-6)), exact.of(-0.5)));
  const none = exact.div(a, exact.zero);
  assert(!exact.less(none, a) && !exact.less(a, none) && !exact.equal(none, none));
  assert.equal(exact.value(exact.mul(exact.of(-1.5), exact.of(2))), -3);
});

test('drag: every figure of the deck is there, draws its start and answers', () => {
  const sections = JSON.parse(readFileSync(new URL('../../../report/pages/deck.json', import.meta.url), 'utf8'));
  const wanted = sections.map(section => section.drag).filter(Boolean);
  assert.deepEqual([...wanted].sort(), Object.keys(figures).sort());
  for (const [name, figure] of Object.entries(figures)) {
    assert.equal(figure.names.length, figure.start.length, name);
    const svg = drag.drawn(figure, figure.start);
    assert.doesNotMatch(svg, /NaN|undefined|Infinity/, name);
    assert.match(svg, /(path|circle) class="(q\d|truth|aid)/, name);
    for (const [, answer] of drag.answers(figure, figure.start)) assert.doesNotMatch(answer, /NaN|undefined/, name);
  }
});

for (const [name, points, answer] of [
  ['orientation', [[0, 0], [2, 0], [1, 1]], 'left of the line'],
  ['orientation', [[0, 0], [2, 0], [1, 0]], 'on the line'],
  ['segment_segment', [[0, 0], [2, 0], [1, 0], [3, 0]], 'they meet'],
  ['segment_segment', [[0, 0], [1, 0], [2, 0], [3, 0]], 'disjoint'],
  ['line_line', [[0, 0], [1, 1], [2, 2], [3, 3]], 'the same line'],
  ['ray_segment', [[0, 0], [1, 0], [2, -1], [2, 1]], 'a hit'],
  ['ray_segment', [[0, 0], [-1, 0], [2, -1], [2, 1]], 'no hit'],
  ['point_on_segment', [[1, 0], [1, 2], [1, 1]], 'on it'],
  ['point_in_polygon', [[0, 0], [3, 0], [3, 3], [2, 1], [0, 3], [2, 2]], 'outside'],
  ['point_in_polygon', [[0, 0], [3, 0], [3, 3], [2, 1], [0, 3], [2, 1]], 'on the boundary'],
  ['polygon_convexity', [[0, 0], [2, 0], [3, 1], [2, 2], [0, 2]], 'convex'],
  ['triangulate_polygon', [[1, 0], [3, 0], [4, 1], [3, 2], [1, 2], [0, 1]], 'fab, fbc, fcd, fde'],
  ['interior_angles', [[0, 0], [2, 0], [2, 2], [1, 1], [0, 2]], '90\u00b0 + 90\u00b0 + 45\u00b0 + 270\u00b0 + ' +
   '45\u00b0 = 540\u00b0'],
  ['implicit_circle', [[0, 0], [5, 0], [3, 4]], 'on the boundary'],
  ['sphere_sphere', [[0, 0], [1, 0], [3, 4], [7, 4]], 'touching'],
  ['aabb_aabb', [[0, 0], [1, 1], [1, 1], [2, 2]], 'touching'],
  ['aabb_aabb', [[0, 0], [1, 1], [2, 0], [3, 1]], 'disjoint'],
  ['sphere_aabb', [[0, 0], [1, 1], [4, 5], [9, 5]], 'touching'],
  ['obb_obb', [[0, 0], [2, 0], [4, 0], [6, 0]], 'touching'],
  ['convex_hull_2d', [[0, 0], [3, 0], [3, 3], [0, 2], [1, 1], [2, 1]], 'c d a b'],
  ['all_pairs', [[0, 0], [0.5, 0], [2, 0], [2.5, 0], [9, 9]], 'ab, cd'],
  ['contact_state', [[2, 0], [3, 0]], 'resting'],
  ['elastic_collision', [[2.8, 0], [1.4, 0]], 'v1 = \u22122, v2 = 1 after'],  // 2 and -1 before: momentum 0, energy 3
  ['reflect_plane', [[1, 1.9], [2, 1.9]], 'velocity after: (1, 1)'],
]) {
  test(`drag: ${name} of ${JSON.stringify(points)}`, () => assert.equal(said(name, points), answer));
}

test('drag: a formula that is wrong even in exact arithmetic is shown next to the truth', () => {
  const overlap = [[0, 0], [2, 0], [1, 0], [3, 0]];
  assert.equal(said('segment_segment', overlap, inDouble), 'disjoint');
  assert.equal(said('point_on_segment', [[1, 0], [1, 2], [1, 1]], inDouble), 'not on it');
});

test('drag: the points that it finds break the formula in double, and differ from each other', () => {
  for (const name of ['orientation', 'segment_segment', 'sphere_sphere', 'obb_obb']) {
    const points = drag.breaking(figures[name], 1);
    assert.notEqual(said(name, points, inDouble), said(name, points), name);
    assert.equal(new Set(points.map(String)).size, points.length, name);
  }
  assert.equal(drag.breaking(figures.aabb_aabb, 1), null);  // it compares, and rounds nothing that matters
});
