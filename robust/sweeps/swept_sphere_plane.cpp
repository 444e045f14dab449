// SPDX-License-Identifier: Apache-2.0
#include "robust/sweeps/swept_sphere_plane.h"

#include <cstdint>

#include "robust/kernel/enclosed/enclosed_shapes.h"
#include "robust/kernel/filters/height_filter.h"
#include "robust/kernel/integers/plane_terms.h"
#include "robust/kernel/integers/quadratic_root.h"
#include "robust/kernel/shapes/first_contact.h"
#include "robust/kernel/shapes/valid.h"

namespace touchstone::robust {
namespace {

using filters::Meeting;
using Heights = filters::Heights<double>;

using kernel::hit;
using kernel::no_hit;

}  // namespace

Perhaps<FirstContact<double>> stages::swept_sphere_plane::filter(const Sphere3d& sphere, const Vector3d& velocity,
                                                                 const Plane3d& plane) {
  if (kernel::sign_bit(sphere.radius)) return std::nullopt;  // -0.0, or negative, which validation refuses
  const Meeting meeting = Heights(sphere, velocity, plane).meeting();
  if (meeting == Meeting::at_start) return hit(0);
  if (meeting == Meeting::never) return no_hit;
  return std::nullopt;
}

Perhaps<FirstContact<double>> stages::swept_sphere_plane::enclosed(const Sphere3d& sphere, const Vector3d& velocity,
                                                                   const Plane3d& plane) {
  const Heights heights(sphere, velocity, plane);
  if (kernel::sign_bit(sphere.radius) || heights.meeting() != Meeting::later) return std::nullopt;
  using namespace kernel;
  const Vector3d &n = plane.normal, &v = velocity;
  const Point3d& c = sphere.center;
  const Two x(c.x, v.x), y(c.y, v.y), z(c.z, v.z), offset(plane.offset, 0);
  if (!in_window(x, y, z, offset, Two(n.x, n.y), Two(n.z, sphere.radius)) || !rounds_to_nearest()) return std::nullopt;
  const Vector3<Factor<Two>> normal = factors(n);
  const Enclosed<Two> height_and_rise = enclosed_heights(normal, offset, factors(x, y, z));
  Sum squares(product(first(normal.x), first(normal.x)));
  squares += product(first(normal.y), first(normal.y)), squares += product(first(normal.z), first(normal.z));
  const Enclosed<double> square = squares.value(), height = first(height_and_rise), rise = second(height_and_rise);
  if (!square.settled() || !height.settled() || !rise.settled()) return std::nullopt;
  const Enclosed<double> length = square_root(square);
  if (!length.settled()) return std::nullopt;
  const Enclosed<double> reach = Enclosed<double>{sphere.radius, 0, 0} * length,
                         gap = (heights.behind() ? -height : height) - reach;
  const auto t = rounded(gap / Divisor(heights.behind() ? rise : -rise));
  if (!t) return std::nullopt;
  return hit(*t);
}

namespace {

/// E0 and S as integers times 2^exponent, and r^2 N . N as one times 2^(2 exponent).
struct Integers {
  mpz_class height, rise, squared_reach;

  Integers(const Sphere3d& sphere, const Vector3d& v, const Plane3d& plane) {
    using namespace kernel;
    const Vector3d& n = plane.normal;
    const Scaled<mpz_class> e = exact_sum(height_over(plane, sphere.center)),
                            s = exact_sum(std::array{term(n.x, v.x), term(n.y, v.y), term(n.z, v.z)}),
                            q = exact_sum(squared_normal(plane));
    const Term radius = term(sphere.radius);
    const mpz_class r = scaled(radius, 0);
    const int of_reach = q.exponent + 2 * radius.exponent,
              halved = of_reach >= 0 ? of_reach / 2 : -((1 - of_reach) / 2);
    const int exponent = std::min({e.exponent, s.exponent, halved});
    const auto in_units = [](const mpz_class& number, int shift) {
      return mpz_class(number << static_cast<std::uint64_t>(shift));
    };
    height = in_units(e.n, e.exponent - exponent), rise = in_units(s.n, s.exponent - exponent);
    squared_reach = in_units(q.n * r * r, of_reach - 2 * exponent);
  }
};

void validate_swept_sphere_plane(const Sphere3d& sphere, const Vector3d& velocity, const Plane3d& plane) {
  if (kernel::valid(sphere) && kernel::valid(velocity) && kernel::valid(plane)) return;
  validation::validate_all("sphere", sphere, "velocity", velocity, "plane", plane);
}

}  // namespace

/// With a center in front, E falls by -S: it is at the reach at (E0 - R) / -S. From behind the signs are reversed.
FirstContact<double> stages::swept_sphere_plane::exact(const Sphere3d& sphere, const Vector3d& velocity,
                                                       const Plane3d& plane) {
  const Integers n(sphere, velocity, plane);
  const bool behind = sgn(n.height) < 0;
  const mpz_class start = abs(n.height), fall = behind ? n.rise : mpz_class(-n.rise), end = start - fall;
  if (kernel::sign_with_root(start, -1, n.squared_reach) <= 0) return hit(0);
  if (kernel::sign_with_root(end, -1, n.squared_reach) > 0) return no_hit;
  return hit(kernel::round_quadratic_root(start, -1, n.squared_reach, fall));
}

Decided<FirstContact<double>> stages::swept_sphere_plane::ask(const Sphere3d& sphere, const Vector3d& velocity,
                                                              const Plane3d& plane) {
  return in_turn<swept_sphere_plane, Stage::filter, Stage::enclosed, validate_swept_sphere_plane, Stage::exact>(
      sphere, velocity, plane);
}

FirstContact<double> swept_sphere_plane(const Sphere3d& sphere, const Vector3d& velocity, const Plane3d& plane) {
  return stages::swept_sphere_plane::ask(sphere, velocity, plane).answer;
}

}  // namespace touchstone::robust
