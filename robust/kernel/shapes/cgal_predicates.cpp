// SPDX-License-Identifier: Apache-2.0
#include "robust/kernel/shapes/cgal_predicates.h"

#include <CGAL/Gmpz.h>
#include <CGAL/Simple_cartesian.h>

#include "robust/kernel/filters/control_word.h"

namespace touchstone::robust::kernel {
namespace {

// A ring is enough for these predicates, and avoids the common divisors of rationals.
using Kernel = CGAL::Simple_cartesian<CGAL::Gmpz>;

CGAL::Gmpz number(const mpz_class& n) { return CGAL::Gmpz(n.get_mpz_t()); }
Kernel::Point_2 cgal(const Point2<mpz_class>& p) { return {number(p.x), number(p.y)}; }
Kernel::Vector_2 cgal(const Vector2<mpz_class>& v) { return {number(v.x), number(v.y)}; }

}  // namespace

int turn(const Point2<mpz_class>& p, const Point2<mpz_class>& q, const Point2<mpz_class>& r) {
  const ControlWord guard;
  return static_cast<int>(CGAL::orientation(cgal(p), cgal(q), cgal(r)));
}

int turn(const Vector2<mpz_class>& v, const Vector2<mpz_class>& w) {
  const ControlWord guard;
  return static_cast<int>(CGAL::orientation(cgal(v), cgal(w)));
}

int side_of_circle(const Circle2<mpz_class>& circle, const Point2<mpz_class>& p) {
  const ControlWord guard;
  const CGAL::Gmpz radius = number(circle.radius);
  const CGAL::Gmpz squared_radius = radius * radius;
  return static_cast<int>(CGAL::compare(squared_radius, CGAL::squared_distance(cgal(circle.center), cgal(p))));
}

int sign_by_cgal(const mpz_class& x) {
  const ControlWord guard;
  return static_cast<int>(CGAL::sign(number(x)));
}

}  // namespace touchstone::robust::kernel
