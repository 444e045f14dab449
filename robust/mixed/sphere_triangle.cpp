// SPDX-License-Identifier: Apache-2.0
#include "robust/mixed/sphere_triangle.h"

#include "robust/kernel/enclosed/enclosed_nearest.h"
#include "robust/kernel/filters/around_box_filter.h"
#include "robust/kernel/shapes/nearest_points.h"
#include "robust/kernel/shapes/valid.h"

namespace touchstone::robust {
namespace {

void validate_sphere_triangle(const Sphere3d& sphere, const Triangle3d& triangle) {
  if (kernel::valid(sphere) && kernel::valid(triangle)) return;
  validation::validate_all("sphere", sphere, "triangle", triangle);
}

}  // namespace

Perhaps<Contact> stages::sphere_triangle::filter(const Sphere3d& sphere, const Triangle3d& triangle) {
  if (kernel::sign_bit(sphere.radius)) return std::nullopt;  // -0.0, or negative, which validation refuses
  if (const auto apart = filters::beyond_box(sphere.center, sphere.radius, triangle.a, triangle.b, triangle.c))
    return apart;
  return filters::contact(triangle, 0, sphere.center, sphere.radius, true);
}

Perhaps<Contact> stages::sphere_triangle::enclosed(const Sphere3d& sphere, const Triangle3d& triangle) {
  return kernel::close_contact(triangle, 0, sphere.center, sphere.radius, true);
}

/// No distance is less than the radius 0 of a point, so that its lack of an interior needs no special case.
Contact stages::sphere_triangle::exact(const Sphere3d& sphere, const Triangle3d& triangle) {
  using namespace kernel;
  const auto& [a, b, c] = triangle;
  const auto [at, exponent] = integer_points(sphere.center, a, b, c, Point3d{sphere.radius, 0, 0});
  const QuotientPoint nearest = nearest_on_triangle(at[0], {at[1], at[2], at[3]});
  return contact(squared_distance(nearest, {at[0], 1}), at[4].x, true);
}

Decided<Contact> stages::sphere_triangle::ask(const Sphere3d& sphere, const Triangle3d& triangle) {
  return in_turn<sphere_triangle, Stage::filter, validate_sphere_triangle, Stage::enclosed, Stage::exact>(sphere,
                                                                                                          triangle);
}

Contact sphere_triangle(const Sphere3d& sphere, const Triangle3d& triangle) {
  return stages::sphere_triangle::ask(sphere, triangle).answer;
}

}  // namespace touchstone::robust
