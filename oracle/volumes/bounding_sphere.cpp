// SPDX-License-Identifier: Apache-2.0
#include "oracle/volumes/bounding_sphere.h"

#include <algorithm>
#include <cstdint>
#include <cstdio>
#include <limits>
#include <utility>

#include "geometry/validation.h"
#include "oracle/exact/numbers/nearest_double.h"
#include "oracle/exact/numbers/space.h"
#include "oracle/exact/numbers/wide.h"
#include "oracle/exact/shapes/enclosing_ball.h"
#include "oracle/exact/shapes/whole_list.h"

namespace touchstone::oracle {
namespace {

/// The points in units.
struct Counted {
  IntegerPoints points;
  Rational unit;

  /// n / d units
  Rational actual(const Integer& n, const Integer& d) const {
    Rational value(n, d);
    value.canonicalize();
    return Rational(value * unit);
  }
  Point3<Rational> actual(const Point3<Integer>& n, const Integer& d) const {
    return {actual(n.x, d), actual(n.y, d), actual(n.z, d)};
  }
  /// Converts a number in squares of units.
  Rational squared(const Integer& n, const Integer& d) const {
    const Integer square(d * d);
    return Rational(actual(n, square) * unit);
  }
};

/// Keeps the unit as large as possible: points times a power of two have the same integers.
void without_common_twos(IntegerList& list) {
  mp_bitcnt_t twos = ~mp_bitcnt_t{0};
  for (const Integer& n : list.integers)
    if (sgn(n) != 0) twos = std::min(twos, mpz_scan1(n.get_mpz_t(), 0));
  if (twos == ~mp_bitcnt_t{0}) return;  // all are 0
  for (Integer& n : list.integers) n >>= twos;
  list.unit *= Rational(Integer(1) << twos);
}

/// Refuses invalid input.
template <class Number>
Counted counted(const std::vector<Point3<Number>>& points) {
  validation::validate("points", points, rule::points);
  std::vector<Number> numbers;
  for (const auto& p : points) numbers.insert(numbers.end(), {p.x, p.y, p.z});
  IntegerList list = integer_list(numbers);
  without_common_twos(list);
  Counted result{{}, list.unit};
  for (std::size_t i = 0; i < points.size(); ++i)
    result.points.push_back({list.integers[3 * i], list.integers[3 * i + 1], list.integers[3 * i + 2]});
  return result;
}

using Coordinate = Integer Point3<Integer>::*;
template <class OnAxis>
Point3<Integer> by_axis(const OnAxis& on_axis) {
  return {on_axis(&Point3<Integer>::x), on_axis(&Point3<Integer>::y), on_axis(&Point3<Integer>::z)};
}
std::vector<Integer> along(Coordinate axis, const IntegerPoints& points) {
  std::vector<Integer> all;
  for (const auto& p : points) all.push_back(p.*axis);
  return all;
}

/// box, centroid
IntegerBall around_middle(const IntegerPoints& points, SphereMethod method) {
  if (method == SphereMethod::box) {
    const Point3<Integer> twice = by_axis([&points](Coordinate axis) {
      std::vector<Integer> ascending = along(axis, points);
      std::sort(ascending.begin(), ascending.end());
      return Integer(ascending.front() + ascending.back());
    });
    return reaching_farthest(twice, 2, points);
  }
  const Point3<Integer> sum = by_axis([&points](Coordinate axis) {
    Integer total = 0;
    for (const Integer& x : along(axis, points)) total += x;
    return total;
  });
  return reaching_farthest(sum, Integer(static_cast<std::uint64_t>(points.size())), points);
}

/// Binary digits of ritter's ball below the unit: the effect of a point near another, compared with a distant one, is
/// often as small as the square of their ratio.
unsigned digits_below(const IntegerPoints& points) {
  std::size_t most = 0;
  for (const auto& p : points)
    for (const Integer& x : {p.x, p.y, p.z}) most = std::max(most, mpz_sizeinbase(x.get_mpz_t(), 2));
  return 300 + 2 * static_cast<unsigned>(most);
}

Certificate supported(const char* kind, const SmallestBall& ball) {
  const std::vector<Rational> places(ball.support.begin(), ball.support.end());
  std::vector<Rational> weights;
  for (const Integer& weight : ball.weights) weights.push_back(quotient(weight, ball.d));
  return {kind, {{"points", places}, {"weights", weights}}};
}

template <class Number>
Truth<Sphere3<Surd>> truth_of_bounding_sphere(const std::vector<Point3<Number>>& points, SphereMethod method) {
  Counted counted = oracle::counted(points);
  IntegerPoints& integers = counted.points;
  const auto as_surds = [](const Point3<Rational>& p) { return Point3<Surd>{p.x, p.y, p.z}; };
  const auto sphere = [&](const IntegerBall& ball) {
    return Sphere3<Surd>{as_surds(counted.actual(ball.times, ball.d)),
                         sqrt(Surd(counted.squared(ball.square, ball.d)))};
  };
  if (method == SphereMethod::ritter) {
    const unsigned below = digits_below(integers);
    const GrowingBall ball = growing_ball(integers, below);
    const Integer d = Integer(1) << below;
    return {{as_surds(counted.actual(ball.center, d)), Surd(counted.actual(ball.radius, d))},
            std::nullopt,
            [integers = std::move(integers)] { return supported("lower_bound", smallest_ball(integers)); }};
  }
  if (method == SphereMethod::smallest) {
    SmallestBall ball = smallest_ball(integers);
    return {sphere(ball), std::nullopt, [ball = std::move(ball)] { return supported("support", ball); }};
  }
  IntegerBall ball = around_middle(integers, method);
  return {sphere(ball), std::nullopt, [integers = std::move(integers), ball = std::move(ball)] {
            return Certificate{"farthest_point", {{"point", {Rational(ball.farthest(integers))}}}};
          }};
}

Rational power_of_two(int exponent) { return scaled(Rational(1), exponent); }

/// The number of units in the last place by which a ball of this method may be too large.
std::int64_t most_units(SphereMethod method, std::size_t points) {
  const std::int64_t n = static_cast<std::int64_t>(points);
  return method == SphereMethod::centroid ? n + 4 : method == SphereMethod::ritter ? 4 * n + 4 : 4;
}

std::string written(double value) {
  char text[32];
  std::snprintf(text, sizeof text, "%.3g", value);
  return text;
}

/// The point that is farthest outside of the ball, and its distance.
std::string lost(const std::vector<Point3d>& points, const Sphere3d& ball) {
  const Rational radius = exact(ball.radius), square(radius * radius);
  Rational greatest = square;
  std::size_t farthest = 0;
  for (std::size_t i = 0; i < points.size(); ++i) {
    const Vector3<Rational> displacement = exact(points[i]) - exact(ball.center);
    const Rational distance = dot(displacement, displacement);
    if (distance > greatest) greatest = distance, farthest = i;
  }
  if (greatest == square) return "";
  const Surd beyond = sqrt(Surd(greatest)) - Surd(radius);
  const std::string text = "point " + std::to_string(farthest) + " is outside by " + written(nearest_double(beyond));
  if (sgn(radius) == 0) return text;
  const double units = nearest_double(beyond / Surd(power_of_two(ulp_exponent(radius))));
  return text + ", " + written(units) + " units in the last place of the radius";
}

/// "" unless the ball is larger than the contract allows.
std::string too_large(const std::vector<Point3d>& points, SphereMethod method, const Sphere3d& ball) {
  const Counted counted = oracle::counted(points);
  const bool grown = method == SphereMethod::ritter;
  const IntegerBall least =
      grown || method == SphereMethod::smallest ? smallest_ball(counted.points) : around_middle(counted.points, method);
  Rational square = counted.squared(least.square, least.d), coordinate = 0;
  if (grown) square *= Rational(9, 4);
  for (const Point3d& p : points)
    for (const double x : {p.x, p.y, p.z}) coordinate = std::max(coordinate, Rational(abs(exact(x))));
  const Rational radius = exact(ball.radius), units(most_units(method, points.size()));
  const Rational less(radius - units * (power_of_two(ulp_exponent(coordinate)) + power_of_two(ulp_exponent(radius))));
  if (sgn(less) <= 0 || less * less <= square) return "";
  return "the radius is too large, by " + written(nearest_double(Surd(radius) - sqrt(Surd(square))));
}

}  // namespace

template <Exact Number>
Truth<Sphere3<Surd>> bounding_sphere(const std::vector<Point3<Number>>& points, SphereMethod method) {
  return truth_of_bounding_sphere(points, method);
}
template Truth<Sphere3<Surd>> bounding_sphere(const std::vector<Point3d>&, SphereMethod);
template Truth<Sphere3<Surd>> bounding_sphere(const std::vector<Point3<Rational>>&, SphereMethod);

std::string bounding_sphere_defect(const std::vector<Point3d>& points, SphereMethod method, const Sphere3d& ball) {
  const auto& [x, y, z] = ball.center;
  if (!validation::finite(x) || !validation::finite(y) || !validation::finite(z)) return "the center is not finite";
  if (ball.radius != ball.radius || validation::negative(ball.radius)) return "the radius is no number, or negative";
  if (validation::finite(ball.radius)) {
    const std::string outside = lost(points, ball);
    return outside.empty() ? too_large(points, method, ball) : outside;
  }
  const bool needed = !lost(points, {ball.center, std::numeric_limits<double>::max()}).empty();
  return needed ? "" : "the radius is infinite, and a finite one is large enough";
}

}  // namespace touchstone::oracle
