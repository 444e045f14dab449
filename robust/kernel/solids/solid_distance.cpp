// SPDX-License-Identifier: Apache-2.0
#include "robust/kernel/solids/solid_distance.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <vector>

#include "robust/kernel/integers/rounding.h"
#include "robust/kernel/shapes/lowest_vertices.h"
#include "robust/kernel/shapes/nearest_to_origin.h"
#include "robust/kernel/solids/common_point.h"

namespace touchstone::robust::kernel {
namespace {

using IntegerVector = Vector3<mpz_class>;

/// A vertex of a and one of b: the displacement from the second to the first is a point of their Minkowski difference.
struct Corners {
  Index of_a, of_b;
  friend bool operator==(const Corners&, const Corners&) = default;
};

/// Scaled near enough to 1 for products of five.
std::vector<Point3d> near_one(const Meshd& mesh, int places) {
  std::vector<Point3d> points = mesh.vertices;
  if (std::abs(places) < 60) return points;
  for (Point3d& p : points) p = {std::ldexp(p.x, -places), std::ldexp(p.y, -places), std::ldexp(p.z, -places)};
  return points;
}

Index lowest(const std::vector<Point3d>& points, const Vector3d& direction) {
  Index found = 0;
  double least = dot(direction, points[0] - Point3d{0, 0, 0});
  for (Index i = 1; i < points.size(); ++i) {
    const double height = dot(direction, points[i] - Point3d{0, 0, 0});
    if (height < least) least = height, found = i;
  }
  return found;
}

/// Corners whose displacements probably span the point of the difference that is nearest to 0: the distance of Gilbert,
/// Johnson and Keerthi in doubles. Rounding may spoil it; the result is checked.
std::vector<Corners> guessed(const Meshd& a, const Meshd& b) {
  double greatest = 0;
  for (const Meshd* mesh : {&a, &b}) {
    for (const Point3d& p : mesh->vertices)
      greatest = std::max({greatest, __builtin_fabs(p.x), __builtin_fabs(p.y), __builtin_fabs(p.z)});
  }
  const int places = greatest > 0 ? std::ilogb(greatest) : 0;
  const std::vector<Point3d> points_of_a = near_one(a, places), points_of_b = near_one(b, places);
  std::vector<Corners> corners{{0, 0}};
  std::vector<Vector3d> displacements{points_of_a[0] - points_of_b[0]};
  Vector3d normal = displacements[0];
  for (int step = 0; step < 64; ++step) {
    const Corners next{lowest(points_of_a, normal), lowest(points_of_b, -1.0 * normal)};
    const Vector3d displacement = points_of_a[next.of_a] - points_of_b[next.of_b];
    if (!(dot(normal, displacement - displacements[0]) < 0) ||
        std::find(corners.begin(), corners.end(), next) != corners.end())
      break;
    displacements.push_back(displacement);
    const auto nearest = nearest_to_origin(displacements);
    if (!nearest) break;
    corners.push_back(next);
    std::size_t kept = 0;
    for (std::size_t k = 0; k < displacements.size(); ++k)
      if (nearest->weights[k] > 0) displacements[kept] = displacements[k], corners[kept++] = corners[k];
    displacements.resize(kept), corners.resize(kept), normal = nearest->normal;
    if (kept == 4) break;
  }
  return corners;
}

/// Corners with positive weights only, in integers times 2^exponent.
struct Nearest {
  std::vector<Corners> corners;
  std::vector<mpz_class> weights;
  std::vector<IntegerPoint> on_a, on_b;
  mpz_class total;
  IntegerVector normal;
  int exponent;
};

Nearest nearest_of(const Meshd& a, const Meshd& b, const std::vector<Corners>& corners) {
  Polygon3d used;
  for (const auto& [i, j] : corners) used.vertices.push_back(a.vertices[i]), used.vertices.push_back(b.vertices[j]);
  const auto [at, exponent] = integers_of(used);
  std::vector<IntegerVector> displacements;
  for (std::size_t k = 0; k < corners.size(); ++k) displacements.push_back(at[2 * k] - at[2 * k + 1]);
  const auto found = nearest_to_origin(displacements).value();
  Nearest nearest{{}, {}, {}, {}, found.total, found.normal, exponent};
  for (std::size_t k = 0; k < corners.size(); ++k) {
    if (sgn(found.weights[k]) == 0) continue;
    nearest.corners.push_back(corners[k]), nearest.weights.push_back(found.weights[k]);
    nearest.on_a.push_back(at[2 * k]), nearest.on_b.push_back(at[2 * k + 1]);
  }
  return nearest;
}

/// The distinct indices of the points that are lowest along the direction.
std::vector<Index> level(const std::vector<IntegerPoint>& points, const std::vector<Index>& indices,
                         const IntegerVector& direction) {
  std::vector<Index> found{indices[0]};
  std::size_t lowest = 0;
  for (std::size_t k = 1; k < points.size(); ++k) {
    const int side = sgn(dot(direction, points[k] - points[lowest]));
    if (side < 0) lowest = k, found.clear();
    if (side <= 0 && std::find(found.begin(), found.end(), indices[k]) == found.end()) found.push_back(indices[k]);
  }
  return found;
}

IntegerPoint weighted(const Nearest& nearest, const std::vector<IntegerPoint>& points) {
  IntegerPoint sum{0, 0, 0};
  for (std::size_t k = 0; k < points.size(); ++k)
    sum = sum + nearest.weights[k] * IntegerVector{points[k].x, points[k].y, points[k].z};
  return sum;
}

/// One point, or two edges that are not parallel.
bool is_unique(const Meshd& a, const std::vector<Index>& of_a, const Meshd& b, const std::vector<Index>& of_b) {
  if (of_a.size() == 1 || of_b.size() == 1) return true;
  if (of_a.size() > 2 || of_b.size() > 2) return false;
  const auto at = integer_points(a.vertices[of_a[0]], a.vertices[of_a[1]], b.vertices[of_b[0]], b.vertices[of_b[1]]).at;
  const IntegerVector across = cross(at[1] - at[0], at[3] - at[2]);
  return sgn(across.x) != 0 || sgn(across.y) != 0 || sgn(across.z) != 0;
}

/// The displacement between the points found, in units of 1 / whole: it moves b until it meets a in all nearest points.
QuotientPoint first_of_many(const Meshd& a, const std::vector<Index>& of_a, const Meshd& b,
                            const std::vector<Index>& of_b, const Nearest& nearest, const IntegerVector& displacement,
                            int& exponent) {
  Polygon3d all{{a.vertices[0]}};
  for (const Index i : of_a) all.vertices.push_back(a.vertices[i]);
  for (const Index j : of_b) all.vertices.push_back(b.vertices[j]);
  auto points = integers_of(all);
  const auto down = [](int from, int to) { return mpz_class(mpz_class(1) << static_cast<std::uint64_t>(from - to)); };
  exponent = std::min(points.exponent, nearest.exponent);
  const mpz_class unit = nearest.total * down(points.exponent, exponent);
  const IntegerVector moved = down(nearest.exponent, exponent) * displacement;
  for (auto& p : points.at) p = {unit * p.x, unit * p.y, unit * p.z};
  const auto middle = points.at.begin() + 1 + static_cast<std::ptrdiff_t>(of_a.size());
  std::vector<IntegerPoint> first(points.at.begin() + 1, middle), second(middle, points.at.end());
  for (auto& p : second) p = p + moved;
  QuotientPoint found = nearest_common_point(std::move(first), std::move(second), nearest.normal, points.at[0]);
  found.d *= nearest.total;
  return found;
}

ConvexDistance<double> answer_of(const Meshd& a, const std::vector<Index>& of_a, const Meshd& b,
                                 const std::vector<Index>& of_b, const Nearest& nearest) {
  const IntegerPoint on_a = weighted(nearest, nearest.on_a), on_b = weighted(nearest, nearest.on_b);
  const IntegerVector displacement = on_a - on_b;
  const mpz_class square = dot(displacement, displacement), unit = nearest.total * nearest.total;
  const int twice = 2 * nearest.exponent;
  ConvexDistance<double> answer{
      ConvexRelation::apart, {}, {}, round_quotient(square, unit, twice), round_square_root(square, unit, twice)};
  if (is_unique(a, of_a, b, of_b)) {
    answer.on_a = rounded({on_a, nearest.total}, nearest.exponent);
    answer.on_b = rounded({on_b, nearest.total}, nearest.exponent);
    return answer;
  }
  int exponent = 0;
  const QuotientPoint first = first_of_many(a, of_a, b, of_b, nearest, displacement, exponent);
  // first.d is a multiple of `whole`, in units of which the displacement is given.
  const mpz_class parts = (first.d / nearest.total) << static_cast<std::uint64_t>(nearest.exponent - exponent);
  answer.on_a = rounded(first, exponent);
  answer.on_b = rounded({first.n + mpz_class(-parts) * displacement, first.d}, exponent);
  return answer;
}

}  // namespace

/// The displacement gets shorter with each vertex found beyond it, and there are finitely many sets of corners.
ConvexDistance<double> distance_of_solids(const Meshd& a, const Meshd& b) {
  std::vector<Corners> corners = guessed(a, b);
  for (;;) {
    Nearest nearest = nearest_of(a, b, corners);
    const IntegerVector against = mpz_class(-1) * nearest.normal;
    if (sgn(dot(nearest.normal, nearest.normal)) == 0) return {ConvexRelation::meeting, {}, {}, 0, 0};
    std::vector<Index> of_a, of_b;
    for (const auto& [i, j] : nearest.corners) of_a.push_back(i), of_b.push_back(j);
    const auto lowest = lowest_vertices(a.vertices, level(nearest.on_a, of_a, nearest.normal), nearest.normal);
    const auto highest = lowest_vertices(b.vertices, level(nearest.on_b, of_b, against), against);
    const auto on_level = [](const std::vector<Index>& found, const std::vector<Index>& used) {
      return std::all_of(used.begin(), used.end(),
                         [&](Index k) { return std::find(found.begin(), found.end(), k) != found.end(); });
    };
    if (on_level(lowest, of_a) && on_level(highest, of_b)) return answer_of(a, lowest, b, highest, nearest);
    corners = std::move(nearest.corners), corners.push_back({lowest[0], highest[0]});
  }
}

}  // namespace touchstone::robust::kernel
