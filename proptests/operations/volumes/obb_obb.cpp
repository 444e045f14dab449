// SPDX-License-Identifier: Apache-2.0
#include "catalogue/rows/volumes/obb_obb.h"

#include "proptests/box_laws.h"
#include "proptests/laws.h"
#include "robust/volumes/aabb_aabb.h"
#include "robust/volumes/obb_obb.h"
#include "robust/volumes/point_in_obb.h"

namespace touchstone::proptests::obb_obb_tests {
namespace {

using Row = rows::obb_obb;

constexpr Contact disjoint = Contact::disjoint, touching = Contact::touching, overlapping = Contact::overlapping;
constexpr Obb3d cube{{0, 0, 0}, {{2, 0, 0}, {0, 2, 0}, {0, 0, 2}}};

/// Turned by the triple 3, 4, 5 about the z axis.
Obb3d turned(const Point3d& center) { return {center, {{3, 4, 0}, {-4, 3, 0}, {0, 0, 1}}}; }
Obb3d shifted_cube(double x, double y, double z) { return {{x, y, z}, cube.half_axes}; }

constexpr Worked<Row> worked;

Vector3<Rational> rational(const Vector3d& v) { return {exact(v.x), exact(v.y), exact(v.z)}; }
bool orthogonal(const HalfAxes<double>& h) {
  const auto u = rational(h.u), v = rational(h.v), w = rational(h.w);
  return dot(u, v) == 0 && dot(v, w) == 0 && dot(w, u) == 0;
}
Vector3<Rational> size(const Vector3<Rational>& v) { return {abs(v.x), abs(v.y), abs(v.z)}; }
Rational sum(const Vector3<Rational>& v) { return Rational(v.x + v.y + v.z); }

/// The slide's comparison on an axis that is the cross product of two vectors, or (no second one) the first.
struct Gap {
  Rational gap, bound;
  bool overflow = false;

  Gap(const Vector3d& displacement, const Vector3<Rational>& d, const std::vector<Vector3d>& edges, const Vector3d& v,
      const Vector3d* w) {
    const Vector3d n = w != nullptr ? cross(v, *w) : v;
    const Vector3<Rational> s = size(rational(v)), t = w != nullptr ? size(rational(*w)) : s;
    const Vector3<Rational> axis = w != nullptr ? cross(rational(v), rational(*w)) : rational(v),
                            terms = w == nullptr ? s
                                                 : Vector3<Rational>{Rational(s.y * t.z + s.z * t.y),
                                                                     Rational(s.z * t.x + s.x * t.z),
                                                                     Rational(s.x * t.y + s.y * t.x)};
    const Rational u = unit();
    gap = abs(dot(axis, d));
    Rational products = dot(terms, size(d)), sizes = sum(size(d));
    double computed = std::fabs(dot(n, displacement));
    for (const Vector3d& edge : edges) {
      gap -= abs(dot(axis, rational(edge)));
      products += dot(terms, size(rational(edge))), sizes += sum(size(rational(edge)));
      computed += std::fabs(dot(n, edge));
    }
    overflow = !finite(computed);
    bound = (11 + 56 * u) * u * products + power_of_two(-1072) * (sizes + 11);
  }
  bool certain() const { return !overflow && abs(gap) > bound; }
};

}  // namespace

LAW("obb_obb: half axes may be exchanged and reversed", a, b) {
  const Contact contact = ask(asked);
  return ask(in_another_order<0>(asked)) == contact && ask(in_another_order<1>(asked)) == contact;
}

LAW("obb_obb: a box overlaps itself and every box around its center", a, b) {
  return ask(Row::Question{a, a}) == overlapping && ask(Row::Question{a, {a.center, b.half_axes}}) == overlapping;
}

LAW("obb_obb: boxes touch where one stands an edge's length beside itself, and part an ulp of one axis farther", a) {
  if (!on_lattice(asked)) return true;
  const auto beside = [&](double r, double s, double t) {
    return ask(Row::Question{a, {catalogue::halves_along(a, r, s, t), a.half_axes}});
  };
  return beside(4, 0, 0) == touching && beside(-4, 4, 0) == touching && beside(4, 4, -4) == touching &&
         beside(2, -2, 2) == overlapping && beside(0, 6, 0) == disjoint;
}

ROBUST_LAW("obb_obb: a corner of one box in the other means that they meet", a, b) {
  if (!on_lattice(asked)) return true;
  const Contact contact = ask(asked);
  for (const Point3d& corner : corners(b)) {
    const Location location = robust::point_in_obb(a, corner);
    if (contact < (location == Location::inside ? overlapping : location == Location::boundary ? touching : disjoint))
      return false;
  }
  return true;
}

ROBUST_LAW("obb_obb: boxes along the axes have the contact of aabb_aabb", a, b) {
  const auto of_a = straightened(a), of_b = straightened(b);
  if (!on_lattice(asked) || !of_a || !of_b) return true;
  return robust::aabb_aabb(of_a->aabb, of_b->aabb) == ask(Row::Question{of_a->obb, of_b->obb});
}

TEST_CASE("obb_obb: p. 27's boxes worked by hand") {
  // A corner of the turned box at its center - (7, 0) + (0, 1) = center + (-7, 1); it reaches 7 along x and y.
  worked({cube, turned({9, 0.5, 0})}, touching, 0);
  worked({cube, turned({10, 0.5, 0})}, disjoint, 1);
  worked({cube, turned({8.5, 0.5, 0})}, overlapping, Rational(1, 4), "algorithm");  // parallel edges, as below
  worked({cube, turned({0, 0, 3})}, touching, 0);
  worked({cube, turned({0, 0, 4})}, disjoint, 1);
  // On 3 x + 4 y: 14 of the cube, 25 of the turned box; |3 * 6 + 4 * 6| = 42 is 3 more.
  worked({cube, turned({6, 6, 0})}, disjoint, Rational(9, 25));
  // Edges that cross: (0, 1, 1) x (1, 0, 0) and such; boxes turned by 45 degrees about x and about y.
  const Obb3d ridge{{0, 0, 0}, {{4, 0, 0}, {0, 1, 1}, {0, -1, 1}}};
  const auto other = [](double z) { return Obb3d{{0, 0, z}, {{1, 0, 1}, {0, 4, 0}, {-1, 0, 1}}}; };
  worked({ridge, other(4)}, touching, 0);
  worked({ridge, other(5)}, disjoint, 1);
  worked({ridge, other(3)}, overlapping, 1);
}

TEST_CASE("obb_obb: parallel edges make an axis that is zero, on which the textbook test sees a touch") {
  worked({cube, shifted_cube(1, 0, 0)}, overlapping, 9, "algorithm");  // 4 - 1
  worked({cube, cube}, overlapping, 16, "algorithm");
  worked({cube, shifted_cube(4, 1, 0)}, touching, 0);
  worked({cube, shifted_cube(4, 4, 4)}, touching, 0);
  worked({cube, shifted_cube(4, 6, -9)}, disjoint, 25);            // 9 - 4
  worked({cube, turned({1, 0, 0})}, overlapping, 9, "algorithm");  // z: 3
}

TEST_CASE("obb_obb: where half axes are not at right angles the textbook test takes other axes than the faces'") {
  // x - y between -2 and 2, y between -2 and 2, z between -1 and 1.
  const Obb3d sheared{{0, 0, 0}, {{2, 0, 0}, {2, 2, 0}, {0, 0, 1}}};
  // Along (1, -1, 0) the other reaches 1 + 1 + 4. Its first corner there is its center - (3, -3, -3), over a side.
  const auto other = [](double x) { return Obb3d{{x, -x, -3}, {{1, 2, 2}, {2, 1, -2}, {2, -2, 1}}}; };
  worked({sheared, other(4)}, touching, 0, "algorithm");                  // 8; 2 + 6
  worked({sheared, other(4.25)}, disjoint, Rational(1, 8), "algorithm");  // 8.5; the normal's square is 2
  worked({sheared, other(3.5)}, overlapping, Rational(1, 2));             // 7
  // Here an edge of a and one of b make the normal of a's side.
  worked({sheared, {{4, 0, 0}, {{1, 0, 0}, {0, 1, 0}, {0, 0, 2}}}}, touching, 0);  // 4; 2 + 2
}

TEST_CASE("obb_obb: rounding, huge, subnormal and negative zero") {
  const Rational t = exact(tiny);
  const auto least = [](double x) { return Obb3d{{x, 0, 0}, {{tiny, 0, 0}, {0, tiny, 0}, {0, 0, tiny}}}; };
  worked({least(0), least(2 * tiny)}, touching, 0);
  worked({least(0), least(3 * tiny)}, disjoint, Rational(t * t), "rounding");
  worked({least(0), least(tiny)}, overlapping, Rational(t * t), "algorithm");
  const auto large = [](double x) { return Obb3d{{x, 0, 0}, {{huge, 0, 0}, {0, huge, 0}, {0, 0, 1}}}; };
  worked({large(-huge), large(huge)}, touching, 0);
  worked({large(-huge), {{huge, 0, 0}, {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}}}, disjoint,
         Rational((exact(huge) - 1) * (exact(huge) - 1)));
  worked(
      {{{-0.0, 0, 0}, {{1, -0.0, 0}, {0, -1, -0.0}, {0, 0, 1}}}, {{-2, -0.0, 0}, {{1, 0, 0}, {0, 1, 0}, {0, 0, -1}}}},
      touching, 0);
}

TEST_CASE("obb_obb: half axes in one plane are refused") {
  const Obb3d flat{{0, 0, 0}, {{1, 1, 0}, {0, 1, 1}, {1, 2, 1}}};
  refused<Row>({flat, flat}, "a.half_axes", "linearly independent");
}

CONTRACT("obb_obb: the formula in double is that in exact arithmetic where the bound of its contract says so", a, b) {
  const std::vector<Vector3d> edges{a.half_axes.u, a.half_axes.v, a.half_axes.w,
                                    b.half_axes.u, b.half_axes.v, b.half_axes.w};
  const Point3d &p = a.center, &q = b.center;
  const Vector3<Rational> d{Rational(exact(q.x) - exact(p.x)), Rational(exact(q.y) - exact(p.y)),
                            Rational(exact(q.z) - exact(p.z))};
  std::vector<Gap> gaps;
  for (const Vector3d& edge : edges) gaps.emplace_back(q - p, d, edges, edge, nullptr);
  for (std::size_t i = 0; i < 3; ++i)
    for (std::size_t j = 3; j < 6; ++j) gaps.emplace_back(q - p, d, edges, edges[i], &edges[j]);
  bool separated = false;
  for (const Gap& each : gaps) {
    if (!each.certain()) return true;
    separated = separated || each.gap > 0;
  }
  if (answer != (separated ? disjoint : overlapping)) return false;
  return answer == truth.answer || !(orthogonal(a.half_axes) && orthogonal(b.half_axes));
}

}  // namespace touchstone::proptests::obb_obb_tests
