// SPDX-License-Identifier: Apache-2.0
// The figures of the deck that are dragged, by the operation that they show: see drag.js.
'use strict';
const drag_figures = (() => {
const {ring, corners, middle, bounds, boxes, cells, planes} = drag_trees;
const letters = n => [...'abcdefghi'].slice(0, n);
const shown = (N, v) => String(+N.value(v).toPrecision(6)).replace('-', '\u2212');
const shownPoint = (N, p) => `(${p.map(v => shown(N, v)).join(', ')})`;
const bySign = (N, v, words) => words[N.sign(v) + 1];
const yes = (said, no = 'no') => said ? 'yes' : no;
const truth = 'truth', said = 'said', aid = 'aid', q1 = 'q1', q2 = 'q2';

// Parameters of the point in which the lines through a, b and c, d cross (p. 12); over 0 where they are parallel.
function crossing(N, [a, b, c, d]) {
  const A = N.minus(b, a), B = N.minus(d, c), W = N.minus(c, a), D = N.cross(A, B);
  return {D, ta: N.div(N.cross(W, B), D), tb: N.div(N.cross(W, A), D), point: t => N.plus(a, t, A)};
}
const onSegment = (N, a, b, p) => N.sign(N.side(a, b, p)) === 0 &&
    [0, 1].every(i => N.within(N.min(a[i], b[i]), p[i], N.max(a[i], b[i])));
// Whether closed segments have a point in common, by sides alone.
function segmentsMeet(N, [a, b, c, d]) {
  const sides = [[a, b, c], [a, b, d], [c, d, a], [c, d, b]].map(three => N.sign(N.side(...three)));
  return sides[0] * sides[1] < 0 && sides[2] * sides[3] < 0 || onSegment(N, a, b, c) || onSegment(N, a, b, d) ||
         onSegment(N, c, d, a) || onSegment(N, c, d, b);
}
// Whether +x from p crosses the edge from a to b, which counts where one end alone is above (p. 15).
const crosses = (N, p, a, b) => N.less(p[1], a[1]) !== N.less(p[1], b[1]) &&
    N.sign(N.side(a, b, p)) * (N.less(a[1], b[1]) ? 1 : -1) > 0;
const inRing = (N, p, points) => ring(points).filter(([a, b]) => crosses(N, p, a, b)).length % 2 === 1;
const square = (N, p, q) => { const d = N.minus(q, p); return N.dot(d, d); };
const inWords = order => ['overlapping', 'touching', 'disjoint'][order + 1];
const box = (N, [a, b]) => [0, 1].map(i => [N.min(a[i], b[i]), N.max(a[i], b[i])]);
const normals = [[1, 0], [1, 1], [0, 1], [-1, 1]];  // of an 8-DOP
const scattered = [[0.5, 0.6], [0.9, 1.2], [1.3, 2.5], [2.2, 2.2], [2.8, 0.7], [3.3, 1.1], [3.5, 2.4]];
const distance = (p, q) => Math.hypot(q[0] - p[0], q[1] - p[1]);

// The ring's corners as triangles, by ears (p. 7); fewer where the ring crosses itself.
function ears(N, points) {
  const area = ring(points).reduce((sum, [a, b]) => N.add(sum, N.cross(a, b)), N.zero);
  const left = N.less(area, N.zero) ? [...points.keys()].reverse() : [...points.keys()], found = [];
  const holds = (three, p) => ring(three.map(i => points[i])).every(([a, b]) => N.sign(N.side(a, b, p)) >= 0);
  const isEar = (...three) => N.sign(N.side(...three.map(i => points[i]))) > 0 &&
      !left.some(m => !three.includes(m) && holds(three, points[m]));
  while (left.length > 2) {
    const at = left.findIndex((k, n) => isEar(left.at(n - 1), k, left[(n + 1) % left.length]));
    if (at < 0) break;
    found.push([left.at(at - 1), left[at], left[(at + 1) % left.length]]);
    left.splice(at, 1);
  }
  return found;
}

// From the highest point on, each time the one that leaves all others on the left (p. 35-42).
function hull(N, points) {
  let now = points.reduce((best, p, i) => N.less(points[best][1], p[1]) ? i : best, 0);
  const found = [];
  do {
    found.push(now);
    let next = (now + 1) % points.length;
    points.forEach((p, i) => {
      const turn = i === now ? 0 : N.sign(N.side(points[now], points[next], p));
      const same = points[next].every((u, k) => N.equal(u, points[now][k]));
      const farther = turn === 0 && N.less(square(N, points[now], points[next]), square(N, points[now], p));
      if (i !== now && (same || turn < 0 || farther)) next = i;
    });
    now = next;
  } while (now !== found[0] && found.length <= points.length);
  return found;
}

// Velocities off a plane through the middle of the frame: the share k of the part along the normal is turned round.
const bounce = k => ({
  measure: true, start: [[0.9, 2.5], [2.4, 1.8]], names: ['from', 'normal'],
  draw: ([from, tip], N) => {
    const n = N.minus(tip, [2, 0.9]), v = N.minus([2, 0.9], from), out = reflected(N, v, n, k);
    return [[aid, 'line', [2, 0.9], [2 - n[1], 0.9 + n[0]]], [q1, 'arrow', from, [2, 0.9]],
            [aid, 'arrow', [2, 0.9], tip], [truth, 'arrow', [2, 0.9], N.plus([2, 0.9], 1, out)]];
  },
  answer: (N, [from, tip]) => {
    const foot = [N.of(2), N.of(0.9)];
    return 'velocity after: ' + shownPoint(N, reflected(N, N.minus(foot, from), N.minus(tip, foot), N.of(k)));
  },
});
const reflected = (N, v, n, k) => {
  const u = N.div(N.dot(v, n), N.dot(n, n));
  return N.plus(v, N.sub(N.zero, N.mul(N.add(N.one, k), u)), n);
};
// Two bodies of masses 1 and 2 along a line: the velocities after, with restitution e.
const collision = e => ({
  measure: true, start: [[1.8, 1.9], [1.5, 1.1]], names: ['v1', 'v2'],
  draw: ([p, q], N) => {
    const [v, w] = after(N, p[0] - 0.8, q[0] - 2.4, e);
    return [[q1, 'circle', [0.8, 1.9], 0.3], [q2, 'circle', [2.4, 1.1], 0.42], [q1, 'arrow', [0.8, 1.9], [p[0], 1.9]],
            [q2, 'arrow', [2.4, 1.1], [q[0], 1.1]], [truth, 'arrow', [0.8, 1.6], [0.8 + v, 1.6]],
            [truth, 'arrow', [2.4, 0.7], [2.4 + w, 0.7]]];
  },
  answer: (N, [p, q]) => {
    const [v, w] = after(N, N.sub(p[0], N.of(0.8)), N.sub(q[0], N.of(2.4)), N.of(e));
    return `v1 = ${shown(N, v)}, v2 = ${shown(N, w)} after`;
  },
});
function after(N, v, w, e) {
  const c = N.div(N.mul(N.add(N.one, e), N.sub(v, w)), N.of(3));
  return [N.sub(v, N.mul(N.of(2), c)), N.add(w, c)];
}

return {
  polygon_convexity: {
    start: [[0.6, 0.5], [3.4, 0.4], [3.5, 2.1], [2.1, 1.3], [0.9, 2.6]], names: letters(5),
    draw: points => [['q0', 'polygon', ...points]],
    answer: (N, points) => {
      const both = ring(points).some(([a, b]) => new Set(points.map(p => N.sign(N.side(a, b, p)))).size > 2 ||
          [1, -1].every(s => points.some(p => N.sign(N.side(a, b, p)) === s)));
      return both ? 'concave' : 'convex';
    },
  },
  interior_angles: {
    measure: true, start: [[0.6, 0.5], [3.4, 0.4], [2.6, 1.4], [2.9, 2.6], [0.9, 2.3]], names: letters(5),
    draw: points => [['q0', 'polygon', ...points]],
    answer: (N, points) => {
      const angles = points.map((p, i) => {
        const e = N.minus(points.at(i - 1), p), f = N.minus(points[(i + 1) % points.length], p);
        const cosine = N.value(N.dot(e, f)) / Math.sqrt(N.value(N.dot(e, e)) * N.value(N.dot(f, f)));
        const angle = Math.acos(Math.max(-1, Math.min(1, cosine))) * 180 / Math.PI;
        return N.sign(N.cross(f, e)) < 0 ? 360 - angle : angle;
      });
      return angles.map(angle => Math.round(angle) + '\u00b0').join(' + ') + ' = ' +
             Math.round(angles.reduce((sum, angle) => sum + angle)) + '\u00b0';
    },
  },
  triangulate_polygon: {
    start: [[0.5, 0.5], [3.5, 0.4], [2.4, 1.3], [3.3, 2.6], [1.7, 2], [0.6, 2.5]], names: letters(6),
    draw: (points, N) => [...ears(N, points).map(three => [q1, 'polygon', ...three.map(i => points[i])]),
                          ['q0', 'polygon', ...points]],
    answer: (N, points) => ears(N, points).map(three => three.map(i => letters(6)[i]).join('')).join(', ') || 'no ear',
  },
  implicit_circle: {
    start: [[1.8, 1.5], [2.9, 1.5], [2.4, 2.4]], names: ['center', 'radius', 'point'],
    draw: ([c, r]) => [[q1, 'circle', c, Math.abs(r[0] - c[0])]],
    answer: (N, [c, r, p]) => {
      const E = N.sub(square(N, c, p), N.mul(N.sub(r[0], c[0]), N.sub(r[0], c[0])));
      return bySign(N, E, ['inside', 'on the boundary', 'outside']);
    },
  },
  line_point_at: {
    measure: true, start: [[0.7, 0.6], [1.8, 1.2]], names: ['P0', 'P0 + V'],
    draw: ([p, q], N) => [['q0', 'line', p, q], ['q0', 'arrow', p, q], [truth, 'point', N.plus(p, 2, N.minus(q, p))],
                          [aid, 'point', N.plus(p, -0.5, N.minus(q, p))]],
    answer: (N, [p, q]) => 'P(2) = ' + shownPoint(N, N.plus(p, N.of(2), N.minus(q, p))),
  },
  point_on_segment: {
    start: [[0.5, 0.5], [3.5, 2], [1.5, 1]], names: ['a', 'b', 'p'],
    draw: ([a, b]) => [['q0', 'segment', a, b]],
    answer: (N, [a, b, p]) => {
      const [tx, ty] = [0, 1].map(i => N.div(N.sub(p[i], a[i]), N.sub(b[i], a[i])));
      return yes(N.equal(tx, ty) && N.within(N.zero, tx, N.one), 'not on it').replace('yes', 'on it');
    },
    truth: (N, [a, b, p]) => onSegment(N, a, b, p) ? 'on it' : 'not on it',
  },
  line_line: {
    start: [[0.5, 0.6], [3.3, 1.4], [0.8, 2.4], [2.8, 0.4]], names: ['a', 'b', 'c', 'd'],
    draw: (points, N) => {
      const {D, ta, point} = crossing(N, points);
      return [['q0', 'line', points[0], points[1]], [q1, 'line', points[2], points[3]],
              ...(D === 0 ? [] : [[truth, 'point', point(ta)]])];
    },
    answer: (N, points) => N.sign(crossing(N, points).D) === 0 ? 'parallel' : 'they cross',
    truth: (N, points) => N.sign(crossing(N, points).D) !== 0 ? 'they cross' :
        N.sign(N.side(points[0], points[1], points[2])) === 0 ? 'the same line' : 'parallel',
  },
  segment_segment: {
    start: [[0.5, 0.6], [3.3, 1.4], [0.8, 2.4], [2.8, 0.4]], names: ['a', 'b', 'c', 'd'],
    draw: (points, N) => {
      const {ta, point} = crossing(N, points), meet = segmentsMeet(drag.exact, points.map(p => p.map(drag.exact.of)));
      return [['q0', 'segment', points[0], points[1]], [q1, 'segment', points[2], points[3]],
              ...(meet && Number.isFinite(ta) ? [[truth, 'point', point(ta)]] : [])];
    },
    answer: (N, points) => {
      const {ta, tb} = crossing(N, points);
      return yes(N.within(N.zero, ta, N.one) && N.within(N.zero, tb, N.one), 'disjoint').replace('yes', 'they meet');
    },
    truth: (N, points) => segmentsMeet(N, points) ? 'they meet' : 'disjoint',
  },
  ray_segment: {
    start: [[0.5, 0.6], [1.5, 1], [2.6, 0.5], [2.8, 2.4]], names: ['origin', 'through', 'a', 'b'],
    draw: (points, N) => {
      const {ta, tb, point} = crossing(N, points);
      return [['q0', 'ray', points[0], points[1]], [q1, 'segment', points[2], points[3]],
              ...(ta >= 0 && N.within(0, tb, 1) ? [[truth, 'point', point(ta)]] : [])];
    },
    answer: (N, points) => {
      const {ta, tb} = crossing(N, points);
      return N.less(ta, N.zero) || !N.equal(ta, ta) || !N.within(N.zero, tb, N.one) ? 'no hit' : 'a hit';
    },
  },
  point_in_polygon: {
    start: [[0.6, 0.5], [3.5, 0.6], [2.2, 1.3], [3.3, 2.5], [0.8, 2.4], [1.4, 1.4]], names: [...letters(5), 'p'],
    draw: points => [[q1, 'polygon', ...points.slice(0, 5)], ['q0', 'ray', points[5], [9, points[5][1]]]],
    answer: (N, points) => {
      const rest = points.slice(0, 5), p = points[5];
      if (ring(rest).some(([a, b]) => onSegment(N, a, b, p))) return 'on the boundary';
      return inRing(N, p, rest) ? 'inside' : 'outside';
    },
  },
  orientation: {
    start: [[0.5, 0.5], [2.6, 1.9], [1.4, 1.1]], names: ['p0', 'p1', 'p'],
    draw: ([a, b]) => [[q1, 'line', a, b], ['q0', 'arrow', a, b]],
    answer: (N, three) => bySign(N, N.side(...three), ['right of the line', 'on the line', 'left of the line']),
  },
  polygon_polygon: {
    start: [[0.5, 0.5], [2.5, 0.8], [1.2, 2.4], [1.9, 1.5], [3.5, 1.1], [3, 2.6]], names: letters(6),
    draw: points => [['q0', 'polygon', ...points.slice(0, 3)], [q1, 'polygon', ...points.slice(3)]],
    answer: (N, points) => {
      const [a, b] = [points.slice(0, 3), points.slice(3)];
      const meet = a.some(p => inRing(N, p, b)) || b.some(p => inRing(N, p, a)) ||
          ring(a).some(one => ring(b).some(other => segmentsMeet(N, [...one, ...other])));
      return meet ? 'they meet' : 'disjoint';
    },
  },
  point_ground_plane: {
    start: [[2, 1.6]], names: ['p'],
    draw: () => [[q1, 'line', [0, 1], [1, 1]]],
    answer: (N, [p]) => bySign(N, N.sub(p[1], N.one), ['below', 'on the ground', 'above']) + ' (here y = 1)',
  },
  point_plane: {
    start: [[1.2, 1], [1.8, 2], [3, 1.4]], names: ['of the plane', 'normal', 'p'],
    draw: ([a, tip], N) => [[q1, 'line', a, [a[0] - (tip[1] - a[1]), a[1] + tip[0] - a[0]]], [q1, 'arrow', a, tip]],
    answer: (N, [a, tip, p]) => bySign(N, N.dot(N.minus(tip, a), N.minus(p, a)), ['behind', 'on it', 'in front']),
  },
  point_plane_toi: {
    measure: true, start: [[0.8, 2.6], [3, 0.4]], names: ['start', 'end'],
    draw: ([a, b], N) => [[q1, 'line', [0, 1], [1, 1]], ['q0', 'arrow', a, b],
        ...(a[1] > 1 && b[1] <= 1 ? [[truth, 'point', N.plus(a, (a[1] - 1) / (a[1] - b[1]), N.minus(b, a))]] : [])],
    answer: (N, [a, b]) => {
      const E0 = N.sub(a[1], N.one), E1 = N.sub(b[1], N.one), t = N.div(E0, N.sub(E0, E1));
      if (N.less(E0, N.zero)) return 'behind from the start';
      return N.within(N.zero, t, N.one) ? `hit at t = ${shown(N, t)}` : 'never';
    },
  },
  obb_obb: {
    start: [[1, 1], [1.5, 1.3], [2.6, 1.7], [3, 2.2]], names: ['center a', 'axis a', 'center b', 'axis b'],
    draw: (points, N) => [0, 2].map(i => {
      const [c, u, v] = axesOf(N, points[i], points[i + 1]);
      const at = (s, t) => N.plus(N.plus(c, s, u), t, v);
      return [i ? q1 : 'q0', 'polygon', at(1, 1), at(-1, 1), at(-1, -1), at(1, -1)];
    }),
    answer: (N, points) => {
      const [c, ...own] = axesOf(N, points[0], points[1]), [d, ...other] = axesOf(N, points[2], points[3]);
      const size = x => N.max(x, N.sub(N.zero, x)), half = [...own, ...other], way = N.minus(d, c);
      const orders = half.map(n => N.sign(N.sub(size(N.dot(way, n)),
          half.reduce((sum, h) => N.add(sum, size(N.dot(n, h))), N.zero))));
      return inWords(Math.max(...orders));
    },
  },
  aabb_of_points: {
    measure: true, start: [[0.8, 1.2], [1.6, 2.3], [2.9, 1.9], [3.3, 0.7], [2, 1.1]], names: letters(5),
    draw: points => [[truth, 'box', ...corners(bounds(points, 0))]],
    answer: (N, points) => 'from ' + [N.min, N.max].map(f => shownPoint(N, points.reduce((p, q) => [0, 1].map(i =>
        f(p[i], q[i]))))).join(' to '),
  },
  bounding_sphere: {
    measure: true, start: [[0.9, 1.2], [1.6, 2.2], [2.9, 1.9], [3, 0.9], [2, 1.1]], names: letters(5),
    draw: points => [[q1, (() => middle(corners(bounds(points, 0))))()], [q2, middle(points)]].map(([style, c]) =>
        [style, 'circle', c, Math.max(...points.map(p => distance(c, p)))]),
    answer: (N, points) => {
      const low = points.reduce((p, q) => [0, 1].map(i => N.min(p[i], q[i]))), high = points.reduce((p, q) =>
          [0, 1].map(i => N.max(p[i], q[i]))), half = N.div(N.one, N.of(2));
      const mean = points.reduce((p, q) => [0, 1].map(i => N.add(p[i], q[i]))).map(u => N.div(u, N.of(points.length)));
      const radius = c => Math.sqrt(N.value(points.map(p => square(N, c, p)).reduce((a, b) => N.max(a, b)))).toFixed(4);
      return `around the box's middle: radius ${radius(N.plus(low, half, N.minus(high, low)))}, ` +
             `around the mean: ${radius(mean)}`;
    },
  },
  convex_hull_2d: {
    start: [[0.6, 0.8], [1.7, 1.6], [3.4, 0.6], [3, 2.5], [1.9, 2.2], [0.9, 2.4]], names: letters(6),
    draw: (points, N) => [[truth, 'polygon', ...hull(N, points).map(i => points[i])]],
    answer: (N, points) => hull(N, points).map(i => letters(6)[i]).join(' '),
  },
  kdop_of_points: {
    measure: true, start: [[0.9, 1.2], [1.6, 2.2], [2.9, 1.9], [3, 0.9], [2, 1.1]], names: letters(5),
    draw: points => {
      const ways = [...normals, ...normals.map(n => n.map(u => -u))];
      const reach = ways.map(n => Math.max(...points.map(p => n[0] * p[0] + n[1] * p[1])));
      return [[truth, 'polygon', ...ways.map((n, k) => {
        const m = ways[(k + 1) % 8], [d, e] = [reach[k], reach[(k + 1) % 8]], D = n[0] * m[1] - n[1] * m[0];
        return [(d * m[1] - e * n[1]) / D, (n[0] * e - m[0] * d) / D];
      })]];
    },
    answer: (N, points) => normals.map(n => {
      const all = points.map(p => N.dot(n.map(N.of), p));
      return `[${shown(N, all.reduce((a, b) => N.min(a, b)))}, ${shown(N, all.reduce((a, b) => N.max(a, b)))}]`;
    }).join(' '),
  },
  sphere_sphere: {
    start: [[1.2, 1.2], [1.8, 1.2], [2.6, 1.8], [3.2, 1.8]], names: ['a', 'radius', 'b', 'radius'],
    draw: ([a, r, b, s]) => [['q0', 'circle', a, Math.abs(r[0] - a[0])], [q1, 'circle', b, Math.abs(s[0] - b[0])]],
    answer: (N, [a, r, b, s]) => {
      const sum = N.add(...[[r, a], [s, b]].map(([u, c]) => N.max(N.sub(u[0], c[0]), N.sub(c[0], u[0]))));
      return inWords(N.sign(N.sub(square(N, a, b), N.mul(sum, sum))));
    },
  },
  aabb_aabb: {
    start: [[0.6, 0.6], [2, 1.8], [1.7, 1.4], [3.4, 2.5]], names: ['a', 'a', 'b', 'b'],
    draw: ([a, b, c, d]) => [['q0', 'box', a, b], [q1, 'box', c, d]],
    answer: (N, [a, b, c, d]) => {
      const [one, other] = [box(N, [a, b]), box(N, [c, d])];
      const gap = i => N.max(N.sub(one[i][0], other[i][1]), N.sub(other[i][0], one[i][1]));
      return inWords(Math.max(N.sign(gap(0)), N.sign(gap(1))));
    },
  },
  sphere_aabb: {
    start: [[0.7, 0.6], [2.1, 1.6], [2.6, 2.2], [3.3, 2.2]], names: ['box', 'box', 'center', 'radius'],
    draw: ([a, b, c, r], N) => {
      const near = box(N, [a, b]).map(([low, high], i) => Math.min(high, Math.max(low, c[i])));
      return [[q1, 'box', a, b], ['q0', 'circle', c, Math.abs(r[0] - c[0])], [aid, 'segment', c, near],
              [truth, 'point', near]];
    },
    answer: (N, [a, b, c, r]) => {
      const near = box(N, [a, b]).map(([low, high], i) => N.min(high, N.max(low, c[i]))), reach = N.sub(r[0], c[0]);
      return inWords(N.sign(N.sub(square(N, c, near), N.mul(reach, reach))));
    },
  },
  swept_sphere_sphere: {
    measure: true, start: [[0.7, 0.8], [3.2, 1.6], [2.8, 2]], names: ['start', 'end', 'at rest'],
    draw: ([a, b, c], N) => {
      const t = firstTime(N, a, b, c);
      return [['q0', 'circle', a, 0.4], ['q0', 'arrow', a, b], [q1, 'circle', c, 0.4],
              ...(t >= 0 && t <= 1 ? [[truth, 'circle', N.plus(a, t, N.minus(b, a)), 0.4]] : [])];
    },
    answer: (N, [a, b, c]) => {
      const t = firstTime(drag.double, ...[a, b, c].map(p => p.map(N.value)));
      return t >= 0 && t <= 1 ? `first at t = ${t.toFixed(4)}` : 'never';
    },
  },
  all_pairs: {
    start: [[0.8, 0.8], [1.4, 1.2], [2.7, 1], [3.3, 2.2], [1.5, 2.4]], names: letters(5),
    draw: (points, N) => [...points.map(p => [q1, 'circle', p, 0.4]), ...pairs(N, points).map(([i, j]) =>
        [truth, 'segment', points[i], points[j]])],
    answer: (N, points) => pairs(N, points).map(([i, j]) => letters(5)[i] + letters(5)[j]).join(', ') || 'no pairs',
  },
  bounding_volume_hierarchy: {
    measure: true, start: scattered, names: letters(7),
    draw: points => boxes(points), answer: () => 'boxes around halves of the points, and around their halves',
  },
  quadtree: {
    measure: true, start: scattered, names: letters(7),
    draw: points => cells(points), answer: (N, points) => `${cells(points.map(p => p.map(N.value))).length} cells`,
  },
  bsp_tree: {
    measure: true, start: scattered, names: letters(7),
    draw: points => planes(points), answer: (N, points) => `${planes(points.map(p => p.map(N.value))).length} planes`,
  },
  momentum: {
    measure: true, start: [[1.6, 1], [2.4, 2.2]], names: ['m1 v1', '+ m2 v2'],
    draw: ([a, b]) => [['q0', 'arrow', [0.5, 0.5], a], [q1, 'arrow', a, b], [truth, 'arrow', [0.5, 0.5], b]],
    answer: (N, [a, b]) => 'p = ' + shownPoint(N, N.plus(N.minus(a, [N.of(0.5), N.of(0.5)]), N.one, N.minus(b, a))),
  },
  reflect_wall: {
    measure: true, start: [[0.9, 2.4]], names: ['from'],
    draw: ([from]) => [[aid, 'line', [2, 0.9], [3, 0.9]], [q1, 'arrow', from, [2, 0.9]],
                       [truth, 'arrow', [2, 0.9], [4 - from[0], from[1]]]],
    answer: (N, [from]) => 'velocity after: ' + shownPoint(N, [N.sub(N.of(2), from[0]), N.sub(from[1], N.of(0.9))]),
  },
  reflect_plane: bounce(1),
  damped_reflection: bounce(0.8),
  elastic_collision: collision(1),
  restitution_collision: collision(0.5),
  penalty_force: {
    measure: true, start: [[1.6, 0.7], [2.2, 0.3]], names: ['p', 'p + v'],
    draw: ([p, q]) => [[q1, 'line', [0, 1.5], [1, 1.5]], ['q0', 'arrow', p, q],
        ...(p[1] < 1.5 ? [[truth, 'arrow', p, [p[0], p[1] + 2 * (1.5 - p[1]) - (q[1] - p[1])]]] : [])],
    answer: (N, [p, q]) => {
      const E = N.sub(p[1], N.of(1.5)), f = N.sub(N.zero, N.add(N.mul(N.of(2), E), N.sub(q[1], p[1])));
      return `force ${N.less(E, N.zero) ? shown(N, f) : 0} upwards (k = 2, c = 1)`;
    },
  },
  contact_state: {
    start: [[1.9, 2.1], [2.7, 1.1]], names: ['va', 'vb'],
    draw: ([a, b]) => [['q0', 'circle', [1.5, 1.5], 0.5], [q1, 'circle', [2.5, 1.5], 0.5],
                       [aid, 'arrow', [2, 1.5], [1.6, 1.5]], ['q0', 'arrow', [1.5, 1.5], a],
                       [q1, 'arrow', [2.5, 1.5], b]],
    answer: (N, [a, b]) => bySign(N, N.sub(N.sub(b[0], a[0]), N.one), ['colliding', 'resting', 'separating']),
  },
};

function axesOf(N, c, tip) {
  const u = N.minus(tip, c), half = N.div(N.one, N.of(2));
  return [c, u, [N.mul(half, N.sub(N.zero, u[1])), N.mul(half, u[0])]];
}
function firstTime(N, a, b, c) {
  const p = N.minus(a, c), v = N.minus(b, a), A = N.dot(v, v), B = 2 * N.dot(p, v), C = N.dot(p, p) - 0.64;
  return C <= 0 ? 0 : (-B - Math.sqrt(B * B - 4 * A * C)) / (2 * A);
}
function pairs(N, points) {
  return points.flatMap((p, i) => points.slice(i + 1).map((q, k) => [i, i + 1 + k, p, q])).filter(([,, p, q]) =>
      !N.less(N.mul(N.of(0.8), N.of(0.8)), square(N, p, q)));
}
})();

drawnAlone('drag', drag.show);
