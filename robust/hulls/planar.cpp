// SPDX-License-Identifier: Apache-2.0
#include "robust/hulls/planar.h"

#include <algorithm>
#include <array>

#include "robust/lines/orientation.h"

namespace touchstone::robust {
namespace {

struct Place {
  Point2d at;
  Index index;
};

bool before(const Place& p, const Place& q) {
  if (p.at.x != q.at.x) return p.at.x < q.at.x;
  return p.at.y != q.at.y ? p.at.y < q.at.y : p.index < q.index;
}

/// Goes from left to right below all points, then back above them (monotone chain).
std::vector<Place> chain(std::vector<Place> places, Stage& latest) {
  std::sort(places.begin(), places.end(), before);
  const auto equal = [](const Place& p, const Place& q) { return p.at == q.at; };
  places.erase(std::unique(places.begin(), places.end(), equal), places.end());
  std::vector<Place> ring;
  for (int pass = 0; pass < 2 && places.size() > 1; ++pass) {
    const std::size_t start = ring.size();
    for (const Place& p : places) {
      while (ring.size() >= start + 2 &&
             stages::orientation::ask(ring[ring.size() - 2].at, ring.back().at, p.at).noting(latest) != Side::left) {
        ring.pop_back();
      }
      ring.push_back(p);
    }
    ring.pop_back();  // the next chain starts with it
    std::reverse(places.begin(), places.end());
  }
  return places.size() > 1 ? ring : places;
}

/// The points farthest in eight directions, up to rounding: which points these are affects only speed.
std::vector<Place> far_points(const std::vector<Point2d>& points) {
  std::array<Index, 8> far{};
  std::array<double, 8> most{};
  for (std::size_t i = 0; i < points.size(); ++i) {
    const Point2d& p = points[i];
    const std::array<double, 8> heights{p.x, p.y, p.x + p.y, p.x - p.y, -p.x, -p.y, -p.x - p.y, p.y - p.x};
    for (std::size_t k = 0; k < far.size(); ++k) {
      if (i == 0 || heights[k] > most[k]) far[k] = static_cast<Index>(i), most[k] = heights[k];
    }
  }
  std::vector<Place> places;
  for (const Index i : far) places.push_back({points[i], i});
  return places;
}

/// Fewer points are sorted at once.
constexpr std::size_t worth_looking = 32;

}  // namespace

std::vector<Index> planar_hull(const std::vector<Point2d>& points, Stage& latest) {
  std::vector<Place> corners;
  Stage of_corners = Stage::filter;  // its decisions are not those of the hull
  if (points.size() >= worth_looking) corners = chain(far_points(points), of_corners);
  std::vector<Place> places;
  for (std::size_t i = 0; i < points.size(); ++i) {
    bool inside = corners.size() > 2;
    for (std::size_t k = 0; k < corners.size() && inside; ++k) {
      const Point2d &p = corners[k].at, &q = corners[k + 1 == corners.size() ? 0 : k + 1].at;
      inside = filters::orientation(p, q, points[i]) == filters::Sign::positive;
    }
    if (!inside) places.push_back({points[i], static_cast<Index>(i)});
  }
  std::vector<Index> ring;
  for (const Place& place : chain(std::move(places), latest)) ring.push_back(place.index);
  return ring;
}

}  // namespace touchstone::robust
