// SPDX-License-Identifier: Apache-2.0
#include "robust/kernel/solids/solid_distance.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <vector>

#include "robust/kernel/enclosed/enclosed_nearest.h"
#include "robust/kernel/integers/rounding.h"
#include "robust/kernel/minkowski/difference_faces.h"
#include "robust/kernel/shapes/lowest_vertices.h"
#include "robust/kernel/shapes/nearest_to_origin.h"
#include "robust/kernel/solids/common_point.h"

namespace touchstone::robust::kernel {
namespace {

using IntegerVector = Vector3<mpz_class>;

/// Scaled near enough to 1 for products of five.
std::vector<Point3d> near_one(const Meshd& mesh, int places) {
  std::vector<Point3d> points = mesh.vertices;
  for (Point3d& p : points) p = {std::ldexp(p.x, -places), std::ldexp(p.y, -places), std::ldexp(p.z, -places)};
  return points;
}

/// Corners whose displacements probably span the point of the difference that is nearest to 0: the distance of Gilbert,
/// Johnson and Keerthi in doubles. Rounding may spoil it; the result is checked.
std::vector<Corners> guessed(const std::vector<Point3d>& points_of_a, const std::vector<Point3d>& points_of_b) {
  std::vector<Corners> corners{{0, 0}};
  std::vector<Vector3d> displacements{points_of_a[0] - points_of_b[0]};
  corners.reserve(4), displacements.reserve(4);
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

using SizedPoint = filters::Triple<filters::Sized<1>>;

/// Calls with_normal(n) for a certain normal from b to a of the parts that these vertices span: a positive multiple of
/// the displacement between their nearest points. False if it is not certain.
template <class Use>
bool with_normal(const std::vector<Point3d>& a, const Used& of_a, const std::vector<Point3d>& b, const Used& of_b,
                 const Use& with) {
  const auto edge = [](const std::vector<Point3d>& points, const Used& used, std::size_t k) {
    return filters::sized_between(points[used.at[0]], points[used.at[k]]);
  };
  const SizedPoint r = filters::sized_between(b[of_b.at[0]], a[of_a.at[0]]);
  const auto sided = [&](const auto& n) {
    const auto height = dot(n, r);
    return height.positive() ? with(n) : height.negative() && with(filters::Triple{-n.x, -n.y, -n.z});
  };
  if (of_a.count + of_b.count == 2) return with(r);
  const SizedPoint v = of_a.count > 1 ? edge(a, of_a, 1) : edge(b, of_b, 1);
  if (of_a.count + of_b.count == 3) {
    const auto length = dot(v, v), foot = dot(r, v);
    return with(filters::Triple{length * r.x - foot * v.x, length * r.y - foot * v.y, length * r.z - foot * v.z});
  }
  const SizedPoint w = of_a.count == 3 ? edge(a, of_a, 2) : of_b.count == 3 ? edge(b, of_b, 2) : edge(b, of_b, 1);
  return sided(cross(v, w));
}

/// True if the displacements of four guessed corners certainly span a tetrahedron around the origin: the volumes that
/// it spans with each face are signed alike. So the hulls have a common point.
bool certainly_meeting(const Meshd& a, const Meshd& b, const std::vector<Corners>& corners) {
  if (corners.size() != 4) return false;
  const auto at = [&](std::size_t k) {
    return filters::sized_between(b.vertices[corners[k].of_b], a.vertices[corners[k].of_a]);
  };
  const auto volume = [&](std::size_t i, std::size_t j, std::size_t k) { return dot(at(i), cross(at(j), at(k))); };
  const auto first = volume(1, 2, 3), second = volume(0, 3, 2), third = volume(0, 1, 3), fourth = volume(0, 2, 1);
  return (first.positive() && second.positive() && third.positive() && fourth.positive()) ||
         (first.negative() && second.negative() && third.negative() && fourth.negative());
}

/// The answer, if certain signs tell that the guessed corners span the nearest parts of the solids, with nearest points
/// in their interiors, that are the only ones, and all numbers are certain; or that they meet. The coordinates are
/// `moderate`.
Perhaps<ConvexDistance<double>> certain_distance(const Meshd& a, const Meshd& b, const std::vector<Corners>& corners) {
  if (certainly_meeting(a, b, corners)) return ConvexDistance<double>{ConvexRelation::meeting, {}, {}, 0, 0};
  Used of_a, of_b;
  for (const auto& [i, j] : corners)
    if (!of_a.add(i) || !of_b.add(j)) return std::nullopt;
  if (of_a.count + of_b.count > 4) return std::nullopt;
  const auto at = [](const Meshd& mesh, const Used& used, std::size_t k) { return mesh.vertices[used.at[k]]; };
  const auto triangle = [&](const Meshd& m, const Used& u) {
    return Triangle3d{at(m, u, 0), at(m, u, 1), at(m, u, 2)};
  };
  const auto segment = [&](const Meshd& m, const Used& u) { return Segment3d{at(m, u, 0), at(m, u, 1)}; };
  const auto parts = [&](const Meshd& m, const Used& u, const Meshd& n, const Used& w) -> filters::Parts {
    const Point3d p = at(n, w, 0);
    if (u.count == 1) return {filters::Part::corner(at(m, u, 0)), filters::Part::corner(p)};
    if (u.count == 3) return filters::nearest_parts(triangle(m, u), p);
    return w.count == 1 ? filters::nearest_parts(segment(m, u), p)
                        : filters::nearest_parts(segment(m, u), segment(n, w));
  };
  const bool turned = of_a.count < of_b.count;
  filters::Parts found = turned ? parts(b, of_b, a, of_a) : parts(a, of_a, b, of_b);
  if (turned) std::swap(found.of_a, found.of_b);
  if (found.of_a.corners != static_cast<int>(of_a.count) || found.of_b.corners != static_cast<int>(of_b.count))
    return std::nullopt;
  const auto separates = [&](const auto& n) {
    return alone(a.vertices, of_a, n) && alone(b.vertices, of_b, filters::Triple{-n.x, -n.y, -n.z});
  };
  if (!with_normal(a.vertices, of_a, b.vertices, of_b, separates)) return std::nullopt;
  const auto pair = closest_pair(found);
  if (!pair) return std::nullopt;
  const auto& [on_a, on_b, square, distance] = *pair;
  return ConvexDistance<double>{ConvexRelation::apart, on_a, on_b, square, distance};
}

/// For numbers of any size.
std::vector<Corners> guessed_near_one(const Meshd& a, const Meshd& b) {
  double greatest = 0;
  for (const Meshd* mesh : {&a, &b}) {
    for (const Point3d& p : mesh->vertices)
      greatest = std::max({greatest, __builtin_fabs(p.x), __builtin_fabs(p.y), __builtin_fabs(p.z)});
  }
  const int places = greatest > 0 ? std::ilogb(greatest) : 0;
  return guessed(near_one(a, places), near_one(b, places));
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

bool moderate_pair(const Meshd& a, const Meshd& b) { return all_moderate(a) && all_moderate(b); }

std::vector<Corners> guessed(const Meshd& a, const Meshd& b) {
  return moderate_pair(a, b) ? guessed(a.vertices, b.vertices) : guessed_near_one(a, b);
}

/// The nearest parts, and all vertices on their levels; no vertices if the hulls meet.
struct NearestLevels {
  Nearest nearest;
  std::vector<Index> of_a, of_b;
};

/// The displacement gets shorter with each vertex found beyond it, and there are finitely many sets of corners.
NearestLevels nearest_levels(const Meshd& a, const Meshd& b, std::vector<Corners> corners) {
  for (;;) {
    Nearest nearest = nearest_of(a, b, corners);
    const IntegerVector against = mpz_class(-1) * nearest.normal;
    if (sgn(dot(nearest.normal, nearest.normal)) == 0) return {std::move(nearest), {}, {}};
    std::vector<Index> of_a, of_b;
    for (const auto& [i, j] : nearest.corners) of_a.push_back(i), of_b.push_back(j);
    auto lowest = lowest_vertices(a.vertices, level(nearest.on_a, of_a, nearest.normal), nearest.normal);
    auto highest = lowest_vertices(b.vertices, level(nearest.on_b, of_b, against), against);
    const auto on_level = [](const std::vector<Index>& found, const std::vector<Index>& used) {
      return std::all_of(used.begin(), used.end(),
                         [&](Index k) { return std::find(found.begin(), found.end(), k) != found.end(); });
    };
    if (on_level(lowest, of_a) && on_level(highest, of_b))
      return {std::move(nearest), std::move(lowest), std::move(highest)};
    corners = std::move(nearest.corners), corners.push_back({lowest[0], highest[0]});
  }
}

ConvexDistance<double> exact_distance(const Meshd& a, const Meshd& b, std::vector<Corners> corners) {
  const auto [nearest, of_a, of_b] = nearest_levels(a, b, std::move(corners));
  if (of_a.empty()) return {ConvexRelation::meeting, {}, {}, 0, 0};
  return answer_of(a, of_a, b, of_b, nearest);
}

/// 0, or of a magnitude in [2^-30, 1]: `moderate`. NaN if the greatest is not finite, or 0.
filters::Sized<0> share(double part, double greatest) {
  const double found = part / greatest, size = filters::FloatFormat<double>::magnitude(found);
  return size < 0x1p-30 ? filters::Sized<0>{0, 0} : filters::Sized<0>{found, size};
}

/// True if the points that these weights of corners give are certainly nearer to each other than the reach. Whatever
/// the weights are, none is negative: they give a point of each hull.
bool certainly_near(const Meshd& a, const Meshd& b, const std::vector<Corners>& corners,
                    const std::array<double, 4>& weights, double reach) {
  const double greatest = *std::max_element(weights.begin(), weights.end());
  const auto weight = [&](std::size_t k) { return share(weights[k], greatest); };
  const auto way = [&](std::size_t k) {
    const auto [i, j] = corners[std::min(k, corners.size() - 1)];
    const auto [x, y, z] = filters::sized_between(b.vertices[j], a.vertices[i]);
    return filters::Triple{weight(k) * x, weight(k) * y, weight(k) * z};
  };
  const auto sum = [](const auto& v, const auto& w) { return filters::Triple{v.x + w.x, v.y + w.y, v.z + w.z}; };
  const auto whole = sum(sum(way(0), way(1)), sum(way(2), way(3)));
  const auto most = filters::Sized<0>{reach, reach} * ((weight(0) + weight(1)) + (weight(2) + weight(3)));
  return (most * most - dot(whole, whole)).positive();
}

/// True if the hull of a is certainly farther than the reach from that of b, along a direction from b to a.
bool certainly_apart(const Meshd& a, const Meshd& b, const Vector3d& direction, double reach) {
  const auto size = [](double x) { return filters::FloatFormat<double>::magnitude(x); };
  const double greatest = std::max({size(direction.x), size(direction.y), size(direction.z)});
  const filters::Triple n{share(direction.x, greatest), share(direction.y, greatest), share(direction.z, greatest)};
  const filters::Sized<0> r{reach, reach};
  const auto least = r * r * dot(n, n);
  return std::all_of(b.vertices.begin(), b.vertices.end(), [&](const Point3d& q) {
    return std::all_of(a.vertices.begin(), a.vertices.end(), [&](const Point3d& p) {
      const auto height = dot(n, filters::sized_between(q, p));
      return height.positive() && (height * height - least).positive();
    });
  });
}

}  // namespace

Perhaps<ConvexDistance<double>> certain_distance(const Meshd& a, const Meshd& b) {
  if (!moderate_pair(a, b)) return std::nullopt;
  return certain_distance(a, b, guessed(a.vertices, b.vertices));
}

ConvexDistance<double> exact_distance(const Meshd& a, const Meshd& b) { return exact_distance(a, b, guessed(a, b)); }

ConvexDistance<double> distance_of_solids(const Meshd& a, const Meshd& b) {
  if (!moderate_pair(a, b)) return exact_distance(a, b, guessed_near_one(a, b));
  std::vector<Corners> corners = guessed(a.vertices, b.vertices);
  const auto certain = certain_distance(a, b, corners);
  return certain ? *certain : exact_distance(a, b, std::move(corners));
}

Separation separation_of_solids(const Meshd& a, const Meshd& b) {
  const auto [nearest, of_a, of_b] = nearest_levels(a, b, guessed(a, b));
  return {weighted(nearest, nearest.on_a) - weighted(nearest, nearest.on_b), nearest.total, nearest.exponent, of_a,
          of_b};
}

/// A guess, and certain signs that prove it. All products are of `moderate` numbers, of four at most. Where points of
/// the core and the solid are nearer than the radius, which then is not 0, so are points of the solid's interior.
Perhaps<Contact> certain_contact(const Meshd& core, double radius, const Meshd& solid) {
  if (!filters::moderate(radius) || !moderate_pair(core, solid)) return std::nullopt;
  const std::vector<Corners> corners = guessed(core.vertices, solid.vertices);
  std::vector<Vector3d> displacements;
  for (const auto& [i, j] : corners) displacements.push_back(core.vertices[i] - solid.vertices[j]);
  const auto nearest = nearest_to_origin(displacements);
  if (!nearest) return std::nullopt;
  if (certainly_near(core, solid, corners, nearest->weights, radius)) return Contact::overlapping;
  if (certainly_apart(core, solid, nearest->normal, radius)) return Contact::disjoint;
  return std::nullopt;
}

/// No distance is less than the radius 0, so that the lack of an interior needs no special case.
Contact exact_contact(const Meshd& core, double radius, const Meshd& solid) {
  const Separation found = separation_of_solids(core, solid);
  const auto [at, exponent] = integers_of(radius);
  const int unit = std::min(found.exponent, exponent);
  const mpz_class reach = at[0] << static_cast<std::uint64_t>(exponent - unit),
                  square = dot(found.displacement, found.displacement)
                           << static_cast<std::uint64_t>(2 * (found.exponent - unit));
  return contact({square, mpz_class(found.total * found.total)}, reach, true);
}

}  // namespace touchstone::robust::kernel
