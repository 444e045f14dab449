// SPDX-License-Identifier: Apache-2.0
#include "robust/mixed/triangle_obb.h"

#include <algorithm>
#include <array>

#include "robust/kernel/enclosed/round_solids.h"
#include "robust/kernel/shapes/nearest_points.h"
#include "robust/kernel/solids/separating_axes.h"

namespace touchstone::robust {
namespace {

void validate_triangle_obb(const Triangle3d& triangle, const Obb3d& obb) {
  kernel::validate_with_obb("triangle", triangle, "obb", obb);
}

template <class Number>
std::array<Vector3<Number>, 6> edges_of_triangle_obb(const Triangle3<Number>& t, const HalfAxes<Number>& half_axes) {
  return {{half_axes.u, half_axes.v, half_axes.w, t.b - t.a, t.c - t.b, t.a - t.c}};
}

}  // namespace

/// Sides and displacements of corners are differences, so no axis is known to be zero where two are alike. The bound's
/// sizes contain those of the half axes and of the corner that is farthest. A product goes through less than 32
/// operations, as in round_solids.h. Not proved by machine.
Perhaps<Contact> stages::triangle_obb::filter(const Triangle3d& t, const Obb3d& obb) {
  using filters::moderate, filters::size_of, filters::Sign;
  const auto& [u, v, w] = obb.half_axes;
  const Point3d& center = obb.center;
  if (!(moderate(t) & moderate(obb)) || !filters::independent(u, v, w)) return std::nullopt;  // perhaps not valid
  const auto edges = edges_of_triangle_obb(t, obb.half_axes);
  const std::array<Vector3d, 3> corners{t.a - center, t.b - center, t.c - center};
  const double far = std::max({size_of<double>(corners[0]), size_of<double>(corners[1]), size_of<double>(corners[2])}),
               sizes = far + (size_of<double>(u) + size_of<double>(v) + size_of<double>(w));
  const auto on_axis = [&](const kernel::Spanned& axis) {
    const Vector3d n = cross(edges[axis.v], edges[axis.w]);
    const auto along = [&n](const Vector3d& x) { return filters::FloatFormat<double>::magnitude(dot(n, x)); };
    const double a = dot(n, corners[0]), b = dot(n, corners[1]), c = dot(n, corners[2]),
                 gap = std::max(std::min({a, b, c}), std::min({-a, -b, -c})) -
                       (along(edges[0]) + along(edges[1]) + along(edges[2])),
                 size = size_of<double>(edges[axis.v]) * size_of<double>(edges[axis.w]) * sizes,
                 error = filters::error_of_32_roundings * size;
    return gap > error ? Sign::positive : gap < -error ? Sign::negative : Sign::unknown;
  };
  return kernel::contact_by_signs(edges, on_axis, kernel::without_products);
}

/// The differences of points of both are a solid with an interior, whose faces are spanned by two edges that are not
/// parallel: so axes that are zero do not count.
Contact stages::triangle_obb::exact(const Triangle3d& t, const Obb3d& obb) {
  using namespace kernel;
  const auto& [u, v, w] = obb.half_axes;
  const auto [at, exponent] = integer_points(t.a, t.b, t.c, obb.center, in_space(u), in_space(v), in_space(w));
  const Triangle3<mpz_class> triangle{at[0], at[1], at[2]};
  const IntegerBox box = box_of(at, 3);
  const auto& [x, y, z] = box.half_axes;
  const auto edges = edges_of_triangle_obb<mpz_class>(triangle, {x, y, z});
  const IntegerPoint& o = box.center;
  return contact_with_triangle<mpz_class>(edges, box.half_axes, {at[0] - o, at[1] - o, at[2] - o});
}

Decided<Contact> stages::triangle_obb::ask(const Triangle3d& triangle, const Obb3d& obb) {
  return in_turn<triangle_obb, Stage::filter, validate_triangle_obb, Stage::exact>(triangle, obb);
}

Contact triangle_obb(const Triangle3d& triangle, const Obb3d& obb) {
  return stages::triangle_obb::ask(triangle, obb).answer;
}

}  // namespace touchstone::robust
