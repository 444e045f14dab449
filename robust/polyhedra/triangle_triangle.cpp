// SPDX-License-Identifier: Apache-2.0
#include "robust/polyhedra/triangle_triangle.h"

#include <array>
#include <utility>

#include "geometry/validation.h"
#include "robust/kernel/shapes/valid.h"
#include "robust/kernel/solids/small_hulls.h"

namespace touchstone::robust {
namespace {

using filters::Sign;
using Plane = filters::FacePlane<double>;
using Sides = std::array<Sign, 3>;

Sides sides_of(const Plane& plane, const Triangle3d& t) { return {plane.side(t.a), plane.side(t.b), plane.side(t.c)}; }
bool known(const Sides& sides) {
  return sides[0] != Sign::unknown && sides[1] != Sign::unknown && sides[2] != Sign::unknown;
}
bool one_side(const Sides& sides) { return sides[0] == sides[1] && sides[1] == sides[2]; }

/// The corner that is alone on its side of the other's plane, then the other two in the order in which `corner` and
/// they are counter-clockwise as seen from the side of the other triangle's lone corner.
struct Tip {
  const Point3d *corner, *second, *third;

  Tip(const Triangle3d& t, const Sides& sides) {
    if (sides[1] == sides[2]) corner = &t.a, second = &t.b, third = &t.c;
    else if (sides[0] == sides[2]) corner = &t.b, second = &t.c, third = &t.a;
    else corner = &t.c, second = &t.a, third = &t.b;
  }
  void turn() { std::swap(second, third); }
};

Sign lone_side(const Sides& sides) {
  return sides[1] == sides[2] ? sides[0] : sides[0] == sides[2] ? sides[1] : sides[2];
}

void validate_triangle_triangle(const Triangle3d& a, const Triangle3d& b) {
  using kernel::valid;
  if (valid(a.a) && valid(a.b) && valid(a.c) && valid(b.a) && valid(b.b) && valid(b.c)) return;
  validation::validate_numbers("a", a), validation::validate_numbers("b", b);
}

}  // namespace

Perhaps<TriangleTriangleRelation> stages::triangle_triangle::filter(const Triangle3d& a, const Triangle3d& b) {
  const Sides of_b = sides_of(Plane(a.a, a.b, a.c), b);
  if (known(of_b) && one_side(of_b)) return TriangleTriangleRelation::none;
  const Sides of_a = sides_of(Plane(b.a, b.b, b.c), a);
  if (!known(of_a)) return std::nullopt;
  if (one_side(of_a)) return TriangleTriangleRelation::none;
  if (!known(of_b)) return std::nullopt;
  // Guigue and Devillers: the edges from p to its second and from q to its second cross the line of both planes, and so
  // do those to the third. The side of q's second from p, p's second and q is the order of the first two along that
  // line; that of q from p, p's third and q's third the order of the others.
  Tip p(a, of_a), q(b, of_b);
  if (lone_side(of_a) == Sign::negative) q.turn();
  if (lone_side(of_b) == Sign::negative) p.turn();
  const Sign first = Plane(*p.corner, *p.second, *q.corner).side(*q.second),
             last = Plane(*p.corner, *p.third, *q.third).side(*q.corner);
  if (first == Sign::positive || last == Sign::positive) return TriangleTriangleRelation::none;
  if (first == Sign::unknown || last == Sign::unknown) return std::nullopt;
  return TriangleTriangleRelation::segment;
}

Perhaps<TriangleTriangleRelation> stages::triangle_triangle::lattice(const Triangle3d& a, const Triangle3d& b) {
  const auto dimension = kernel::common_dimension_on_lattice(a, b);
  if (!dimension) return std::nullopt;
  return static_cast<TriangleTriangleRelation>(1 + *dimension);
}

TriangleTriangleRelation stages::triangle_triangle::exact(const Triangle3d& a, const Triangle3d& b) {
  return static_cast<TriangleTriangleRelation>(1 + kernel::common_dimension_in_integers(a, b));
}

Decided<TriangleTriangleRelation> stages::triangle_triangle::past_filter(const Triangle3d& a, const Triangle3d& b) {
  return in_turn<triangle_triangle, validate_triangle_triangle, Stage::lattice, Stage::exact>(a, b);
}

}  // namespace touchstone::robust
