// SPDX-License-Identifier: Apache-2.0
// Trees over points, as drag.js draws them: of boxes around halves, of cells cut into four, of planes that cut space.
'use strict';
const drag_trees = (() => {
const ring = points => points.map((p, i) => [p, points[(i + 1) % points.length]]);
const corners = sides => [[sides[0][0], sides[1][0]], [sides[0][1], sides[1][1]]];
const middle = points => [0, 1].map(i => points.reduce((sum, p) => sum + p[i], 0) / points.length);
const bounds = (points, room = 0.08) => [0, 1].map(i => points.map(p => p[i])).map(
    v => [Math.min(...v) - room, Math.max(...v) + room]);
function boxes(points, depth = 0) {
  const sides = bounds(points, 0.08 + 0.04 * (2 - depth)), [wide, high] = sides.map(([from, to]) => to - from);
  const axis = wide > high ? 0 : 1;
  const sorted = [...points].sort((p, q) => p[axis] - q[axis]), half = points.length >> 1;
  const below = points.length > 2 ? [sorted.slice(0, half), sorted.slice(half)] : [];
  return [[depth ? 'q2' : 'q1', 'box', ...corners(sides)], ...below.flatMap(part => boxes(part, depth + 1))];
}
function cells(points, sides = [[0, 4], [0, 3]], depth = 0) {
  const [across, up] = sides.map(([low, high]) => (low + high) / 2);
  if (points.length < 2 || depth === 4) return [['q2', 'box', ...corners(sides)]];
  return [[false, false], [true, false], [false, true], [true, true]].flatMap(([right, upper]) => cells(
      points.filter(p => (p[0] >= across) === right && (p[1] >= up) === upper),
      [right ? [across, sides[0][1]] : [sides[0][0], across], upper ? [up, sides[1][1]] : [sides[1][0], up]],
      depth + 1));
}
function planes(points, clip = [[0, 0], [4, 0], [4, 3], [0, 3]]) {
  if (points.length < 2) return [];
  const [a, b] = points, m = middle([a, b]), n = [b[0] - a[0], b[1] - a[1]];
  const height = p => (p[0] - m[0]) * n[0] + (p[1] - m[1]) * n[1];
  const part = keep => ring(clip).flatMap(([p, q]) => {
    const [s, t] = [keep * height(p), keep * height(q)], inside = s >= 0 ? [p] : [];
    return s * t < 0 ? [...inside, p.map((u, i) => u + s / (s - t) * (q[i] - u))] : inside;
  });
  const cut = part(1).filter(p => Math.abs(height(p)) < 1e-9);
  const of = keep => points.filter(p => keep > 0 ? height(p) > 0 : height(p) <= 0);
  if (cut.length < 2 || !of(1).length || !of(-1).length) return [];
  return [['q2', 'segment', cut[0], cut[1]], ...planes(of(1), part(1)), ...planes(of(-1), part(-1))];
}

return {ring, corners, middle, bounds, boxes, cells, planes};
})();
