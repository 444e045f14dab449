// SPDX-License-Identifier: Apache-2.0
#include "robust/sweeps/swept_sphere_triangle.h"

#include "robust/kernel/enclosed/round_solids.h"
#include "robust/kernel/shapes/center_near_polygon.h"
#include "robust/kernel/shapes/valid.h"

namespace touchstone::robust {
namespace {

void validate_swept_sphere_triangle(const Sphere3d& sphere, const Vector3d& velocity, const Triangle3d& triangle) {
  if (kernel::valid(sphere) && kernel::valid(velocity) && kernel::valid(triangle)) return;
  validation::validate_all("sphere", sphere, "velocity", velocity, "triangle", triangle);
}

}  // namespace

/// The center at the start and the triangle are two cores; so are its path and the triangle.
Perhaps<FirstContact<double>> stages::swept_sphere_triangle::filter_until(const Sphere3d& sphere,
                                                                          const Vector3d& velocity, double until,
                                                                          const Triangle3d& triangle) {
  using filters::moderate;
  const auto& [center, radius] = sphere;
  const auto& [a, b, c] = triangle;
  if (!(moderate(center) & moderate(radius) & moderate(velocity) & moderate(a) & moderate(b) & moderate(c)))
    return std::nullopt;
  const Vector3d u = b - a, w = c - a, way = center - a;
  const Perhaps<Contact> start = filters::Differences<2, 0, true>{{u, w}, way}.contact(radius);
  if (start && *start == Contact::overlapping) return kernel::hit(0);
  const Perhaps<Contact> step = filters::Differences<3, 0, true>{{-until * velocity, u, w}, way}.contact(radius);
  if (step && *step == Contact::disjoint) return kernel::no_hit;
  return std::nullopt;
}

Perhaps<FirstContact<double>> stages::swept_sphere_triangle::filter(const Sphere3d& sphere, const Vector3d& velocity,
                                                                    const Triangle3d& triangle) {
  return filter_until(sphere, velocity, 1, triangle);
}

FirstContact<double> stages::swept_sphere_triangle::exact(const Sphere3d& sphere, const Vector3d& velocity,
                                                          const Triangle3d& triangle) {
  return kernel::center_near(sphere, velocity, triangle).first_contact();
}

/// The filter takes the square of a negative radius: the ball is validated first.
Decided<FirstContact<double>> stages::swept_sphere_triangle::ask(const Sphere3d& sphere, const Vector3d& velocity,
                                                                 const Triangle3d& triangle) {
  return in_turn<swept_sphere_triangle, validate_swept_sphere_triangle, Stage::filter, Stage::exact>(sphere, velocity,
                                                                                                     triangle);
}

FirstContact<double> swept_sphere_triangle(const Sphere3d& sphere, const Vector3d& velocity,
                                           const Triangle3d& triangle) {
  return stages::swept_sphere_triangle::ask(sphere, velocity, triangle).answer;
}

}  // namespace touchstone::robust
