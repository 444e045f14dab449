// SPDX-License-Identifier: Apache-2.0
#include "oracle/volumes/aabb_of_points.h"

#include <algorithm>
#include <numeric>
#include <utility>

#include "oracle/exact/decode.h"
#include "oracle/exact/rational_validation.h"

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

/// The places of the least number and of the greatest.
std::pair<std::size_t, std::size_t> ends(const Column& numbers) {
  std::vector<std::size_t> order(numbers.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::stable_sort(order.begin(), order.end(), [&](std::size_t i, std::size_t j) { return numbers[i] < numbers[j]; });
  return {order.front(), order.back()};
}

/// The ends on each axis; refuses what is not valid.
template <class Points>
std::vector<std::pair<Rational, Rational>> extents(const Points& points) {
  validation::validate_points("points", points);
  std::vector<std::pair<Rational, Rational>> found;
  for (const Column& numbers : columns(points)) {
    const auto [first, last] = ends(numbers);
    found.emplace_back(numbers[first], numbers[last]);
  }
  return found;
}

template <class Number>
Truth<Aabb2<Rational>> truth(const std::vector<Point2<Number>>& points) {
  const auto e = extents(points);
  return {{{e[0].first, e[1].first}, {e[0].second, e[1].second}}, std::nullopt};
}
template <class Number>
Truth<Aabb3<Rational>> truth(const std::vector<Point3<Number>>& points) {
  const auto e = extents(points);
  return {{{e[0].first, e[1].first, e[2].first}, {e[0].second, e[1].second, e[2].second}}, std::nullopt};
}

template <class Points>
Certificate certificate(const Points& points) {
  validation::validate_points("points", points);
  std::vector<Rational> least, greatest;
  for (const Column& numbers : columns(points)) {
    const auto [first, last] = ends(numbers);
    least.emplace_back(first), greatest.emplace_back(last);
  }
  return {"extreme_points", {{"least", std::move(least)}, {"greatest", std::move(greatest)}}};
}

}  // namespace

Truth<Aabb2<Rational>> aabb_of_points(const std::vector<Point2d>& points) { return truth(points); }
Truth<Aabb3<Rational>> aabb_of_points(const std::vector<Point3d>& points) { return truth(points); }

template <Exact Number>
Truth<Aabb2<Rational>> aabb_of_points(const std::vector<Point2<Number>>& points) {
  return truth(points);
}
template <Exact Number>
Truth<Aabb3<Rational>> aabb_of_points(const std::vector<Point3<Number>>& points) {
  return truth(points);
}
template Truth<Aabb2<Rational>> aabb_of_points(const std::vector<Point2<Rational>>&);
template Truth<Aabb3<Rational>> aabb_of_points(const std::vector<Point3<Rational>>&);

Certificate aabb_of_points_certificate(const std::vector<Point2d>& points) { return certificate(points); }
Certificate aabb_of_points_certificate(const std::vector<Point3d>& points) { return certificate(points); }

}  // namespace touchstone::oracle
