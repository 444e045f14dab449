// SPDX-License-Identifier: Apache-2.0
#include "robust/kernel/solids/nearest_of_faces.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <utility>

#include "robust/kernel/enclosed/enclosed_nearest.h"
#include "robust/kernel/filters/ordered_bits.h"
#include "robust/kernel/shapes/face_part.h"
#include "robust/kernel/shapes/nearest_points.h"

namespace touchstone::robust::kernel {
namespace {

/// Faces that a point may be nearest to, fewer from step to step.
class NearestOfFaces {
 public:
  NearestOfFaces(const Point3d& point, const Meshd& mesh, std::vector<Index> faces)
      : point_(point), mesh_(mesh), faces_(std::move(faces)) {}

  PointMeshDistance<double> found(Stage& latest) {
    latest = std::max(latest, Stage::enclosed);
    if (!in_one_place()) keep_least_rounded();
    if (in_one_place()) {
      if (const auto answer = enclosed(faces_[0])) return *answer;
    } else {
      keep_first_exactly();
    }
    latest = Stage::exact;
    return exact(faces_[0]);
  }

 private:
  Triangle3d triangle(Index face) const {
    const auto& [a, b, c] = mesh_.faces[face];
    return {mesh_.vertices[a], mesh_.vertices[b], mesh_.vertices[c]};
  }
  filters::Parts parts(Index face) const {
    const Triangle3d t = triangle(face);
    if (!(filters::moderate(point_) & filters::moderate(t))) return {};
    return filters::nearest_parts(t, point_);
  }

  /// True if the nearest points of all faces are certainly one: on one edge, at one vertex.
  bool in_one_place() const {
    const filters::Part first = parts(faces_[0]).of_a;
    return faces_.size() == 1 || std::all_of(faces_.begin() + 1, faces_.end(), [&](Index face) {
             const filters::Part other = parts(face).of_a;
             const auto in_first = [&](const Point3d& p) {
               return std::find(first.at.begin(), first.at.begin() + first.corners, p) !=
                      first.at.begin() + first.corners;
             };
             return first.corners > 0 && other.corners == first.corners &&
                    std::all_of(other.at.begin(), other.at.begin() + other.corners, in_first);
           });
  }

  /// Rounding keeps the order of different numbers, or makes them equal.
  void keep_least_rounded() {
    std::vector<std::pair<std::int64_t, Index>> squares;
    std::int64_t least = std::numeric_limits<std::int64_t>::max();
    for (const Index face : faces_) {
      const auto closest = closest_point(parts(face));
      const std::int64_t square = closest ? ordered_bits((*closest).squared_distance) : -1;
      if (closest) least = std::min(least, square);
      squares.emplace_back(square, face);
    }
    faces_.clear();
    for (const auto& [square, face] : squares)
      if (square <= least) faces_.push_back(face);
  }

  /// Keeps the first face that has the first of all nearest points in lexicographic order.
  void keep_first_exactly() {
    Polygon3d corners{{point_}};
    for (const Index face : faces_) {
      const auto& [a, b, c] = triangle(face);
      corners.vertices.insert(corners.vertices.end(), {a, b, c});
    }
    const std::vector<IntegerPoint> at = integers_of(corners).at;
    std::size_t first = 0;
    QuotientPoint nearest;
    Quotient least;
    for (std::size_t i = 0; i < faces_.size(); ++i) {
      QuotientPoint x = nearest_on_triangle(at[0], {at[3 * i + 1], at[3 * i + 2], at[3 * i + 3]});
      Quotient square = squared_distance(x, {at[0], 1});
      const int order = i == 0 ? -1 : cmp(mpz_class(square.n * least.d), mpz_class(least.n * square.d));
      if (order < 0 || (order == 0 && before(x, nearest))) first = i, nearest = std::move(x), least = std::move(square);
    }
    faces_ = {faces_[first]};
  }
  static bool before(const QuotientPoint& p, const QuotientPoint& q) {
    for (mpz_class IntegerPoint::*axis : {&IntegerPoint::x, &IntegerPoint::y, &IntegerPoint::z}) {
      const int order = cmp(mpz_class(p.n.*axis * q.d), mpz_class(q.n.*axis * p.d));
      if (order != 0) return order < 0;
    }
    return false;
  }

  /// An edge is certain only if the third corner is not on its line. A face of more corners may name an edge within a
  /// triangle of its cut, where it runs along a bridge.
  Perhaps<PointMeshDistance<double>> enclosed(Index face) const {
    const filters::Parts at = parts(face);
    const auto closest = closest_point(at);
    const Index name = named_face_of(mesh_, face);
    if (!closest || (!mesh_.polygons.empty() && mesh_.polygons[name].size() > 3)) return std::nullopt;
    const auto& [x, square, distance] = *closest;
    const std::array of{FacePart::vertex, FacePart::edge, FacePart::inside};
    const MeshPoint<double> place{x, name, of[static_cast<std::size_t>(at.of_a.corners - 1)]};
    return PointMeshDistance<double>{{}, place, square, distance, distance};
  }

  PointMeshDistance<double> exact(Index face) const {
    const auto& [a, b, c] = triangle(face);
    const Index name = named_face_of(mesh_, face);
    Polygon3d points{{point_, a, b, c}};
    for (const Index i : corners_of_named(mesh_, name)) points.vertices.push_back(mesh_.vertices[i]);
    const auto [at, exponent] = integers_of(points);
    const QuotientPoint x = nearest_on_triangle(at[0], {at[1], at[2], at[3]});
    const auto [nearest, square, distance] = closest_point(at[0], x, exponent);
    return {{}, {nearest, name, face_part(x, {at.begin() + 4, at.end()})}, square, distance, distance};
  }

  const Point3d& point_;
  const Meshd& mesh_;
  std::vector<Index> faces_;
};

}  // namespace

PointMeshDistance<double> nearest_of_faces(const Point3d& point, const Meshd& mesh, std::vector<Index> faces,
                                           Stage& latest) {
  return NearestOfFaces(point, mesh, std::move(faces)).found(latest);
}

}  // namespace touchstone::robust::kernel
