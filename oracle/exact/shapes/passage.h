// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "geometry/capsules.h"
#include "geometry/rays.h"
#include "geometry/validation.h"
#include "oracle/exact/numbers/decode.h"
#include "oracle/exact/numbers/surd.h"
#include "oracle/truth.h"

/// The first and the last t at which a line is in a solid, in the plane or in space, coordinate by coordinate.
namespace touchstone::oracle {

/// The points from + t way with t >= 0, and t <= 1 if it ends.
struct Line {
  std::vector<Rational> from, displacement;
  bool ends;
};

template <class Place>
std::vector<Rational> coordinates(const Place& p) {
  if constexpr (requires { p.z; }) return {exact(p.x), exact(p.y), exact(p.z)};
  else return {exact(p.x), exact(p.y)};
}
/// The line of a ray or a segment.
template <class Shape>
Line line_of(const Shape& shape) {
  if constexpr (requires { shape.direction; }) {
    return {coordinates(shape.origin), coordinates(shape.direction), false};
  } else {
    Line line{coordinates(shape.a), coordinates(shape.b), true};
    for (std::size_t k = 0; k < line.displacement.size(); ++k) line.displacement[k] -= line.from[k];
    return line;
  }
}

/// By the linear program in t: its least and its greatest value.
Truth<Passage<Rational>> passage_of_box(const Line& line, const std::vector<Rational>& min,
                                        const std::vector<Rational>& max);

/// By the changes of sign of f(t) = |from + t way - center|^2 - radius^2, forwards and backwards; a ray is cut after
/// all zeros.
Truth<Passage<Surd>> passage_of_ball(const Line& line, const std::vector<Rational>& center, const Rational& radius);

/// By the changes of sign of f(t), the squared distance of from + t way from the segment from a to b, minus radius^2,
/// forwards and backwards: f is convex and smooth, and a polynomial as long as the same end, or none, is the nearest.
Truth<Passage<Surd>> passage_of_capsule(const Line& line, const std::vector<Rational>& a,
                                        const std::vector<Rational>& b, const Rational& radius);

/// The same of a ray or a segment of that field; refuses invalid input.
template <class Shape, class Number>
Truth<Passage<Surd>> passage_of_capsule(const char* field, const Shape& shape, const Capsule3<Number>& capsule) {
  validation::validate_all(field, shape, "capsule", capsule);
  const auto& [a, b] = capsule.segment;
  return passage_of_capsule(line_of(shape), coordinates(a), coordinates(b), exact(capsule.radius));
}

}  // namespace touchstone::oracle
