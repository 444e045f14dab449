// SPDX-License-Identifier: Apache-2.0
#include "robust/volumes/aabb_obb.h"

#include <array>

#include "robust/kernel/enclosed/round_solids.h"
#include "robust/kernel/shapes/valid.h"
#include "robust/kernel/solids/separating_axes.h"

namespace touchstone::robust {
namespace {

void validate_aabb_obb(const Aabb3d& aabb, const Obb3d& obb) {
  if (!kernel::valid(aabb)) {
    validation::validate_numbers("aabb", aabb), validation::validate_numbers("obb", obb);
    validation::validate("aabb", aabb);
  }
  kernel::validate_obb("obb", obb);
}

bool has_interior(const Aabb3d& box) {
  const auto& [min, max] = box;
  return !validation::same(min.x, max.x) && !validation::same(min.y, max.y) && !validation::same(min.z, max.z);
}

/// A flat box has an edge of length 0, but its axes: the edges' directions are the axes of space.
template <class Number>
std::array<Vector3<Number>, 6> directions(const HalfAxes<Number>& half_axes) {
  const Number zero(0), one(1);
  const auto& [u, v, w] = half_axes;
  return {{{one, zero, zero}, {zero, one, zero}, {zero, zero, one}, u, v, w}};
}

/// Twice the half axes of both.
template <class Number>
std::array<Vector3<Number>, 6> doubled(const Aabb3<Number>& box, const HalfAxes<Number>& half_axes) {
  const Number zero(0);
  const Vector3<Number> width = box.max - box.min;
  const auto& [u, v, w] = half_axes;
  return {{{width.x, zero, zero}, {zero, width.y, zero}, {zero, zero, width.z}, u + u, v + v, w + w}};
}

/// Twice the displacement of the centers.
template <class Number>
Vector3<Number> displacement(const Aabb3<Number>& box, const Point3<Number>& center) {
  return (center - box.min) + (center - box.max);
}

Contact of_solid(Contact contact, const Aabb3d& aabb) {
  return contact == Contact::overlapping && !has_interior(aabb) ? Contact::touching : contact;
}

}  // namespace

/// The displacement is twice the center less both ends; the bound's sizes contain those of all three, and of both for
/// each edge. A product goes through less than 32 operations, as in round_solids.h. Not proved by machine.
Perhaps<Contact> stages::aabb_obb::filter(const Aabb3d& aabb, const Obb3d& obb) {
  using filters::moderate, filters::size_of;
  const auto& [u, v, w] = obb.half_axes;
  const Point3d origin{0, 0, 0};
  if (!(moderate(aabb.min) & moderate(aabb.max) & moderate(obb.center) & moderate(u) & moderate(v) & moderate(w)))
    return std::nullopt;
  if (!kernel::valid(aabb) || !filters::independent(u, v, w)) return std::nullopt;  // perhaps not valid
  const auto edges = directions(obb.half_axes), half_axes = doubled(aabb, obb.half_axes);
  const Vector3d way = displacement(aabb, obb.center);
  double sizes =
      size_of<double>(aabb.min - origin) + size_of<double>(aabb.max - origin) + size_of<double>(obb.center - origin);
  sizes = sizes + (size_of<double>(u) + size_of<double>(v) + size_of<double>(w));
  const auto on_axis = [&](const kernel::Spanned& axis) {
    const Vector3d n = cross(edges[axis.v], edges[axis.w]);
    const auto along = [&n](const Vector3d& x) { return filters::FloatFormat<double>::magnitude(dot(n, x)); };
    double gap = along(way);
    for (const std::size_t other : axis.others) gap = gap - along(half_axes[other]);
    const double size = size_of<double>(edges[axis.v]) * size_of<double>(edges[axis.w]) * (2 * sizes),
                 error = filters::error_of_32_roundings * size;
    return gap > error ? filters::Sign::positive : gap < -error ? filters::Sign::negative : filters::Sign::unknown;
  };
  const auto contact = kernel::contact_by_signs(edges, on_axis);
  return contact ? Perhaps<Contact>(of_solid(*contact, aabb)) : contact;
}

Contact stages::aabb_obb::exact(const Aabb3d& aabb, const Obb3d& obb) {
  const auto& [min, max] = aabb;
  const auto& [u, v, w] = obb.half_axes;
  const Point3d& c = obb.center;
  const auto n = kernel::integers_of(min.x, min.y, min.z, max.x, max.y, max.z, c.x, c.y, c.z,  //
                                     u.x, u.y, u.z, v.x, v.y, v.z, w.x, w.y, w.z)
                     .at;
  const auto point = [&n](std::size_t i) { return Point3<mpz_class>{n[i], n[i + 1], n[i + 2]}; };
  const Aabb3<mpz_class> box{point(0), point(3)};
  const HalfAxes<mpz_class> half_axes{kernel::vector_at(n, 9), kernel::vector_at(n, 12), kernel::vector_at(n, 15)};
  const Contact contact =
      kernel::contact_by_axes(directions(half_axes), doubled(box, half_axes), displacement(box, point(6)));
  return of_solid(contact, aabb);
}

Decided<Contact> stages::aabb_obb::ask(const Aabb3d& aabb, const Obb3d& obb) {
  return in_turn<aabb_obb, Stage::filter, validate_aabb_obb, Stage::exact>(aabb, obb);
}

Contact aabb_obb(const Aabb3d& aabb, const Obb3d& obb) { return stages::aabb_obb::ask(aabb, obb).answer; }

}  // namespace touchstone::robust
