// SPDX-License-Identifier: Apache-2.0
#include "oracle/exact/systems/common_points.h"

#include <algorithm>

#include "oracle/exact/systems/linear_program.h"

namespace touchstone::oracle {
namespace {

Wide as_product(Int128 value) { return product(value, 1); }
const Integer& as_product(const Integer& value) { return value; }

}  // namespace

/// Lengths are not negative, so neither are these products.
bool operator<(const SquaredLength<Integer>& p, const SquaredLength<Integer>& q) {
  return Integer(p.numerator * q.denominator) < Integer(q.numerator * p.denominator);
}

bool operator<(const SquaredLength<Int128>& p, const SquaredLength<Int128>& q) {
  if (p.denominator == q.denominator) return p.numerator < q.numerator;
  const auto times = [](const Wide& a, Int128 b, std::uint64_t(&result)[6]) {
    const auto b0 = static_cast<std::uint64_t>(b), b1 = static_cast<std::uint64_t>(b >> 64);
    const auto high = static_cast<UInt128>(a.high);
    const std::uint64_t limbs[4] = {static_cast<std::uint64_t>(a.low), static_cast<std::uint64_t>(a.low >> 64),
                                    static_cast<std::uint64_t>(high), static_cast<std::uint64_t>(high >> 64)};
    UInt128 carry = 0;
    for (int i = 0; i < 4; ++i)
      carry += UInt128{limbs[i]} * b0, result[i] = static_cast<std::uint64_t>(carry), carry >>= 64;
    result[4] = static_cast<std::uint64_t>(carry), result[5] = 0, carry = 0;
    for (int i = 0; i < 4; ++i) {
      carry += UInt128{limbs[i]} * b1 + result[i + 1];
      result[i + 1] = static_cast<std::uint64_t>(carry), carry >>= 64;
    }
    result[5] = static_cast<std::uint64_t>(carry);
  };
  std::uint64_t one[6], other[6];
  times(p.numerator, q.denominator, one), times(q.numerator, p.denominator, other);
  return std::lexicographical_compare(std::rbegin(one), std::rend(one), std::rbegin(other), std::rend(other));
}

template <class Value>
CommonPoints<Value>::CommonPoints(const Segment2<Value>& first_shape, Extent extent,
                                  const Segment2<Value>& second_shape) {
  using Program = LinearProgram<Value>;
  const auto equal = Program::Row::equal, at_most = Program::Row::at_most;
  static const std::vector<typename Program::Row> ray_rows{equal, equal, at_most};
  static const std::vector<typename Program::Row> segment_rows{equal, equal, at_most, at_most};
  const Vector2<Value> u = first_shape.b - first_shape.a, v = second_shape.a - second_shape.b;
  const Vector2<Value> w = second_shape.a - first_shape.a;
  Program program(2, extent == Extent::ray ? ray_rows : segment_rows);
  program.set_coefficient(0, 0, u.x), program.set_coefficient(1, 0, u.y);
  program.set_coefficient(0, 1, v.x), program.set_coefficient(1, 1, v.y);
  program.set_right_side(0, w.x), program.set_right_side(1, w.y);
  program.set_coefficient(2, 1, Value(1)), program.set_right_side(2, Value(1));
  if (extent == Extent::segment) program.set_coefficient(3, 0, Value(1)), program.set_right_side(3, Value(1));

  any = program.feasible();
  if (!any) {  // the Farkas vector holds the first shape above the second
    normal = {Value(-program.farkas()[0]), Value(-program.farkas()[1])};
    return;
  }
  const auto parameter = [&](int variable) {
    return Fraction<Value>{program.numerator(variable), program.denominator()};
  };
  static const std::vector<Value> least{Value(1), Value(0)}, greatest{Value(-1), Value(0)};
  program.minimise(least);
  first = parameter(0), second_at_first = parameter(1);
  // On a first shape of length zero every parameter is the same point; the least one, 0, speaks for it.
  if (sgn(u.x) != 0 || sgn(u.y) != 0) program.minimise(greatest);
  last = parameter(0), second_at_last = parameter(1);
  extended = product(first.numerator, last.denominator) < product(last.numerator, first.denominator);
}

template <class Value>
SquaredLength<Value> squared_distance(const Point2<Value>& point, const Segment2<Value>& shape, Extent extent) {
  const Vector2<Value> v = shape.b - shape.a, w = point - shape.a;
  const Value along = dot(v, w), length = dot(v, v);
  if (sgn(along) <= 0) return {as_product(dot(w, w)), Value(1)};
  if (extent == Extent::segment && along >= length) {
    const Vector2<Value> beyond = point - shape.b;
    return {as_product(dot(beyond, beyond)), Value(1)};
  }
  const Value area = cross(v, w);
  return {product(area, area), length};
}

template <class Value>
Rational least_end_distance(const Segment2<Value>& first, Extent extent, const Segment2<Value>& second) {
  SquaredLength<Value> least = squared_distance(first.a, second, Extent::segment);
  const auto consider = [&](const Point2<Value>& end, const Segment2<Value>& shape, Extent reach) {
    SquaredLength<Value> other = squared_distance(end, shape, reach);
    if (other < least) least = std::move(other);
  };
  if (extent == Extent::segment) consider(first.b, second, Extent::segment);
  consider(second.a, first, extent), consider(second.b, first, extent);
  return quotient(least.numerator, least.denominator);
}

template <class Value>
Point2<Rational> point_at(const Segment2<Value>& shape, const Rational& t) {
  // from + t (to - from), t = p/q: what p and q have not in common, only to - from and q can.
  const auto coordinate = [&t](const Value& from, const Value& to) {
    const Value difference(to - from);
    Rational result;
    mpz_ptr above = result.get_num_mpz_t(), below = result.get_den_mpz_t();
    mpz_gcd(below, view(difference), t.get_den_mpz_t());
    mpz_divexact(above, view(difference), below);
    mpz_divexact(below, t.get_den_mpz_t(), below);
    mpz_mul(above, above, t.get_num_mpz_t());
    mpz_addmul(above, view(from), below);
    return result;
  };
  return {coordinate(shape.a.x, shape.b.x), coordinate(shape.a.y, shape.b.y)};
}

template <class Value>
Rational halfway(const Vector2<Value>& normal, const Segment2<Value>& first, Extent extent,
                 const Segment2<Value>& second) {
  const Rational x = rational(normal.x), y = rational(normal.y);
  const auto level = [&](const Point2<Value>& p) { return Rational(x * rational(p.x) + y * rational(p.y)); };
  Rational below = level(first.a);
  if (extent == Extent::segment) below = std::max(below, level(first.b));
  const Rational above = std::min(level(second.a), level(second.b));
  return Rational((below + above) / 2);
}

template struct CommonPoints<Int128>;
template struct CommonPoints<Integer>;
template SquaredLength<Int128> squared_distance(const Point2<Int128>&, const Segment2<Int128>&, Extent);
template SquaredLength<Integer> squared_distance(const Point2<Integer>&, const Segment2<Integer>&, Extent);
template Rational least_end_distance(const Segment2<Int128>&, Extent, const Segment2<Int128>&);
template Rational least_end_distance(const Segment2<Integer>&, Extent, const Segment2<Integer>&);
template Rational halfway(const Vector2<Int128>&, const Segment2<Int128>&, Extent, const Segment2<Int128>&);
template Rational halfway(const Vector2<Integer>&, const Segment2<Integer>&, Extent, const Segment2<Integer>&);
template Point2<Rational> point_at(const Segment2<Int128>&, const Rational&);
template Point2<Rational> point_at(const Segment2<Integer>&, const Rational&);

}  // namespace touchstone::oracle
