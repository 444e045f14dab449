// SPDX-License-Identifier: Apache-2.0
#include "oracle/exact/common_dimension_on_grid.h"

#include <algorithm>
#include <array>

namespace touchstone::oracle {
namespace {

using Whole = std::int64_t;
using Vector = Vector3<Whole>;

bool zero(const Vector& v) { return v.x == 0 && v.y == 0 && v.z == 0; }

/// At most N vectors or places, without allocation.
template <std::size_t N>
struct Few {
  std::array<Vector, N> all;
  std::size_t size = 0;

  void add(const Vector& v) { all[size++] = v; }
  const Vector* begin() const { return all.data(); }
  const Vector* end() const { return all.data() + size; }
};
using Corners = Few<3>;
using Differences = Few<9>;

Corners corners_of(const Triangle3<Whole>& t) {
  Corners corners;
  for (const auto& p : {t.a, t.b, t.c}) corners.add({p.x, p.y, p.z});
  return corners;
}

/// How many of the vectors are independent, and a vector across all where that is less than 3.
struct Span {
  int rank = 0;
  Vector first{0, 0, 0}, normal{0, 0, 0};

  void add(const Vector& v) {
    if (rank == 0 && !zero(v)) first = v, rank = 1;
    if (rank == 1 && !zero(cross(first, v))) normal = cross(first, v), rank = 2;
    if (rank == 2 && dot(normal, v) != 0) rank = 3;
  }
  void add_ways(const Corners& corners) {
    for (const Vector& p : corners) add(p - corners.all[0]);
  }
};

/// n . d >= 0 for all, and > 0 for one.
bool pushes(const Vector& n, const Differences& all) {
  bool positive = false;
  for (const Vector& d : all) {
    const Whole along = dot(n, d);
    if (along < 0) return false;
    positive = positive || along > 0;
  }
  return positive;
}

/// The normal of a plane with all of a behind it and all of b in front, and not all within; false if there is none.
bool find_normal(const Corners& a, const Corners& b, Vector& found) {
  Differences all;
  Span span;
  for (const Vector& p : a)
    for (const Vector& q : b) all.add(q - p), span.add(q - p);
  const auto is_one = [&](const Vector& n) { return pushes(n, all) && (found = n, true); };
  const auto either = [&](const Vector& n) { return is_one(n) || is_one(Vector{-n.x, -n.y, -n.z}); };
  for (const Vector* d = all.begin(); d != all.end(); ++d) {
    if (span.rank == 1 && either(*d)) return true;
    if (span.rank == 2 && either(cross(span.normal, *d))) return true;
    for (const Vector* e = d + 1; span.rank == 3 && e != all.end(); ++e)
      if (either(cross(*d, *e))) return true;
  }
  return false;
}

template <class Within>
Corners kept(const Corners& corners, const Within& within) {
  Corners left;
  for (const Vector& p : corners)
    if (within(p)) left.add(p);
  return left;
}

}  // namespace

int common_dimension_on_grid(const Triangle3<Whole>& a, const Triangle3<Whole>& b) {
  Corners of_a = corners_of(a), of_b = corners_of(b);
  for (Vector n; find_normal(of_a, of_b, n);) {
    Whole last = dot(n, of_a.all[0]), first = dot(n, of_b.all[0]);
    for (const Vector& p : of_a) last = std::max(last, dot(n, p));
    for (const Vector& q : of_b) first = std::min(first, dot(n, q));
    if (last < first) return -1;
    const auto within = [&](const Vector& p) { return dot(n, p) == last; };
    of_a = kept(of_a, within), of_b = kept(of_b, within);
  }
  Span on_a, on_b;
  on_a.add_ways(of_a), on_b.add_ways(of_b);
  Span both = on_a;
  both.add_ways(of_b);
  return on_a.rank + on_b.rank - both.rank;
}

}  // namespace touchstone::oracle
