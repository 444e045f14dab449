// SPDX-License-Identifier: Apache-2.0
#include "robust/mixed/ray_plane.h"

#include "geometry/validation.h"
#include "robust/kernel/shapes/plane_crossing.h"
#include "robust/kernel/shapes/valid.h"

namespace touchstone::robust {
namespace {

kernel::CrossingLine line_of(const Ray3d& ray, const Plane3d& plane) {
  const auto& [origin, v] = ray;
  const Vector3d& n = plane.normal;
  const std::array<kernel::Term, 3> rise{kernel::term(n.x, v.x), kernel::term(n.y, v.y), kernel::term(n.z, v.z)};
  kernel::CrossingLine found{kernel::exact_sum(kernel::height_over(plane, origin)), kernel::exact_sum(rise),
                             kernel::integers_of(origin.x, origin.y, origin.z, v.x, v.y, v.z)};
  kernel::to_one_unit(found.height, found.climb);
  return found;
}

void validate_ray_plane(const Ray3d& ray, const Plane3d& plane) {
  if (kernel::valid(ray.origin) && kernel::valid(ray.direction, rule::direction) && kernel::valid(plane)) return;
  validation::validate_all("ray", ray, "plane", plane);
}

}  // namespace

LinePlaneRelation stages::ray_plane::decision::exact(const Ray3d& ray, const Plane3d& plane) {
  return line_of(ray, plane).relation(false);
}

Decided<LinePlaneRelation> stages::ray_plane::decision::past_filter(const Ray3d& ray, const Plane3d& plane) {
  return in_turn<decision, validate_ray_plane, Stage::exact>(ray, plane);
}

Perhaps<LinePlane<double>> stages::ray_plane::enclosed(const Ray3d& ray, const Plane3d& plane) {
  using namespace kernel;
  const auto& [p, v] = ray;
  const Vector3d& n = plane.normal;
  const Two x(p.x, v.x), y(p.y, v.y), z(p.z, v.z);
  if (!in_window(Two(n.x, n.y), Two(n.z, plane.offset), x, y, z) || !rounds_to_nearest()) return std::nullopt;
  const Enclosed<Two> height_and_rise = enclosed_heights(factors(n), Two(plane.offset, 0.0), factors(x, y, z));
  const Enclosed<double> height = first(height_and_rise), descent = -second(height_and_rise);
  const bool ahead = (height.high > 0 && descent.high > 0) || (height.high < 0 && descent.high < 0);
  if (!height_and_rise.settled() || !ahead) return std::nullopt;
  return enclosed_crossing(height, descent, p, factor(Two(v.x, v.y)), factor(v.z));
}

LinePlane<double> stages::ray_plane::exact(const Ray3d& ray, const Plane3d& plane) {
  return line_of(ray, plane).answer(false);
}

/// The filter computes no number: it saves the cost if there is none.
LinePlane<double> ray_plane(const Ray3d& ray, const Plane3d& plane) {
  const auto relation = stages::ray_plane::decision::filter(ray, plane);
  if (relation && *relation == LinePlaneRelation::none) return {LinePlaneRelation::none, std::nullopt, std::nullopt};
  return answer_in_turn<stages::ray_plane, Stage::enclosed, validate_ray_plane, Stage::exact>(ray, plane);
}

}  // namespace touchstone::robust
