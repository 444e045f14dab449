// SPDX-License-Identifier: Apache-2.0
#include "oracle/volumes/aabb_of_points.h"

#include <algorithm>
#include <numeric>
#include <utility>

#include "geometry/validation.h"
#include "oracle/exact/numbers/decode.h"

namespace touchstone::oracle {
namespace {

/// A coordinate of all points.
using Column = std::vector<Rational>;

template <class Number>
std::vector<Column> columns(const std::vector<Point2<Number>>& points) {
  std::vector<Column> all(2);
  for (const auto& [x, y] : points) all[0].push_back(exact(x)), all[1].push_back(exact(y));
  return all;
}
template <class Number>
std::vector<Column> columns(const std::vector<Point3<Number>>& points) {
  std::vector<Column> all(3);
  for (const auto& [x, y, z] : points)
    all[0].push_back(exact(x)), all[1].push_back(exact(y)), all[2].push_back(exact(z));
  return all;
}

/// The indices of the least number and of the greatest.
std::pair<std::size_t, std::size_t> ends(const Column& numbers) {
  std::vector<std::size_t> order(numbers.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::stable_sort(order.begin(), order.end(), [&](std::size_t i, std::size_t j) { return numbers[i] < numbers[j]; });
  return {order.front(), order.back()};
}

struct Extents {
  std::vector<Rational> low, high;  ///< by axis
  std::function<Certificate()> certificate;
};

/// Refuses invalid input.
template <class Points>
Extents extents(const Points& points) {
  validation::validate("points", points, rule::points);
  Extents found;
  std::vector<std::size_t> least, greatest;
  for (const Column& numbers : columns(points)) {
    const auto [first, last] = ends(numbers);
    found.low.push_back(numbers[first]), found.high.push_back(numbers[last]);
    least.push_back(first), greatest.push_back(last);
  }
  found.certificate = [least = std::move(least), greatest = std::move(greatest)] {
    return Certificate{"extreme_points",
                       {{"least", {least.begin(), least.end()}}, {"greatest", {greatest.begin(), greatest.end()}}}};
  };
  return found;
}

}  // namespace

template <Exact Number>
Truth<Aabb2<Rational>> aabb_of_points(const std::vector<Point2<Number>>& points) {
  auto [low, high, certificate] = extents(points);
  return {{{low[0], low[1]}, {high[0], high[1]}}, std::nullopt, std::move(certificate)};
}
template <Exact Number>
Truth<Aabb3<Rational>> aabb_of_points(const std::vector<Point3<Number>>& points) {
  auto [low, high, certificate] = extents(points);
  return {{{low[0], low[1], low[2]}, {high[0], high[1], high[2]}}, std::nullopt, std::move(certificate)};
}
template Truth<Aabb2<Rational>> aabb_of_points(const std::vector<Point2d>&);
template Truth<Aabb3<Rational>> aabb_of_points(const std::vector<Point3d>&);
template Truth<Aabb2<Rational>> aabb_of_points(const std::vector<Point2<Rational>>&);
template Truth<Aabb3<Rational>> aabb_of_points(const std::vector<Point3<Rational>>&);

}  // namespace touchstone::oracle
