// SPDX-License-Identifier: Apache-2.0
#include "robust/sweeps/swept_sphere_aabb.h"

#include <algorithm>
#include <array>
#include <vector>

#include "robust/kernel/enclosed/round_solids.h"
#include "robust/kernel/integers/integers.h"
#include "robust/kernel/integers/quadratic_root.h"
#include "robust/kernel/shapes/first_contact.h"
#include "robust/kernel/shapes/valid.h"

namespace touchstone::robust {
namespace {

using kernel::hit;
using kernel::no_hit;

/// One coordinate of the center and of its velocity, and the box's interval, all in one unit.
struct CenterOnAxis {
  mpz_class at, velocity, min, max;
};
using CenterOnAxes = std::array<CenterOnAxis, 3>;

/// numerator / denominator, denominator > 0.
struct TimeOfStep {
  mpz_class numerator, denominator;
  friend bool operator<(const TimeOfStep& s, const TimeOfStep& t) {
    return s.numerator * t.denominator < t.numerator * s.denominator;
  }
};

/// f(t) - r^2 = square t^2 + 2 half t + start, f being the squared distance of the center from the box.
struct SquaredGap {
  mpz_class start, half, square;

  /// As it is around t.
  SquaredGap(const CenterOnAxes& axes, const mpz_class& radius, const TimeOfStep& t) : start(-radius * radius) {
    for (const auto& [at, velocity, min, max] : axes) {
      const mpz_class place = at * t.denominator + velocity * t.numerator;
      const bool below = place < min * t.denominator;
      if (!below && place <= max * t.denominator) continue;
      const mpz_class gap = at - (below ? min : max);
      start += gap * gap, half += gap * velocity, square += velocity * velocity;
    }
  }
  mpz_class slope_at(const TimeOfStep& t) const { return square * t.numerator + half * t.denominator; }
  mpz_class value_at(const TimeOfStep& t) const {
    const mpz_class slopes = slope_at(t) + half * t.denominator;
    return slopes * t.numerator + start * t.denominator * t.denominator;
  }
  mpz_class discriminant() const { return half * half - square * start; }
};

/// The start, the end, and the times between at which the center passes the plane of a face, in order.
std::vector<TimeOfStep> times_of_change(const CenterOnAxes& axes) {
  std::vector<TimeOfStep> times{{0, 1}, {1, 1}};
  for (const auto& axis : axes) {
    for (const mpz_class* side : {&axis.min, &axis.max}) {
      const mpz_class gap = (*side - axis.at) * sgn(axis.velocity), speed = abs(axis.velocity);
      if (sgn(gap) > 0 && gap < speed) times.push_back({gap, speed});
    }
  }
  std::sort(times.begin(), times.end());
  return times;
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
  if (start && *start == Contact::overlapping) return hit(0);
  const Perhaps<Contact> step = filters::Differences<4, 0>{{x, y, z, -1.0 * velocity}, way}.contact(radius);
  if (step && *step == Contact::disjoint) return no_hit;
  return std::nullopt;
}

/// f is convex, its slope continuous, and it is a polynomial between two times of change: the first of these pieces in
/// which f - r^2 has a zero has the first contact, unless f has stopped falling before.
FirstContact<double> stages::swept_sphere_aabb::exact(const Sphere3d& sphere, const Vector3d& velocity,
                                                      const Aabb3d& aabb) {
  const auto& [c, radius] = sphere;
  const auto& [min, max] = aabb;
  const auto n = kernel::integers_of(c.x, velocity.x, min.x, max.x, c.y, velocity.y, min.y, max.y, c.z, velocity.z,
                                     min.z, max.z, radius)
                     .at;
  const CenterOnAxes axes{{{n[0], n[1], n[2], n[3]}, {n[4], n[5], n[6], n[7]}, {n[8], n[9], n[10], n[11]}}};
  const std::vector<TimeOfStep> times = times_of_change(axes);
  if (sgn(SquaredGap(axes, n[12], times[0]).start) <= 0) return hit(0);
  for (std::size_t i = 1; i < times.size(); ++i) {
    const TimeOfStep &from = times[i - 1], &to = times[i];
    const SquaredGap f(
        axes, n[12],
        {from.numerator * to.denominator + to.numerator * from.denominator, 2 * from.denominator * to.denominator});
    if (sgn(f.slope_at(from)) >= 0) return no_hit;
    const bool turns = sgn(f.slope_at(to)) > 0 && sgn(f.discriminant()) >= 0;
    if (turns || sgn(f.value_at(to)) <= 0)
      return hit(kernel::round_quadratic_root(-f.half, -1, f.discriminant(), f.square));
  }
  return no_hit;
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
