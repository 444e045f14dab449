// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "geometry/volumes.h"
#include "oracle/exact/shapes/passage.h"
#include "oracle/exact/systems/zonotope.h"

namespace touchstone::oracle {

/// The first and the last t at which a line of space is in a valid parallelepiped, by the linear program in t and the
/// coefficients of the half axes.
Truth<Passage<Rational>> passage_of_parallelepiped(const Line& line, const Obb3<Rational>& box);

/// The same of a ray or a segment of that field; refuses invalid input.
template <class Shape, class Number>
Truth<Passage<Rational>> passage_of_obb(const std::string& field, const Shape& shape, const Obb3<Number>& obb) {
  validation::validate_numbers(field, shape), validation::validate_numbers("obb", obb);
  validation::validate(field, shape), validate_parallelepiped("obb", obb);
  const auto along = [](const Vector3<Number>& v) { return Vector3<Rational>{exact(v.x), exact(v.y), exact(v.z)}; };
  const auto& [u, v, w] = obb.half_axes;
  return passage_of_parallelepiped(line_of(shape), {exact(obb.center), {along(u), along(v), along(w)}});
}

}  // namespace touchstone::oracle
