// SPDX-License-Identifier: Apache-2.0
// What an engine keeps by other numbers (a box by its center, a motion by its end), where these are exact; undefined
// where it cannot hold them. `number` is Math.fround for an engine of single precision.
import { integers } from "./exact.mjs";

const double = (x) => x;
const axes = [0, 1, 2];

/** a + b, if no rounding happens (Knuth: two_sum). */
export function sum(a, b, number = double) {
  const s = a + b, of_b = s - a, lost = (a - (s - of_b)) + (b - of_b);
  return Number.isFinite(s) && lost === 0 && number(s) === s ? s : undefined;
}
const all = (list) => (list.includes(undefined) ? undefined : list);
export const moved = (p, v, number) => all(p.map((c, k) => sum(c, v[k], number)));
export const difference = (v, w, number) => moved(v, w.map((c) => -c), number);

function half(a, number) {
  return a !== undefined && number(a / 2) * 2 === a ? a / 2 : undefined;
}

/** Of an interval. */
export function middle_and_half(min, max, number = double) {
  const found = [half(sum(min, max, number), number), half(sum(max, -min, number), number)];
  return all(found);
}

/** A plane whose normal lies along an axis of coordinates, with a normal of length 1: other normals are rounded. */
export function across_axis({ normal, offset }, number = double) {
  if (normal.filter((c) => c !== 0).length !== 1) return undefined;
  const length = Math.max(...normal.map(Math.abs)), scaled = offset / length;
  if (!Number.isFinite(scaled) || number(scaled) !== scaled) return undefined;
  const [n, d, s, unit] = integers([[length, offset, scaled, 1]])[0];
  return n * s === d * unit ? { normal: normal.map(Math.sign), offset: scaled } : undefined;
}

/** {center, half} of a box by its two corners. */
export function box({ min, max }, number = double) {
  const center = all(min.map((c, k) => half(sum(c, max[k], number), number)));
  const reach = all(min.map((c, k) => half(sum(max[k], -c, number), number)));
  return center && reach && { center, half: reach };
}

/** The same of a box whose half axes lie along the axes of coordinates: no other rotation is exact. */
export function upright({ center, half_axes }) {
  const reach = [0, 0, 0];
  for (const axis of half_axes) {
    const along = axes.filter((k) => axis[k] !== 0);
    if (along.length !== 1 || reach[along[0]] !== 0) return undefined;
    reach[along[0]] = Math.abs(axis[along[0]]);
  }
  return { center, half: reach };
}

const dot = (v, w) => v.reduce((total, c, k) => total + c * w[k], 0n);

/** Two balls of one radius that touch and approach: {between, distance, approach}, from the center of the first to that
 * of the second. Only where the length of the normal is exact, and not where they move across it alone. */
export function hit(velocities, normal, number = double) {
  const greatest = Math.max(...normal.map(Math.abs));
  if (!(greatest > 2 ** -500 && greatest < 2 ** 500)) return undefined;
  const scale = 2 ** -Math.floor(Math.log2(greatest));
  let between = normal.map((c) => c * scale);
  if (between.some((c, k) => c / scale !== normal[k])) return undefined;
  const distance = number(Math.sqrt(between.reduce((total, c) => total + c * c, 0)));
  const [n, [length]] = integers([between, [distance]]);
  if (dot(n, n) !== length * length) return undefined;
  const [[v, w, m]] = [integers([velocities[0], velocities[1], between])];
  const speed = dot(v.map((c, k) => c - w[k]), m);
  if (speed === 0n) return undefined;
  if (speed < 0n) between = between.map((c) => -c);
  const way = between.reduce((total, c, k) => total + c * (velocities[0][k] - velocities[1][k]), 0);
  return { between, distance, approach: way / distance };
}
