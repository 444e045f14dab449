// SPDX-License-Identifier: Apache-2.0
#include "oracle/exact/common_points.h"

#include <algorithm>

#include "oracle/exact/linear_program.h"

namespace touchstone::oracle {
namespace {

Int128 narrow(const Integer& value, Int128*) { return value.get_si(); }
const Integer& narrow(const Integer& value, Integer*) { return value; }

template <class Value>
CommonPoints solve(const Segment2<Integer>& first, Extent extent, const Segment2<Integer>& second) {
  using Program = LinearProgram<Value>;
  const auto equal = Program::Row::equal, at_most = Program::Row::at_most;
  static const std::vector<typename Program::Row> ray_rows{equal, equal, at_most};
  static const std::vector<typename Program::Row> segment_rows{equal, equal, at_most, at_most};
  const Vector2<Integer> u = first.b - first.a, v = second.a - second.b, w = second.a - first.a;
  Program program(2, extent == Extent::ray ? ray_rows : segment_rows);
  Value* type = nullptr;
  program.set_coefficient(0, 0, narrow(u.x, type)), program.set_coefficient(1, 0, narrow(u.y, type));
  program.set_coefficient(0, 1, narrow(v.x, type)), program.set_coefficient(1, 1, narrow(v.y, type));
  program.set_right_side(0, narrow(w.x, type)), program.set_right_side(1, narrow(w.y, type));
  program.set_coefficient(2, 1, Value(1)), program.set_right_side(2, Value(1));
  if (extent == Extent::segment) program.set_coefficient(3, 0, Value(1)), program.set_right_side(3, Value(1));

  CommonPoints result;
  result.any = program.feasible();
  if (!result.any) {  // the Farkas vector holds the first shape above the second
    result.normal = {Integer(-widen(program.farkas()[0])), Integer(-widen(program.farkas()[1]))};
    return result;
  }
  const auto parameter = [&](int variable) {
    return quotient(widen(program.numerator(variable)), widen(program.denominator()));
  };
  static const std::vector<Value> least{Value(1), Value(0)}, greatest{Value(-1), Value(0)};
  program.minimise(least);
  result.first = parameter(0), result.second_at_first = parameter(1);
  // On a first shape of length zero every parameter is the same point; the least one, 0, speaks for it.
  if (sgn(u.x) != 0 || sgn(u.y) != 0) program.minimise(greatest);
  result.last = parameter(0), result.second_at_last = parameter(1);
  return result;
}

}  // namespace

CommonPoints common_points(const Segment2<Integer>& first, Extent extent, const Segment2<Integer>& second, int bits) {
  // Minors of (A b I) are sums of at most four products of two differences: below 2^(2 bits + 4) <= 2^60.
  return bits <= 28 ? solve<Int128>(first, extent, second) : solve<Integer>(first, extent, second);
}

SquaredLength squared_distance(const Point2<Integer>& point, const Segment2<Integer>& shape, Extent extent) {
  const Vector2<Integer> v = shape.b - shape.a, w = point - shape.a;
  const Integer along = dot(v, w), length = dot(v, v);
  if (sgn(along) <= 0) return {dot(w, w), Integer(1)};
  if (extent == Extent::segment && along >= length) {
    const Vector2<Integer> beyond = point - shape.b;
    return {dot(beyond, beyond), Integer(1)};
  }
  const Integer area = cross(v, w);
  return {Integer(area * area), length};
}

Rational least_end_distance(const Segment2<Integer>& first, Extent extent, const Segment2<Integer>& second) {
  SquaredLength least = squared_distance(first.a, second, Extent::segment);
  const auto consider = [&](const Point2<Integer>& end, const Segment2<Integer>& shape, Extent reach) {
    const SquaredLength other = squared_distance(end, shape, reach);
    if (Integer(other.numerator * least.denominator) < Integer(least.numerator * other.denominator)) least = other;
  };
  if (extent == Extent::segment) consider(first.b, second, Extent::segment);
  consider(second.a, first, extent), consider(second.b, first, extent);
  return quotient(least.numerator, least.denominator);
}

Point2<Rational> point_at(const Segment2<Integer>& shape, const Rational& t) {
  const auto coordinate = [&t](const Integer& from, const Integer& to) {
    const Integer extent(to - from);
    Rational result(t * extent);
    result.get_num() += from * result.get_den();  // no common factor comes in
    return result;
  };
  return {coordinate(shape.a.x, shape.b.x), coordinate(shape.a.y, shape.b.y)};
}

Rational halfway(const Vector2<Integer>& normal, const Segment2<Integer>& first, Extent extent,
                 const Segment2<Integer>& second) {
  const auto level = [&](const Point2<Integer>& p) { return Integer(normal.x * p.x + normal.y * p.y); };
  Integer below = level(first.a);
  if (extent == Extent::segment) below = std::max(below, level(first.b));
  const Integer above = std::min(level(second.a), level(second.b));
  return quotient(Integer(below + above), Integer(2));
}

}  // namespace touchstone::oracle
