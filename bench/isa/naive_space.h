// SPDX-License-Identifier: Apache-2.0
// A unit for each instruction set includes this, with TOUCHSTONE_LANES of its own.
#pragma once

#include "robust/batch/isa/filters.h"
#include "robust/batch/isa/lanes.h"

/// The formulas that one writes for triangles in space, rings and solids if rounding does not matter (naive.h).
namespace touchstone::robust::batch::isa {
namespace {

Lanes operator/(Lanes a, Lanes b) { return Lanes(a.v / b.v); }

struct Arrow {
  Lanes x, y, z;
  explicit Arrow(const Lanes* c) : x(c[0]), y(c[1]), z(c[2]) {}
  Arrow(Lanes x, Lanes y, Lanes z) : x(x), y(y), z(z) {}
  friend Arrow operator-(const Arrow& a, const Arrow& b) { return {a.x - b.x, a.y - b.y, a.z - b.z}; }
  friend Arrow operator*(Lanes t, const Arrow& a) { return {t * a.x, t * a.y, t * a.z}; }
};
Lanes dot(const Arrow& a, const Arrow& b) { return a.x * b.x + a.y * b.y + a.z * b.z; }
Arrow cross(const Arrow& a, const Arrow& b) {
  return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}

/// Moeller and Trumbore's test, with all numbers multiplied by the determinant instead of divided.
struct NaiveCrossing {
  Lanes size, t;
  Mask inside;
  NaiveCrossing(const Arrow& from, const Arrow& way, const Arrow& a, const Arrow& b, const Arrow& c) {
    const Arrow e = b - a, f = c - a, p = cross(way, f), s = from - a, q = cross(s, e);
    const Lanes d = dot(e, p), u = dot(s, p) * d, v = dot(way, q) * d;
    size = d * d, t = dot(f, q) * d;
    const Lanes zero = same(0);
    inside = above(size, zero) & not_below(u, zero) & not_below(v, zero) & not_below(size, u + v) & not_below(t, zero);
  }
};

struct NaiveRayTriangle {
  static constexpr std::size_t columns = 15;
  static constexpr std::uint8_t set = 1, clear = 0;
  static Mask of(const Lanes* n) {
    return NaiveCrossing(Arrow(n), Arrow(n + 3), Arrow(n + 6), Arrow(n + 9), Arrow(n + 12)).inside;
  }
};

struct NaiveSegmentTriangle {
  static constexpr std::size_t columns = 15;
  static constexpr std::uint8_t set = 1, clear = 0;
  static Mask of(const Lanes* n) {
    const Arrow p(n);
    const NaiveCrossing crossing(p, Arrow(n + 3) - p, Arrow(n + 6), Arrow(n + 9), Arrow(n + 12));
    return crossing.inside & not_below(crossing.size, crossing.t);
  }
};

/// By determinants: an edge of one crosses the other if its ends are on different sides of the other's plane and its
/// line has all edges of the other on one side. Reports that coplanar triangles have nothing in common.
struct NaiveTriangles {
  static constexpr std::size_t columns = 18;
  static constexpr std::uint8_t set = 2, clear = 0;

  static Mask alike(Mask i, Mask j, Mask k) { return (i & j & k) | (all_lanes & ~(i | j | k)); }

  static Mask of(const Lanes* n) {
    const Arrow a[] = {Arrow(n), Arrow(n + 3), Arrow(n + 6)}, b[] = {Arrow(n + 9), Arrow(n + 12), Arrow(n + 15)};
    const Arrow of_a[] = {a[1] - a[0], a[2] - a[1], a[0] - a[2]}, of_b[] = {b[1] - b[0], b[2] - b[1], b[0] - b[2]};
    const Arrow normal_a = cross(of_a[0], of_a[1]), normal_b = cross(of_b[0], of_b[1]);
    Mask at_a[3], at_b[3];
    for (std::size_t k = 0; k < 3; ++k) {
      at_a[k] = negative(dot(normal_a, b[k] - a[0]));
      at_b[k] = negative(dot(normal_b, a[k] - b[0]));
    }
    const Mask open = all_lanes & ~(alike(at_a[0], at_a[1], at_a[2]) | alike(at_b[0], at_b[1], at_b[2]));
    if (open == 0) return 0;
    Mask sides[3][3];
    for (std::size_t i = 0; i < 3; ++i)
      for (std::size_t j = 0; j < 3; ++j) sides[i][j] = negative(dot(cross(of_a[i], of_b[j]), b[j] - a[i]));
    Mask crosses = 0;
    for (std::size_t k = 0; k < 3; ++k) {
      const std::size_t next = (k + 1) % 3;
      crosses |= (at_b[k] ^ at_b[next]) & alike(sides[k][0], sides[k][1], sides[k][2]);
      crosses |= (at_a[k] ^ at_a[next]) & alike(sides[0][k], sides[1][k], sides[2][k]);
    }
    return open & crosses;
  }
};

/// The ray test, without a division or a branch.
struct NaiveRing {
  static constexpr std::size_t columns = 2;
  static constexpr std::uint8_t set = 0, clear = 2;
  static Mask of(const Lanes* c, const Shared& ring) {
    const double* const last = ring.numbers + 2 * (ring.count - 1);
    Lanes ax = same(last[0]) - c[0], ay = same(last[1]) - c[1];
    Mask a_higher = above(ay, same(0)), inside = 0;
    for (const double* b = ring.numbers; b != last + 2; b += 2) {
      const Lanes bx = same(b[0]) - c[0], by = same(b[1]) - c[1];
      const Mask b_higher = above(by, same(0));
      inside ^= (a_higher ^ b_higher) & (negative(ax * by - ay * bx) ^ b_higher);
      ax = bx, ay = by, a_higher = b_higher;
    }
    return inside & all_lanes;
  }
};

/// Left of all edges.
struct NaiveConvexRing {
  static constexpr std::size_t columns = 2;
  static constexpr std::uint8_t set = 0, clear = 2;
  static Mask of(const Lanes* c, const Shared& ring) {
    const double* a = ring.numbers + 2 * (ring.count - 1);
    Mask inside = all_lanes;
    for (const double* b = ring.numbers; b != ring.numbers + 2 * ring.count; a = b, b += 2)
      inside &= above(same(b[0] - a[0]) * (c[1] - same(a[1])), same(b[1] - a[1]) * (c[0] - same(a[0])));
    return inside;
  }
};

/// Behind all faces, each given by a corner, the outward normal, and the other corners. Stops once all lanes are
/// outside.
struct NaiveConvexSolid {
  static constexpr std::size_t columns = 3;
  static constexpr std::uint8_t set = 0, clear = 2;
  static Mask behind(const Lanes* c, const double* n) {
    return negative(same(n[3]) * (c[0] - same(n[0])) + same(n[4]) * (c[1] - same(n[1])) +
                    same(n[5]) * (c[2] - same(n[2])));
  }
  static Mask of(const Lanes* c, const Shared& solid) {
    Mask inside = all_lanes;
    for (const double* n = solid.numbers; n != solid.numbers + 12 * solid.count && inside != 0; n += 12)
      inside &= behind(c, n);
    return inside;
  }
};

/// Casts the ray to +x through all faces: it crosses a face that contains the point as seen along x and whose plane
/// lies ahead.
struct NaiveSolid {
  static constexpr std::size_t columns = 3;
  static constexpr std::uint8_t set = 0, clear = 2;
  static Mask of(const Lanes* c, const Shared& solid) {
    Mask inside = 0;
    for (const double* n = solid.numbers; n != solid.numbers + 12 * solid.count; n += 12) {
      const double* const corners[] = {n, n + 6, n + 9};
      Lanes y[3], z[3];
      for (std::size_t k = 0; k < 3; ++k) y[k] = same(corners[k][1]) - c[1], z[k] = same(corners[k][2]) - c[2];
      Mask within = 0, left = 0;
      for (std::size_t k = 0; k < 3; ++k) {
        const std::size_t next = (k + 1) % 3;
        const Mask to_higher = above(z[next], same(0)), crosses = above(z[k], same(0)) ^ to_higher;
        const Mask right = negative(y[k] * z[next] - z[k] * y[next]), counted = crosses & (right ^ to_higher);
        within ^= counted, left |= counted & ~right;
      }
      inside ^= within & ~(left ^ NaiveConvexSolid::behind(c, n));
    }
    return inside & all_lanes;
  }
};

}  // namespace
}  // namespace touchstone::robust::batch::isa
