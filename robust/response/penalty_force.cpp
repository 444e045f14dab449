// SPDX-License-Identifier: Apache-2.0
#include "robust/response/penalty_force.h"

#include <cstdint>

#include "robust/kernel/contacts/along_normal.h"
#include "robust/kernel/integers/dyadic.h"
#include "robust/kernel/integers/plane_terms.h"
#include "robust/kernel/shapes/valid.h"

namespace touchstone::robust {

/// t N with t = -(k E + c v . N) / N . N: a velocity of 0 that is pushed along the normal, see
/// robust/kernel/contacts/along_normal.h, whose letters these are. Let s = |k| S of E and |c| S of v . N together, and
/// i the inverse of N . N. In units of E s i: E and v . N are off by 20 as Sum has it of four terms, as factors by 4.3
/// more, their products by 5.4; the sum of both rounds their tails twice, 2.2 each; N . N is off by 18, and by 4.3 as a
/// factor; of the quotient 17, of its product with N 14.6, as there. Together 89, and 160 are taken, eight times the
/// error of Sum.
///
/// A quotient of degree 3 by degree 2, which lies between 2^-658 and 2^512, as in damped_reflection. Underflow is again
/// below 2^-922, and the bound, which is at least 2^-680 unless it is 0, covers it.
Perhaps<Vector3d> stages::penalty_force::enclosed(const Point3d& p, const Vector3d& v, const Plane3d& plane,
                                                  double stiffness, double damping) {
  using namespace kernel;
  using Format = filters::FloatFormat<Two>;
  const Vector3d& n = plane.normal;
  const Two x(p.x, v.x), y(p.y, v.y), z(p.z, v.z), offset(plane.offset, 0), back(-stiffness, -damping);
  if (!in_window(x, y, z, offset, back, Two(n.x, n.y), Two(n.z, 0)) || !rounds_to_nearest()) return std::nullopt;
  const Vector3<Factor<Two>> normal = factors(n);
  const Enclosed<Two> along = enclosed_heights(normal, offset, factors(x, y, z));
  const Enclosed<double> height = first(along), square = first(enclosed_dots(normal, normal));
  if (!height.settled() || square.high == 0) return std::nullopt;  // no normal is refused
  if (height.high >= 0) return Vector3d{0, 0, 0};
  const Term2<Two> forces = product(factor(along), factor(back));
  const Pair<double> force = two_sum(forces.head.first(), forces.head.second());
  const Two errors = Format::magnitude(back) * along.error;
  const double force_low = force.low + (forces.tail.first() + forces.tail.second());
  const Divisor d(twice(square));
  const Share<Two> t =
      share(Term2<Two>{Two(force.high), Two(force_low)}, Two(errors.first() + errors.second()), d.value, d.inverse);
  if (const auto force_along = enclosed_push({0, 0, 0}, t, n)) return force_along->answer();
  return std::nullopt;
}

Vector3d stages::penalty_force::exact(const Point3d& p, const Vector3d& v, const Plane3d& plane, double stiffness,
                                      double damping) {
  using namespace kernel;
  const Dyadic height = exact_sum(height_over(plane, p));
  if (sgn(height.n) >= 0) return {0, 0, 0};
  const Vector3<Dyadic> n = dyadic(plane.normal);
  const Dyadic force = -(dyadic(stiffness) * height + dyadic(damping) * dot(dyadic(v), n)), square = dot(n, n);
  const auto component = [&](const Dyadic& of_normal) {
    const Dyadic part = force * of_normal;
    return round_quotient(part.n, square.n, static_cast<std::int64_t>(part.exponent) - square.exponent);
  };
  return {component(n.x), component(n.y), component(n.z)};
}

namespace {

void validate_penalty_force(const Point3d& point, const Vector3d& velocity, const Plane3d& plane, double stiffness,
                            double damping) {
  if (kernel::valid(point) && kernel::valid(velocity) && kernel::valid(plane) && kernel::all_finite(stiffness, damping))
    return;
  validation::validate_all("point", point, "velocity", velocity, "plane", plane, "stiffness", stiffness, "damping",
                           damping);
}

}  // namespace

Decided<Vector3d> stages::penalty_force::ask(const Point3d& p, const Vector3d& v, const Plane3d& plane,
                                             double stiffness, double damping) {
  return in_turn<penalty_force, Stage::enclosed, validate_penalty_force, Stage::exact>(p, v, plane, stiffness, damping);
}

Vector3d penalty_force(const Point3d& point, const Vector3d& velocity, const Plane3d& plane, double stiffness,
                       double damping) {
  return answer_in_turn<stages::penalty_force, Stage::enclosed, validate_penalty_force, Stage::exact>(
      point, velocity, plane, stiffness, damping);
}

}  // namespace touchstone::robust
