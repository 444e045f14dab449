// SPDX-License-Identifier: Apache-2.0
/* global viewer */
// From coordinates to the steps and pixels of report/scripts/viewer.js and back, by a view that the reader moves, and
// the figures of a drawing as a model for the viewer. What lies in a plane is seen from the front, with z = 0.
import { roundNumbers } from "./doubles.mjs";

const { width, height, room } = viewer.size;
const half = 100000; // steps from the middle to the end of what is seen
const farthest = 1e9; // steps: beyond it figures are cut
const front = { cosYaw: 1, sinYaw: 0, cosPitch: 1, sinPitch: 0 };
const margin = 44; // pixels around what is seen from the front

export const plus = (p, v, times = 1) => p.map((x, i) => x + times * v[i]);
export const minus = (p, q) => p.map((x, i) => x - q[i]);
export const dot = (v, w) => v.reduce((sum, x, i) => sum + x * w[i], 0);
export const size = (v) => Math.hypot(...v);
export const inSpace = (p) => (p.length < 3 ? [...p, 0] : p);

/** span: the length that the viewer's room shows to each side of the centre, twice. */
export class View {
  centre = [0, 0, 0];
  span = 1;
  yaw = 0;
  pitch = 0;
  isFlat = true;

  get turn() {
    if (this.isFlat) return front;
    const { yaw, pitch } = this;
    return { cosYaw: Math.cos(yaw), sinYaw: Math.sin(yaw), cosPitch: Math.cos(pitch), sinPitch: Math.sin(pitch) };
  }
  turnBack() {
    this.yaw = Math.atan2(viewer.firstTurn.sinYaw, viewer.firstTurn.cosYaw);
    this.pitch = Math.atan2(viewer.firstTurn.sinPitch, viewer.firstTurn.cosPitch);
  }
  /** The length of a pixel. */
  get pixel() {
    return this.span / (2 * room);
  }

  /** In steps. Coordinates reach from 5e-324 to 1e308, so it multiplies twice. */
  steps(p) {
    const root = Math.sqrt(this.span);
    return inSpace(p).map((x, i) => {
      const d = x - this.centre[i];
      return Number.isFinite(d)
        ? (d / root / root) * 2 * half
        : ((x / root - this.centre[i] / root) / root) * 2 * half;
    });
  }
  stepsOf(length) {
    const root = Math.sqrt(this.span);
    return (length / root / root) * 2 * half;
  }
  /** The pixel of a point. */
  seen(p) {
    const [x, y, z] = this.steps(p), { cosYaw, sinYaw, cosPitch, sinPitch } = this.turn, scale = room / half;
    const forth = sinYaw * x + cosYaw * z;
    return [width / 2 + scale * (cosYaw * x - sinYaw * z), height / 2 - scale * (cosPitch * y - sinPitch * forth)];
  }
  /** The way in space that so many pixels to the right and down are, across the reader's direction. */
  across(dx, dy) {
    const { cosYaw, sinYaw, cosPitch, sinPitch } = this.turn, [x, y] = [dx * this.pixel, -dy * this.pixel];
    return [x * cosYaw - y * sinPitch * sinYaw, y * cosPitch, -x * sinYaw - y * sinPitch * cosYaw];
  }

  /** Shows all of these points. */
  fit(points) {
    const all = points.map(inSpace).filter((p) => p.every(Number.isFinite));
    if (!all.length) all.push([-1, -1, 0], [1, 1, 0]);
    const low = [0, 1, 2].map((i) => Math.min(...all.map((p) => p[i]))),
      high = [0, 1, 2].map((i) => Math.max(...all.map((p) => p[i])));
    const side = low.map((x, i) => Math.min(high[i] - x, 1e308));
    this.centre = low.map((x, i) => x / 2 + high[i] / 2);
    const wide = this.isFlat
      ? Math.max((side[0] * 2 * room) / (width - 2 * margin), (side[1] * 2 * room) / (height - 2 * margin))
      : Math.hypot(...side.map((x) => x / 4)) * 4;
    this.span = Math.min(wide > 0 ? wide : Math.max(...this.centre.map(Math.abs)) || 1, 1e308);
  }
  /** Nearer (below 1) or farther; a point of the plane may keep its pixel. */
  zoom(times, [x, y] = [width / 2, height / 2]) {
    const before = this.across(x - width / 2, y - height / 2);
    const span = this.span * times;
    if (!(span > 1e-320 && span < 1e308)) return;
    this.span = span;
    if (this.isFlat) this.centre = plus(plus(this.centre, before), this.across(x - width / 2, y - height / 2), -1);
  }
  move(dx, dy) {
    this.centre = plus(this.centre, this.across(-dx, -dy));
  }
}

/** The points of a figure of a drawing, each with its coordinates; those of circles and spheres are their extent. */
export function cornersOf({ kind, numbers }, dimension) {
  const n = numbers.map(Number);
  if (kind === "plane") return [];
  const points = Array.from({ length: Math.floor(n.length / dimension) }, (_, i) =>
    n.slice(dimension * i, dimension * (i + 1)),
  );
  if (kind !== "circle" && kind !== "sphere") return kind === "ray" || kind === "line" ? points.slice(0, 2) : points;
  const centre = n.slice(0, dimension), r = Math.abs(n[dimension]);
  return [centre.map((x) => x - r), centre.map((x) => x + r)];
}

/** Where a plane is nearest to a point: {normal, offset} is all p with normal p + offset = 0. */
export function footOf(normal, offset, near) {
  const long = size(normal);
  return long > 0 ? plus(near, normal, -(dot(normal, near) + offset) / long / long) : near;
}

/** The part of p + t (q - p), from t = from to to, that is near enough to be drawn; nothing if there is none. */
function cut(p, q, from = 0, to = 1) {
  for (const i of [0, 1, 2]) {
    const way = q[i] - p[i];
    if (way === 0 && Math.abs(p[i]) > farthest) return [];
    if (way === 0) continue;
    const [s, t] = [(-farthest - p[i]) / way, (farthest - p[i]) / way];
    from = Math.max(from, Math.min(s, t));
    to = Math.min(to, Math.max(s, t));
  }
  return from <= to ? [from, to].map((t) => plus(p, minus(q, p), t)) : [];
}
const near = (p) => p.map((x) => Math.max(-farthest, Math.min(farthest, x)));
const reaches = { line: [-Infinity, Infinity], ray: [0, Infinity], segment: [0, 1], arrow: [0, 1] };

/** The figures of a drawing for viewer.Strokes. */
export function modelOf(drawing, view) {
  const figures = [];
  const dimension = view.isFlat ? 2 : 3;
  for (const figure of view.isFlat ? drawing.figures : drawing.space) {
    const n = figure.numbers.map(Number), { kind, label = "", whose, faces, node, entered } = figure;
    if (!n.every(Number.isFinite)) continue;
    const common = { kind, label, whose, faces, node, entered };
    if (kind === "plane") {
      const normal = n.slice(0, 3), foot = footOf(normal, n[3], view.centre), long = size(normal);
      if (long > 0)
        figures.push({
          ...common,
          points: [foot, plus(foot, normal, (0.2 * view.span) / long)].map((p) => view.steps(p)),
        });
      continue;
    }
    if (kind === "circle" || kind === "sphere") {
      const radius = view.stepsOf(Math.abs(n[dimension]));
      if (radius < farthest) figures.push({ ...common, points: [near(view.steps(n.slice(0, dimension)))], radius });
      continue;
    }
    const points = cornersOf({ kind, numbers: n }, dimension).map((p) => view.steps(p));
    const reach = reaches[kind];
    if (!reach) figures.push({ ...common, points: points.map(near) });
    else figures.push({ ...common, kind: kind === "arrow" ? kind : "segment", points: cut(...points, ...reach) });
  }
  return {
    title: "",
    figures: figures.filter(({ points }) => points.flat().every(Number.isFinite)),
    spans: [],
    remarks: [],
  };
}

/** The figures as SVG, by the report's viewer. */
export function pictureOf(drawing, view) {
  const strokes = new viewer.Strokes(modelOf(drawing, view));
  strokes.reach = half;
  return viewer.picture(strokes, view.turn);
}

/** Round numbers along the lower and the left side of a plane. */
export function ticksOf(view) {
  if (!view.isFlat) return "";
  const [wide, high] = [(view.pixel * width) / 2, (view.pixel * height) / 2], [x, y] = view.centre;
  const across = roundNumbers(x - wide, x + wide).map((value) => [view.seen([value, y])[0], value]);
  const up = roundNumbers(y - high, y + high).map((value) => [view.seen([x, value])[1], value]);
  const label = (value) => String(value).replace("-", "\u2212");
  return (
    across
      .map(
        ([at, value]) =>
          `<path class="tick" d="M${at.toFixed(1)} ${height}v-5"/><text class="scale" x="${at.toFixed(1)}" ` +
          `y="${height - 8}" text-anchor="middle">${label(value)}</text>`,
      )
      .join("") +
    up
      .map(
        ([at, value]) =>
          `<path class="tick" d="M0 ${at.toFixed(1)}h5"/><text class="scale" x="8" y="${(at + 4).toFixed(1)}" ` +
          `text-anchor="start">${label(value)}</text>`,
      )
      .join("")
  );
}

/** All that a drawing shows, to fit a view to it. */
export const extentOf = (drawing, isFlat) =>
  (isFlat ? drawing.figures : drawing.space).flatMap((figure) => cornersOf(figure, isFlat ? 2 : 3));
