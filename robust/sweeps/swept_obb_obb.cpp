// SPDX-License-Identifier: Apache-2.0
#include "robust/sweeps/swept_obb_obb.h"

#include <array>

#include "robust/kernel/enclosed/round_solids.h"
#include "robust/kernel/filters/obb_filter.h"
#include "robust/kernel/integers/axis_times.h"
#include "robust/kernel/shapes/first_contact.h"
#include "robust/kernel/solids/separating_axes.h"

namespace touchstone::robust {
namespace {

void validate_swept_obb_obb(const Obb3d& a, const Obb3d& b, const Vector3d& velocity) {
  if (!(kernel::valid(a) && kernel::valid(b) && kernel::valid(velocity))) {
    validation::validate_numbers("a", a), validation::validate_numbers("b", b);
    validation::validate_numbers("velocity", velocity);
  }
  kernel::validate_obb("a", a), kernel::validate_obb("b", b);
}

}  // namespace

/// They meet at the start if no axis separates them; and never do if a plane separates what a sweeps over from b.
Perhaps<FirstContact<double>> stages::swept_obb_obb::filter(const Obb3d& a, const Obb3d& b, const Vector3d& velocity) {
  using filters::moderate;
  if (!(moderate(a) & moderate(b) & moderate(velocity))) return std::nullopt;
  const auto& [u, v, w] = a.half_axes;
  const auto& [x, y, z] = b.half_axes;
  const std::array<Vector3d, 6> edges{u, v, w, x, y, z};
  const filters::ObbAxes<double> pair(edges, b.center - a.center);
  const Perhaps<Contact> start = kernel::contact_by_signs(
      edges, [&pair](const kernel::Spanned& axis) { return pair.on_axis(axis.v, axis.w, axis.others); });
  if (start && *start == Contact::overlapping) return kernel::hit(0);
  const filters::Differences<7, 6> step{{u, v, w, x, y, z, velocity}, b.center - a.center};
  const Perhaps<Contact> swept = step.contact(0);
  if (swept && *swept == Contact::disjoint) return kernel::no_hit;
  return std::nullopt;
}

/// On each axis that may separate the boxes, a reaches as far from its center as all half axes together, and b is the
/// point that its center is.
FirstContact<double> stages::swept_obb_obb::exact(const Obb3d& a, const Obb3d& b, const Vector3d& velocity) {
  const Point3d &c = a.center, &d = b.center;
  const auto& [u, v, w] = a.half_axes;
  const auto& [x, y, z] = b.half_axes;
  const auto n = kernel::integers_of(c.x, c.y, c.z, u.x, u.y, u.z, v.x, v.y, v.z, w.x, w.y, w.z,  //
                                     d.x, d.y, d.z, x.x, x.y, x.z, y.x, y.y, y.z, z.x, z.y, z.z,  //
                                     velocity.x, velocity.y, velocity.z)
                     .at;
  const auto at = [&n](std::size_t i) { return kernel::vector_at(n, i); };
  const std::array<Vector3<mpz_class>, 6> edges{at(3), at(6), at(9), at(15), at(18), at(21)};
  const Vector3<mpz_class> way = at(12) - at(0), step = at(24);
  kernel::AxisTimes<mpz_class> times;
  for (const kernel::Spanned& each : kernel::axes_of_boxes) {
    const Vector3<mpz_class> axis = cross(edges[each.v], edges[each.w]);
    mpz_class reach = 0;
    for (const std::size_t other : each.others) reach += abs(dot(axis, edges[other]));
    const mpz_class height = dot(axis, way);
    times.cut({-reach, reach, height, height, dot(axis, step)});
  }
  return times.contact();
}

/// The filter takes independent half axes for granted: the boxes are validated first.
Decided<FirstContact<double>> stages::swept_obb_obb::ask(const Obb3d& a, const Obb3d& b, const Vector3d& velocity) {
  return in_turn<swept_obb_obb, validate_swept_obb_obb, Stage::filter, Stage::exact>(a, b, velocity);
}

FirstContact<double> swept_obb_obb(const Obb3d& a, const Obb3d& b, const Vector3d& velocity) {
  return stages::swept_obb_obb::ask(a, b, velocity).answer;
}

}  // namespace touchstone::robust
