// SPDX-License-Identifier: Apache-2.0
#include "oracle/exact/solids/nearest_on_surface.h"

#include <algorithm>
#include <stdexcept>
#include <tuple>
#include <utility>

namespace touchstone::oracle {
namespace {

Point3<Rational> rational(const Point3<Integer>& p) { return {Rational(p.x), Rational(p.y), Rational(p.z)}; }

std::vector<Point3<Integer>> without_last(std::vector<Point3<Integer>> points) {
  points.pop_back();
  return points;
}

}  // namespace

PointAndSurface::PointAndSurface(IntegerCloud cloud, const std::vector<Face>& faces)
    : unit(cloud.unit),
      point(rational(cloud.points.back())),
      solid(without_last(std::move(cloud.points)), faces, unit),
      square(solid.squared_distance(point)) {}

Point3<Rational> PointAndSurface::vertex(Index i) const { return rational(solid.vertices()[i]); }

Point3<Rational> PointAndSurface::actual(const Point3<Rational>& p) const {
  return {Rational(p.x * unit), Rational(p.y * unit), Rational(p.z * unit)};
}

Hull PointAndSurface::corners(std::size_t triangle) const {
  const auto& [a, b, c] = solid.faces()[triangle];
  return {vertex(a), vertex(b), vertex(c)};
}

bool PointAndSurface::box_is_beyond(const Hull& hull) const {
  Rational sum;
  for (Rational Point3<Rational>::*axis : {&Point3<Rational>::x, &Point3<Rational>::y, &Point3<Rational>::z}) {
    const auto& [low, high] = std::minmax({hull[0].*axis, hull[1].*axis, hull[2].*axis});
    const Rational gap = std::max({Rational(0), Rational(low - point.*axis), Rational(point.*axis - high)});
    sum += gap * gap;
  }
  return sum > square;
}

std::vector<NearPlace> PointAndSurface::nearest() const {
  std::vector<NearPlace> found;
  for (std::size_t i = 0; i < solid.faces().size(); ++i) {
    const Hull hull = corners(i);
    if (box_is_beyond(hull)) continue;
    NearestPair pair = nearest_pair(hull, {point});
    if (pair.squared_distance == square) found.push_back({i, pair.on_a, std::move(pair.weights_of_a)});
    else if (pair.squared_distance < square) throw std::logic_error("nearest_on_surface: a triangle is nearer");
  }
  if (found.empty()) throw std::logic_error("nearest_on_surface: no triangle is as near");
  return found;
}

const NearPlace& first_of(const std::vector<NearPlace>& places) {
  return *std::min_element(places.begin(), places.end(), [](const NearPlace& a, const NearPlace& b) {
    return std::tie(a.point.x, a.point.y, a.point.z) < std::tie(b.point.x, b.point.y, b.point.z);
  });
}

}  // namespace touchstone::oracle
