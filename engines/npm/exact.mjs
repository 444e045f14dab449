// SPDX-License-Identifier: Apache-2.0
// What packages take for granted or leave out by their documentation, decided exactly: every double as an integer, all
// in one unit, the least power of two that they need.

/** [mantissa, exponent] of a double, its value mantissa * 2^exponent. */
function parts(number) {
  const bits = new BigUint64Array(new Float64Array([number]).buffer)[0];
  const exponent = Number((bits >> 52n) & 0x7ffn);
  const mantissa = (bits & 0xfffffffffffffn) | (exponent > 0 ? 1n << 52n : 0n);
  return [bits >> 63n ? -mantissa : mantissa, Math.max(exponent, 1) - 1075];
}

/** The coordinates of points as whole numbers of one unit. */
export function integers(ring) {
  const split = ring.map((point) => point.map(parts));
  const unit = Math.min(...split.flat().map(([mantissa, exponent]) => (mantissa === 0n ? 1024 : exponent)));
  const whole = ([mantissa, exponent]) => (mantissa === 0n ? 0n : mantissa << BigInt(exponent - unit));
  return split.map((point) => point.map(whole));
}

const cross = (o, p, q) => (p[0] - o[0]) * (q[1] - o[1]) - (p[1] - o[1]) * (q[0] - o[0]);
const dot = (o, p, q) => (p[0] - o[0]) * (q[0] - o[0]) + (p[1] - o[1]) * (q[1] - o[1]);
const sign = (n) => (n > 0n ? 1 : n < 0n ? -1 : 0);
const all_below = (p, q, k) => p.every((a) => q.every((b) => a[k] < b[k]));
const apart = (p, q) => [0, 1].some((k) => all_below(p, q, k) || all_below(q, p, k));
const crosses_line = ([a, b], [c, d]) => sign(cross(a, b, c)) * sign(cross(a, b, d)) <= 0;
const meet = (p, q) => !apart(p, q) && crosses_line(p, q) && crosses_line(q, p);

/** Whether a ring has no edge of length zero, and its edges meet in the vertices of neighbours alone. */
export function simple(ring) {
  const p = integers(ring), n = p.length;
  for (let i = 0; i < n; ++i) {
    const a = p[i], b = p[(i + 1) % n], next = p[(i + 2) % n];
    if (a[0] === b[0] && a[1] === b[1]) return false;
    if (cross(b, a, next) === 0n && dot(b, a, next) > 0n) return false;  // it turns back
    for (let j = i + 2; j < n && !(i === 0 && j === n - 1); ++j) {
      if (meet([a, b], [p[j], p[(j + 1) % n]])) return false;
    }
  }
  return true;
}

/** Whether the areas of these triangles, counter-clockwise ones counted as positive, add up to that of the ring. */
export function of_the_same_area(ring, triangles) {
  const p = integers(ring);
  const size = (area) => (area < 0n ? -area : area);
  const whole = p.reduce((area, q, i) => area + cross(p[0], q, p[(i + 1) % p.length]), 0n);
  return size(whole) === triangles.reduce((area, [i, j, k]) => area + cross(p[i], p[j], p[k]), 0n);
}

/** The dimension of the hull of points, by elimination without division. */
export function rank(points) {
  const [first, ...others] = integers(points);
  let rows = others.map((p) => p.map((c, k) => c - first[k])), found = 0;
  for (const column of first.keys()) {
    const pivot = rows.find((row) => row[column] !== 0n);
    if (!pivot) continue;
    const cleared = (row) => row.map((c, k) => c * pivot[column] - pivot[k] * row[column]);
    rows = rows.filter((row) => row !== pivot).map(cleared);
    ++found;
  }
  return found;
}
