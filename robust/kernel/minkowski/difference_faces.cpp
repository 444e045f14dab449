// SPDX-License-Identifier: Apache-2.0
#include "robust/kernel/minkowski/difference_faces.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>

namespace touchstone::robust::kernel {
namespace {

constexpr std::uint32_t nobody = ~std::uint32_t{0};

bool vanishes(const Vector3d& v) { return v.x == 0 && v.y == 0 && v.z == 0; }
Vector3d some_normal_of(const Vector3d& v) {
  return std::fabs(v.x) < std::fabs(v.y) ? Vector3d{0, v.z, -v.y} : Vector3d{-v.z, 0, v.x};
}

/// A closed surface of triangles between points of b - a, which grows where the origin is nearest to it: the expanding
/// polytope of van den Bergen, here with certain bounds.
///
/// Why its nearest faces are those of the difference: let D be the least distance of a triangle's plane from the
/// origin, and let the origin be below all of them. Each triangle is then seen from the origin the same way round, so
/// the surface, which is closed, winds around the origin, and with it around all points nearer than D, which it does
/// not meet. A point around which it winds is in the hull of its vertices. So the ball of radius D is in the
/// difference. If a plane at distance D bounds the difference, no point of the boundary is nearer; and a plane that
/// bounds it at distance D touches the ball, whose point there is on the surface: it is the plane of a triangle. None
/// of this needs the surface to be convex or free of crossings, as rounding might leave it: only that it is closed,
/// because it is always a cone over the rim of a hole that closes it, and that heights and distances are certain.
class Polytope {
 public:
  Polytope(const Meshd& a, const Meshd& b) : a_(a.vertices), b_(b.vertices) {
    corners_.reserve(64), facets_.reserve(256);
  }

  std::optional<std::vector<DifferenceFace>> nearest_faces() {
    if (!start()) return std::nullopt;
    for (;;) {
      const std::uint32_t nearest = next();
      if (nearest == nobody) break;
      Facet& facet = facets_[nearest];
      const Corners beyond = farthest_along({facet.normal.x.value, facet.normal.y.value, facet.normal.z.value});
      if (above(facet, beyond).positive()) {
        if (dot(facet.normal, displacement(beyond)).not_positive() || corners_.size() == most_corners ||
            !expand(nearest, beyond))
          return std::nullopt;
      } else if (facet.range.least > 0) {
        facet.bounds = true;
      } else {
        return std::nullopt;
      }
    }
    std::vector<DifferenceFace> found;
    for (const Facet& facet : facets_)
      if (facet.there && !(facet.range.least > most_))
        found.push_back({corners_[facet.at[0]], corners_[facet.at[1]], corners_[facet.at[2]]});
    if (found.empty()) return std::nullopt;
    return found;
  }

 private:
  using Length = filters::Sized<1>;
  using Sum = filters::Sized<2>;
  using Product = filters::Sized<6>;

  struct Facet {
    std::array<std::uint32_t, 3> at, neighbors;  // neighbor k shares the edge from corner k to the next
    filters::Triple<Product> normal;
    DistanceRange range;
    double distance;
    bool there, bounds;
  };

  /// A surface of more corners is left to the other methods. Not a bound of the answer.
  static constexpr std::size_t most_corners = 4096;

  filters::Triple<Length> displacement(const Corners& c) const {
    return filters::sized_between(a_[c.of_a], b_[c.of_b]);
  }
  filters::Triple<Sum> between(const Corners& p, const Corners& q) const {
    const auto of_b = filters::sized_between(b_[p.of_b], b_[q.of_b]),
               of_a = filters::sized_between(a_[p.of_a], a_[q.of_a]);
    return {of_b.x - of_a.x, of_b.y - of_a.y, of_b.z - of_a.z};
  }
  filters::Sized<11> above(const Facet& facet, const Corners& c) const {
    return dot(facet.normal, between(corners_[facet.at[0]], c));
  }
  Corners farthest_along(const Vector3d& n) const { return {lowest(a_, n), lowest(b_, -1.0 * n)}; }
  Vector3d rounded(const Corners& c) const { return b_[c.of_b] - a_[c.of_a]; }

  Facet facet_of(std::uint32_t i, std::uint32_t j, std::uint32_t k) const {
    const Corners &p = corners_[i], &q = corners_[j], &r = corners_[k];
    const auto normal = cross(between(p, q), between(p, r));
    const auto height = dot(normal, displacement(p));
    const auto square = dot(normal, normal);
    return {{i, j, k},
            {nobody, nobody, nobody},
            normal,
            DistanceRange(height.value - height.error(), height.value + height.error(), square),
            square.value > 0 ? height.value / std::sqrt(square.value) : -std::numeric_limits<double>::infinity(),
            true,
            false};
  }

  /// A tetrahedron, each corner of which is sought where the origin lies as seen from those before.
  bool start() {
    const auto seen = [this](const Vector3d& n) {
      const Corners found = farthest_along(n);
      const bool is_new = std::find(corners_.begin(), corners_.end(), found) == corners_.end();
      if (is_new) corners_.push_back(found);
      return is_new;
    };
    seen({1, 0, 0});
    const Vector3d p = rounded(corners_[0]);
    if (!seen(-1.0 * p)) return false;
    const Vector3d line = rounded(corners_[1]) - p, across = cross(cross(line, -1.0 * p), line);
    if (!seen(vanishes(across) ? some_normal_of(line) : across)) return false;
    const Vector3d normal = cross(line, rounded(corners_[2]) - p);
    if (!seen(dot(normal, p) > 0 ? -1.0 * normal : normal)) return false;
    const bool up = dot(normal, rounded(corners_[3]) - p) > 0;
    if (up) std::swap(corners_[1], corners_[2]);
    facets_ = {facet_of(0, 1, 2), facet_of(0, 3, 1), facet_of(1, 3, 2), facet_of(2, 3, 0)};
    facets_[0].neighbors = {1, 2, 3}, facets_[1].neighbors = {3, 2, 0};
    facets_[2].neighbors = {1, 3, 0}, facets_[3].neighbors = {2, 1, 0};
    return true;
  }

  /// The nearest facet that may be nearer than any that bounds the difference, and is not known to bound it. One that
  /// seemed to, and was removed since, says nothing of how near that is.
  std::uint32_t next() {
    most_ = std::numeric_limits<double>::infinity();
    for (const Facet& facet : facets_)
      if (facet.there && facet.bounds) most_ = std::min(most_, facet.range.most);
    std::uint32_t found = nobody;
    double least = std::numeric_limits<double>::infinity();
    for (std::uint32_t i = 0; i < facets_.size(); ++i) {
      const Facet& facet = facets_[i];
      if (!facet.there || facet.bounds || facet.range.least > most_) continue;
      if (!(facet.distance >= least)) least = facet.distance, found = i;
    }
    return found;
  }

  /// Removes all facets from `first` on of which the corner is not certainly below, and closes the hole with a cone.
  bool expand(std::uint32_t first, const Corners& beyond) {
    const auto tip = static_cast<std::uint32_t>(corners_.size());
    corners_.push_back(beyond);
    removed_.assign(1, first), facets_[first].there = false;
    rim_.clear();
    for (std::size_t done = 0; done < removed_.size(); ++done) {
      const Facet facet = facets_[removed_[done]];
      for (std::size_t k = 0; k < 3; ++k) {
        Facet& other = facets_[facet.neighbors[k]];
        if (!other.there) continue;
        if (above(other, beyond).negative()) rim_.push_back({removed_[done], k});
        else other.there = false, removed_.push_back(facet.neighbors[k]);
      }
    }
    starting_at_.assign(corners_.size(), nobody);
    const auto start_of_cone = static_cast<std::uint32_t>(facets_.size());
    for (const auto& [facet, k] : rim_) {
      const std::uint32_t from = facets_[facet].at[k], to = facets_[facet].at[(k + 1) % 3],
                          outer = facets_[facet].neighbors[k], made = static_cast<std::uint32_t>(facets_.size());
      if (starting_at_[from] != nobody) return false;  // the rim meets itself
      starting_at_[from] = made;
      facets_.push_back(facet_of(from, to, tip)), facets_[made].neighbors[0] = outer;
      for (std::size_t j = 0; j < 3; ++j)
        if (facets_[outer].at[j] == to && facets_[outer].at[(j + 1) % 3] == from) facets_[outer].neighbors[j] = made;
    }
    for (std::uint32_t i = start_of_cone; i < facets_.size(); ++i) {
      const std::uint32_t after = starting_at_[facets_[i].at[1]];
      if (after == nobody) return false;
      facets_[i].neighbors[1] = after, facets_[after].neighbors[2] = i;
    }
    return facets_.size() > start_of_cone;
  }

  struct Side {
    std::uint32_t facet;
    std::size_t edge;
  };

  const std::vector<Point3d>&a_, &b_;
  std::vector<Corners> corners_;
  std::vector<Facet> facets_;
  std::vector<std::uint32_t> removed_, starting_at_;
  std::vector<Side> rim_;
  double most_ = std::numeric_limits<double>::infinity();  // the distance of a facet that is there is no greater
};

}  // namespace

bool all_moderate(const Meshd& mesh) {
  int all = 1;
  for (const Point3d& p : mesh.vertices) all &= static_cast<int>(filters::moderate(p));
  return all != 0;
}

/// Four at a time, since each comparison waits for the one before.
Index lowest(const std::vector<Point3d>& points, const Vector3d& n) {
  constexpr std::size_t chains = 4;
  const Point3d& first = points[0];
  std::size_t found[chains] = {};
  double least[chains] = {};
  const auto look = [&](std::size_t chain, std::size_t i) {
    const double height = dot(n, points[i] - first);
    const bool lower = height < least[chain];
    least[chain] = lower ? height : least[chain], found[chain] = lower ? i : found[chain];
  };
  std::size_t i = 0;
  for (; i + chains <= points.size(); i += chains)
    for (std::size_t chain = 0; chain < chains; ++chain) look(chain, i + chain);
  for (; i < points.size(); ++i) look(i % chains, i);
  std::size_t lowest = 0;
  for (std::size_t chain = 1; chain < chains; ++chain)
    if (least[chain] < least[lowest] || (least[chain] == least[lowest] && found[chain] < found[lowest])) lowest = chain;
  return static_cast<Index>(found[lowest]);
}

std::optional<std::vector<DifferenceFace>> nearest_difference_faces(const Meshd& a, const Meshd& b) {
  if (!all_moderate(a) || !all_moderate(b)) return std::nullopt;
  return Polytope(a, b).nearest_faces();
}

}  // namespace touchstone::robust::kernel
