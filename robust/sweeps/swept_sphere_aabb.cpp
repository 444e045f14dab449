// SPDX-License-Identifier: Apache-2.0
#include "robust/sweeps/swept_sphere_aabb.h"

#include <array>

#include "robust/kernel/enclosed/round_solids.h"
#include "robust/kernel/integers/integers.h"
#include "robust/kernel/shapes/moving_center.h"
#include "robust/kernel/shapes/valid.h"

namespace touchstone::robust {
namespace {

using kernel::HeightOfStep;
using kernel::SquaredGap;
using kernel::TimeOfStep;

/// The heights of the center over both sides of the box on an axis, all in one unit.
struct CenterOnAxis {
  HeightOfStep over_min, over_max;
};
using CenterOnAxes = std::array<CenterOnAxis, 3>;

/// As it is around t.
SquaredGap gap_around(const CenterOnAxes& axes, const mpz_class& radius, const TimeOfStep& t) {
  SquaredGap f{-radius * radius, 0, 0};
  for (const auto& [over_min, over_max] : axes) {
    const bool below = over_min.sign_at(t) < 0;
    if (!below && over_max.sign_at(t) <= 0) continue;
    const auto& [gap, velocity] = below ? over_min : over_max;
    f.start += gap * gap, f.half += gap * velocity, f.square += velocity * velocity;
  }
  return f;
}

void validate_swept_sphere_aabb(const Sphere3d& sphere, const Vector3d& velocity, const Aabb3d& aabb) {
  if (kernel::valid(sphere) && kernel::valid(velocity) && kernel::valid(aabb)) return;
  validation::validate_all("sphere", sphere, "velocity", velocity, "aabb", aabb);
}

}  // namespace

/// The center at the start and the box are two cores; so are its path and the box.
Perhaps<FirstContact<double>> stages::swept_sphere_aabb::filter(const Sphere3d& sphere, const Vector3d& velocity,
                                                                const Aabb3d& aabb) {
  using filters::moderate;
  const auto& [center, radius] = sphere;
  if (!(moderate(center) & moderate(radius) & moderate(velocity) & moderate(aabb.min) & moderate(aabb.max)))
    return std::nullopt;
  const Vector3d size = aabb.max - aabb.min, way = center - aabb.min;
  const Vector3d x{size.x, 0, 0}, y{0, size.y, 0}, z{0, 0, size.z};
  const Perhaps<Contact> start = filters::Differences<3, 0>{{x, y, z}, way}.contact(radius);
  if (start && *start == Contact::overlapping) return kernel::hit(0);
  const Perhaps<Contact> step = filters::Differences<4, 0>{{x, y, z, -1.0 * velocity}, way}.contact(radius);
  if (step && *step == Contact::disjoint) return kernel::no_hit;
  return std::nullopt;
}

/// The nearest corner, edge or face changes where the center passes the plane of a face.
FirstContact<double> stages::swept_sphere_aabb::exact(const Sphere3d& sphere, const Vector3d& velocity,
                                                      const Aabb3d& aabb) {
  const auto& [c, radius] = sphere;
  const auto& [min, max] = aabb;
  const auto n = kernel::integers_of(c.x, velocity.x, min.x, max.x, c.y, velocity.y, min.y, max.y, c.z, velocity.z,
                                     min.z, max.z, radius)
                     .at;
  CenterOnAxes axes;
  kernel::TimesOfChange times;
  for (std::size_t k = 0; k < 3; ++k) {
    const mpz_class &at = n[4 * k], &v = n[4 * k + 1];
    axes[k] = {{at - n[4 * k + 2], v}, {at - n[4 * k + 3], v}};
    times.crosses(axes[k].over_min), times.crosses(axes[k].over_max);
  }
  return kernel::first_contact(times, [&](const TimeOfStep& t) { return gap_around(axes, n[12], t); });
}

/// The filter does not check which end of an interval is the lesser: the box is validated first.
Decided<FirstContact<double>> stages::swept_sphere_aabb::ask(const Sphere3d& sphere, const Vector3d& velocity,
                                                             const Aabb3d& aabb) {
  return in_turn<swept_sphere_aabb, validate_swept_sphere_aabb, Stage::filter, Stage::exact>(sphere, velocity, aabb);
}

FirstContact<double> swept_sphere_aabb(const Sphere3d& sphere, const Vector3d& velocity, const Aabb3d& aabb) {
  return stages::swept_sphere_aabb::ask(sphere, velocity, aabb).answer;
}

}  // namespace touchstone::robust
