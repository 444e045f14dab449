// SPDX-License-Identifier: Apache-2.0
#include "oracle/exact/solids/common_dimension_on_grid.h"

#include <algorithm>
#include <array>

#include "oracle/exact/numbers/space.h"

namespace touchstone::oracle {
namespace {

using GridNumber = std::int64_t;
using GridVector = Vector3<GridNumber>;

/// At most N vectors or indices, without allocation.
template <std::size_t N>
struct Few {
  std::array<GridVector, N> all;
  std::size_t size = 0;

  void add(const GridVector& v) { all[size++] = v; }
  const GridVector* begin() const { return all.data(); }
  const GridVector* end() const { return all.data() + size; }
};
using GridCorners = Few<3>;
using Differences = Few<9>;

GridCorners corners_of(const Triangle3<GridNumber>& t) {
  GridCorners corners;
  for (const auto& p : {t.a, t.b, t.c}) corners.add({p.x, p.y, p.z});
  return corners;
}

/// The number of independent vectors, and a vector perpendicular to all if that is less than 3.
struct Span {
  int rank = 0;
  GridVector first{0, 0, 0}, normal{0, 0, 0};

  void add(const GridVector& v) {
    if (rank == 0 && !zero(v)) first = v, rank = 1;
    if (rank == 1 && !zero(cross(first, v))) normal = cross(first, v), rank = 2;
    if (rank == 2 && dot(normal, v) != 0) rank = 3;
  }
  void add_displacements(const GridCorners& corners) {
    for (const GridVector& p : corners) add(p - corners.all[0]);
  }
};

/// n . d >= 0 for all, and > 0 for one.
bool pushes(const GridVector& n, const Differences& all) {
  bool positive = false;
  for (const GridVector& d : all) {
    const GridNumber along = dot(n, d);
    if (along < 0) return false;
    positive = positive || along > 0;
  }
  return positive;
}

/// The normal of a plane with all of a behind it and all of b in front, and not all within; returns false if there is
/// none.
bool find_normal(const GridCorners& a, const GridCorners& b, GridVector& found) {
  Differences all;
  Span span;
  for (const GridVector& p : a)
    for (const GridVector& q : b) all.add(q - p), span.add(q - p);
  const auto is_one = [&](const GridVector& n) { return pushes(n, all) && (found = n, true); };
  const auto either = [&](const GridVector& n) { return is_one(n) || is_one(GridVector{-n.x, -n.y, -n.z}); };
  for (const GridVector* d = all.begin(); d != all.end(); ++d) {
    if (span.rank == 1 && either(*d)) return true;
    if (span.rank == 2 && either(cross(span.normal, *d))) return true;
    for (const GridVector* e = d + 1; span.rank == 3 && e != all.end(); ++e)
      if (either(cross(*d, *e))) return true;
  }
  return false;
}

template <class Within>
GridCorners kept(const GridCorners& corners, const Within& within) {
  GridCorners left;
  for (const GridVector& p : corners)
    if (within(p)) left.add(p);
  return left;
}

}  // namespace

int common_dimension_on_grid(const Triangle3<GridNumber>& a, const Triangle3<GridNumber>& b) {
  GridCorners of_a = corners_of(a), of_b = corners_of(b);
  for (GridVector n; find_normal(of_a, of_b, n);) {
    GridNumber last = dot(n, of_a.all[0]), first = dot(n, of_b.all[0]);
    for (const GridVector& p : of_a) last = std::max(last, dot(n, p));
    for (const GridVector& q : of_b) first = std::min(first, dot(n, q));
    if (last < first) return -1;
    const auto within = [&](const GridVector& p) { return dot(n, p) == last; };
    of_a = kept(of_a, within), of_b = kept(of_b, within);
  }
  Span on_a, on_b;
  on_a.add_displacements(of_a), on_b.add_displacements(of_b);
  Span both = on_a;
  both.add_displacements(of_b);
  return on_a.rank + on_b.rank - both.rank;
}

}  // namespace touchstone::oracle
