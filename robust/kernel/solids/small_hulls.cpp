// SPDX-License-Identifier: Apache-2.0
#include "robust/kernel/solids/small_hulls.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <initializer_list>

#include "geometry/validation.h"
#include "robust/kernel/integers/far_apart.h"
#include "robust/kernel/solids/flat_hulls.h"

namespace touchstone::robust::kernel {
namespace {

template <class Integer>
HullInSpace<Integer> hull_of(const Segment3<Integer>& s) {
  return {{s.a, s.b, s.b}, s.a == s.b ? std::size_t{1} : std::size_t{2}};
}
/// Collinear corners span the segment between the least and the greatest of them in lexicographic order.
template <class Integer>
HullInSpace<Integer> hull_of(const Triangle3<Integer>& t) {
  if (!Normal<Integer>(t.b - t.a, t.c - t.a).zero()) return {{t.a, t.b, t.c}, 3};
  const auto before = [](const Point3<Integer>& p, const Point3<Integer>& q) {
    if (p.x != q.x) return p.x < q.x;
    return p.y != q.y ? p.y < q.y : p.z < q.z;
  };
  const auto [least, greatest] = std::minmax({t.a, t.b, t.c}, before);
  return hull_of(Segment3<Integer>{least, greatest});
}

/// The dimension of the intersection of coplanar hulls.
template <class Integer>
int in_plane(const HullInSpace<Integer>& a, const HullInSpace<Integer>& b) {
  const std::array displacements{a.at[1] - a[0], a.at[2] - a[0], b[0] - a[0], b.at[1] - a[0], b.at[2] - a[0]};
  const std::size_t axis = axis_to_look_along<Integer>(displacements);
  return common_dimension(projected_along(axis, a), projected_along(axis, b));
}

/// Decides whether the line from p along d, which crosses the plane of the triangle within its extent, meets the
/// triangle; touching an edge or a corner counts.
template <class Integer>
bool crosses(const Point3<Integer>& p, const Vector3<Integer>& d, const HullInSpace<Integer>& t) {
  const Vector3<Integer> a = t[0] - p, b = t[1] - p, c = t[2] - p;
  const int ab = Normal<Integer>(a, b).along(d), bc = Normal<Integer>(b, c).along(d),
            ca = Normal<Integer>(c, a).along(d);
  const bool left = ab > 0 || bc > 0 || ca > 0, right = ab < 0 || bc < 0 || ca < 0;
  return !(left && right);
}

/// The corner of a triangle that is alone on its side of a plane, or on it. The triangle meets the plane between the
/// points where the edges from `corner` to the others meet it.
template <class Integer>
struct Tip {
  const Point3<Integer>* corner;
  std::array<const Point3<Integer>*, 2> others;
  int side;

  Tip(const HullInSpace<Integer>& t, const std::array<int, 3>& sides) {
    const auto in_front = std::count(sides.begin(), sides.end(), 1),
               behind = std::count(sides.begin(), sides.end(), -1);
    side = in_front == 1 ? 1 : behind == 1 ? -1 : 0;
    const auto at = static_cast<std::size_t>(std::find(sides.begin(), sides.end(), side) - sides.begin());
    corner = &t[at], others = {&t[(at + 1) % 3], &t[(at + 2) % 3]};
  }
};

/// For two triangles with areas whose planes cross in a line: edges from both tips, to p and to q, meet it in P and Q.
/// The sign of the volume (p - tip, other tip - tip, q - tip) is that of Q - P along the line, times one that is the
/// same for all four pairs of edges: the volume does not change when the ends of an edge move along its line, and the
/// side of the first plane on which the second edge ends does not depend on the edge.
template <class Integer>
int of_two_with_areas(const HullInSpace<Integer>& a, const HullInSpace<Integer>& b) {
  const auto sides = [](const HullInSpace<Integer>& t, const HullInSpace<Integer>& other) {
    const Normal<Integer> normal(t[1] - t[0], t[2] - t[0]);
    return std::array{normal.along(other[0] - t[0]), normal.along(other[1] - t[0]), normal.along(other[2] - t[0])};
  };
  const auto alike = [](const std::array<int, 3>& of) { return of[0] == of[1] && of[1] == of[2]; };
  const std::array<int, 3> of_b = sides(a, b);
  if (alike(of_b)) return of_b[0] == 0 ? in_plane(a, b) : -1;
  const std::array<int, 3> of_a = sides(b, a);
  if (alike(of_a)) return -1;
  const Tip<Integer> p(a, of_a), q(b, of_b);
  bool before = false, after = false, together = false;
  for (const Point3<Integer>* const end : p.others) {
    const Normal<Integer> normal(*end - *p.corner, *q.corner - *p.corner);
    for (const Point3<Integer>* const other_end : q.others) {
      const int order = normal.along(*other_end - *p.corner);
      before = before || order < 0, after = after || order > 0, together = together || order == 0;
    }
  }
  if (before && after) return p.side == 0 || q.side == 0 ? 0 : 1;
  return together ? 0 : -1;
}

template <class Integer>
int common_dimension(const HullInSpace<Integer>& a, const HullInSpace<Integer>& b) {
  if (a.count == 3 && b.count == 3) return of_two_with_areas(a, b);
  if (b.count == 3) return common_dimension(b, a);
  const Point3<Integer>&p = b[0], &q = b.at[1];
  const Normal<Integer> normal(a.at[1] - a[0], (a.count == 3 ? a[2] : p) - a[0]);
  const int at_p = normal.along(p - a[0]), at_q = normal.along(q - a[0]);
  if (at_p == 0 && at_q == 0) return in_plane(a, b);
  return a.count == 3 && at_p != at_q && crosses(p, q - p, a) ? 0 : -1;
}

template <class Integer>
int common_dimension(const Ray3<Integer>& ray, const HullInSpace<Integer>& t) {
  const auto& [p, displacement] = ray;
  const Normal<Integer> normal(t.at[1] - t[0], t.count == 3 ? t[2] - t[0] : displacement);
  const int at_origin = normal.along(p - t[0]), rise = normal.along(displacement);
  if (at_origin == 0 && rise == 0) {
    const std::array displacements{displacement, t[0] - p, t.at[1] - p, t.at[2] - p};
    const std::size_t axis = axis_to_look_along<Integer>(displacements);
    const Point2<Integer> ahead = projected_along(axis, p + displacement), from = projected_along(axis, p);
    return common_dimension(Ray2<Integer>{from, ahead - from}, projected_along(axis, t));
  }
  return rise != 0 && at_origin != rise && crosses(p, displacement, t) ? 0 : -1;
}

/// Points by their coordinates, each axis over its own power of two: scaling space along an axis keeps the dimension of
/// an intersection of hulls.
template <class Integer, std::size_t n>
struct Stretched {
  std::array<Integer, n> x, y, z;
  Point3<Integer> at(std::size_t i) const { return {x[i], y[i], z[i]}; }
  Ray3<Integer> ray(std::size_t i) const { return {at(i), {x[i + 1], y[i + 1], z[i + 1]}}; }
  HullInSpace<Integer> segment(std::size_t i) const { return hull_of(Segment3<Integer>{at(i), at(i + 1)}); }
  HullInSpace<Integer> triangle(std::size_t i) const {
    return hull_of(Triangle3<Integer>{at(i), at(i + 1), at(i + 2)});
  }
};

constexpr auto of_triangles = [](const auto& p) { return common_dimension(p.triangle(0), p.triangle(3)); };
constexpr auto of_segment = [](const auto& p) { return common_dimension(p.segment(0), p.triangle(2)); };
constexpr auto of_ray = [](const auto& p) { return common_dimension(p.ray(0), p.triangle(2)); };

/// The greatest exponent field of some numbers.
int top_field(std::initializer_list<double> numbers) {
  int top = 0;
  for (const double x : numbers) top = std::max(top, static_cast<int>(std::bit_cast<std::uint64_t>(x) >> 52 & 0x7ff));
  return top;
}

/// The direction times 2^by, by its bits; unchanged if a number would not be normal.
Vector3d shifted(const Vector3d& direction, int by) {
  Vector3d displacement = direction;
  for (double* const x : {&displacement.x, &displacement.y, &displacement.z}) {
    if (validation::zero(*x)) continue;
    const auto bits = std::bit_cast<std::int64_t>(*x);
    const int field = static_cast<int>(bits >> 52 & 0x7ff);
    if (field == 0 || field + by < 1 || field + by > 0x7fe) return direction;
    *x = std::bit_cast<double>(bits + (static_cast<std::int64_t>(by) << 52));
  }
  return displacement;
}

template <class Dimension, class... Points>
std::optional<int> on_lattice(const Dimension& dimension, const Points&... p) {
  constexpr std::size_t n = sizeof...(p);
  const auto x = lattice_of(p.x...), y = lattice_of(p.y...), z = lattice_of(p.z...);
  if (x && y && z) return dimension(Stretched<std::int64_t, n>{x->at, y->at, z->at});
  const auto near = brought_near<n>({{{p.x...}, {p.y...}, {p.z...}}});
  if (!near) return std::nullopt;
  return dimension(Stretched<std::int64_t, n>{(*near)[0], (*near)[1], (*near)[2]});
}
template <class Dimension, class... Points>
int in_integers(const Dimension& dimension, const Points&... p) {
  return dimension(
      Stretched<mpz_class, sizeof...(p)>{integers_of(p.x...).at, integers_of(p.y...).at, integers_of(p.z...).at});
}

}  // namespace

std::optional<int> common_dimension_on_lattice(const Triangle3d& a, const Triangle3d& b) {
  return on_lattice(of_triangles, a.a, a.b, a.c, b.a, b.b, b.c);
}
std::optional<int> common_dimension_on_lattice(const Segment3d& s, const Triangle3d& t) {
  return on_lattice(of_segment, s.a, s.b, t.a, t.b, t.c);
}
/// A ray does not depend on the length of its direction: scaling it like the points needs the fewest bits.
std::optional<int> common_dimension_on_lattice(const Ray3d& r, const Triangle3d& t) {
  const auto& [o, v] = r;
  const auto& [a, b, c] = t;
  const int top = top_field({o.x, o.y, o.z, a.x, a.y, a.z, b.x, b.y, b.z, c.x, c.y, c.z});
  return on_lattice(of_ray, o, shifted(v, top - top_field({v.x, v.y, v.z})), a, b, c);
}

int common_dimension_in_integers(const Triangle3d& a, const Triangle3d& b) {
  return in_integers(of_triangles, a.a, a.b, a.c, b.a, b.b, b.c);
}
int common_dimension_in_integers(const Segment3d& s, const Triangle3d& t) {
  return in_integers(of_segment, s.a, s.b, t.a, t.b, t.c);
}
int common_dimension_in_integers(const Ray3d& r, const Triangle3d& t) {
  return in_integers(of_ray, r.origin, r.direction, t.a, t.b, t.c);
}

}  // namespace touchstone::robust::kernel
