// SPDX-License-Identifier: Apache-2.0
#include "robust/planes/obb_plane.h"

#include <algorithm>
#include <array>

#include "robust/kernel/enclosed/round_solids.h"
#include "robust/kernel/integers/plane_terms.h"
#include "robust/kernel/shapes/valid.h"
#include "robust/kernel/solids/parallelepiped.h"

namespace touchstone::robust {
namespace {

void validate_obb_plane(const Obb3d& obb, const Plane3d& plane) {
  if (kernel::valid(obb)) validation::validate_numbers("plane", plane);  // before the rules of the box
  kernel::validate_obb("obb", obb), validation::validate("plane", plane);
}

}  // namespace

/// The height of the lowest corner. A product goes through itself, no more than seven sums and magnitudes, and the sums
/// of the bound: less than 32 operations, as in round_solids.h. Not proved by machine.
Perhaps<Contact> stages::obb_plane::filter(const Obb3d& obb, const Plane3d& plane) {
  using filters::moderate, filters::size_of;
  const auto& [u, v, w] = obb.half_axes;
  const Vector3d &n = plane.normal, c = obb.center - Point3d{0, 0, 0};
  if (!(moderate(n) & moderate(plane.offset) & moderate(c) & moderate(u) & moderate(v) & moderate(w)))
    return std::nullopt;
  if (!kernel::valid(plane) || !filters::independent(u, v, w)) return std::nullopt;  // perhaps not valid
  const auto magnitude = [](double x) { return filters::FloatFormat<double>::magnitude(x); };
  const double reach = magnitude(dot(n, u)) + magnitude(dot(n, v)) + magnitude(dot(n, w)),
               lowest = dot(n, c) + plane.offset - reach,
               sizes = size_of<double>(c) + size_of<double>(u) + size_of<double>(v) + size_of<double>(w),
               error = filters::error_of_32_roundings * (size_of<double>(n) * sizes + magnitude(plane.offset));
  if (lowest > error) return Contact::disjoint;
  if (lowest < -error) return Contact::overlapping;
  return std::nullopt;
}

/// The same height as one sum: each half axis has the sign with which it leads down.
Contact stages::obb_plane::exact(const Obb3d& obb, const Plane3d& plane) {
  using namespace kernel;
  std::array<Term, 16> terms{};
  const auto height = height_over(plane, obb.center);
  auto next = std::copy(height.begin(), height.end(), terms.begin());
  for (const Vector3d* axis : {&obb.half_axes.u, &obb.half_axes.v, &obb.half_axes.w}) {
    const auto along = height_over({plane.normal, 0}, {axis->x, axis->y, axis->z});
    const bool rises = sgn(exact_sum(along).n) > 0;
    for (const Term& each : along) *next++ = rises ? -each : each;
  }
  const int sign = sgn(exact_sum(terms).n);
  return sign > 0 ? Contact::disjoint : sign < 0 ? Contact::overlapping : Contact::touching;
}

Decided<Contact> stages::obb_plane::ask(const Obb3d& obb, const Plane3d& plane) {
  return in_turn<obb_plane, Stage::filter, validate_obb_plane, Stage::exact>(obb, plane);
}

Contact obb_plane(const Obb3d& obb, const Plane3d& plane) { return stages::obb_plane::ask(obb, plane).answer; }

}  // namespace touchstone::robust
