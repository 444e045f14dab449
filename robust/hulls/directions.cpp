// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cmath>

#include "robust/hulls/solid.h"
#include "robust/kernel/machine/parallel.h"

// Most points of a cloud are far from its hull. The farthest point in each of some hundred directions from the centre
// of the box is found, and the hull of those. A finer grid of directions then stores for each cell which facets its
// rays can meet, and a distance within which a point is certainly inside: one comparison for most points. A point
// beyond that distance is outside if and only if it is strictly above one of the facets that its ray can meet, which is
// decided exactly. Those few remain, sorted by cell, so that neighbours in space are neighbours in memory.
//
// With any rounding the centre O lies inside the surface by 10^-4 of each normal's length
// (checked; |q| < 2). So the ray from O to a point p meets the surface once, in a facet f, and p is outside if and
// only if it is above f. Directions are rounded by less than 10^-15, so that a facet is met in a cell, or at most
// 10^-11 outside it; each cell's list has all facets that come within 10^-9 of it. It may have more: a point above any
// other facet is outside, too.
namespace touchstone::robust::hulls {
namespace {

constexpr double slack = 1e-9, depth = 1e-4;
constexpr std::array<std::size_t, 3> next{1, 2, 0};

double length(const Facet& f) { return std::sqrt(f.n[0] * f.n[0] + f.n[1] * f.n[1] + f.n[2] * f.n[2]); }

/// A lower bound of the surface's height above the centre, in units of the normal's length.
double depth_below(const Facet& f, const FramePoint& centre) { return -f.height(centre) - 3 * double{f.error}; }

/// A cube map of k * k cells on each face, as Directions has it, with the facets that each cell's rays can meet.
class CubeMap {
 public:
  CubeMap(int k, const Surface& surface, const FramePoint& centre) : k_(k), surface_(surface), centre_(centre) {}

  std::size_t cells() const { return static_cast<std::size_t>(6) * static_cast<std::size_t>(k_ * k_); }

  /// Returns false if there would be more than `most` entries.
  bool list_facets(std::size_t most) {
    struct Entry {
      std::int32_t cell, facet;
    };
    std::vector<Entry> entries;
    for (std::size_t f = 0; f < surface_.facets.size(); ++f) {
      if (!surface_.facets[f].alive()) continue;
      for (int face = 0; face < 6; ++face) {
        const auto box = box_on(face, surface_.facets[f]);
        if (!box) continue;
        for (int i = box->low[0]; i <= box->high[0]; ++i) {
          for (int j = box->low[1]; j <= box->high[1]; ++j)
            entries.push_back({(face * k_ + i) * k_ + j, static_cast<std::int32_t>(f)});
        }
        if (entries.size() > most) return false;
      }
    }
    begins.assign(cells() + 1, 0);
    for (const Entry& entry : entries) ++begins[static_cast<std::size_t>(entry.cell) + 1];
    for (std::size_t c = 0; c < cells(); ++c) begins[c + 1] += begins[c];
    std::vector<std::size_t> ends(begins.begin(), begins.end() - 1);
    listed.resize(entries.size());
    for (const Entry& entry : entries) listed[ends[static_cast<std::size_t>(entry.cell)]++] = entry.facet;
    return true;
  }

  /// The distance, on the axis of a cell's face, up to which a point is below all of the cell's facets. Along a ray of
  /// direction v, 1 on that axis, the plane is reached at depth / (n . v), and n . v is greatest in a corner of the
  /// cell. Its rounding, 10^-14 |n|, is far less than 10^-6 of the depth. Not proved by machine.
  std::vector<double> inside_of_cells() const {
    std::vector<double> inside(cells(), 0);
    for (std::size_t c = 0; c < cells(); ++c) {
      const auto cell = static_cast<int>(c);
      const int face = cell / (k_ * k_), i = cell / k_ % k_, j = cell % k_;
      const auto axis = static_cast<std::size_t>(face / 2);
      const double u = 2.0 * i / k_ - 1, v = 2.0 * j / k_ - 1, step = 2.0 / k_;
      if (begins[c] == begins[c + 1]) continue;
      double least = std::numeric_limits<double>::infinity();
      for (std::size_t l = begins[c]; l < begins[c + 1]; ++l) {
        const Facet& f = surface_.facets[static_cast<std::size_t>(listed[l])];
        const double across = f.n[next[axis]], up = f.n[next[next[axis]]];
        const double rise = (face % 2 == 1 ? -f.n[axis] : f.n[axis]) + std::max(across * u, across * (u + step)) +
                            std::max(up * v, up * (v + step));
        if (rise > 0) least = std::min(least, depth_below(f, centre_) / rise);
      }
      inside[c] = least * (1 - 1e-6);
    }
    return inside;
  }

  std::vector<std::size_t> begins;   ///< by cell, into `listed`
  std::vector<std::int32_t> listed;  ///< facets

 private:
  struct Box {
    std::array<int, 2> low, high;
  };
  using Corner = std::array<double, 3>;  // across, up, ahead

  /// The cells of a face that lie in the box of the facet's projection: the facet is clipped to the face's pyramid.
  std::optional<Box> box_on(int face, const Facet& f) const {
    const auto axis = static_cast<std::size_t>(face / 2);
    const double sign = face % 2 == 1 ? -1 : 1;
    std::array<Corner, 8> ring, cut;
    std::size_t count = 3;
    for (std::size_t i = 0; i < 3; ++i) {
      const FramePoint& p = surface_.points[static_cast<std::size_t>(f.corner[i])];
      const std::size_t across = next[axis], up = next[across];
      ring[i] = {p[across] - centre_[across], p[up] - centre_[up], sign * (p[axis] - centre_[axis])};
    }
    for (int wall = 0; wall < 4 && count > 0; ++wall) {
      const auto inside = [&](const Corner& c) {
        const double side = c[static_cast<std::size_t>(wall / 2)];
        return c[2] * (1 + slack) - (wall % 2 == 1 ? -side : side);
      };
      std::size_t kept = 0;
      for (std::size_t i = 0; i < count; ++i) {
        const Corner &p = ring[i], &q = ring[i + 1 == count ? 0 : i + 1];
        const double a = inside(p), b = inside(q);
        if (a >= 0) cut[kept++] = p;
        if ((a >= 0) == (b >= 0)) continue;
        const double t = a / (a - b);
        cut[kept++] = {p[0] + t * (q[0] - p[0]), p[1] + t * (q[1] - p[1]), p[2] + t * (q[2] - p[2])};
      }
      count = kept;
      ring = cut;
    }
    if (count == 0) return std::nullopt;
    const auto cell_of = [this](double x) {
      return static_cast<int>(std::clamp(std::floor((x + 1) * (0.5 * k_)), 0.0, k_ - 1.0));
    };
    Box box{};
    for (std::size_t k = 0; k < 2; ++k) {
      double low = 2, high = -2;
      for (std::size_t i = 0; i < count; ++i) {
        const double x = ring[i][k] / std::max(ring[i][2], 1e-300);
        low = std::min(low, x), high = std::max(high, x);
      }
      box.low[k] = cell_of(low - 4 * slack), box.high[k] = cell_of(high + 4 * slack);
    }
    return box;
  }

  int k_;
  const Surface& surface_;
  FramePoint centre_;
};

/// Calls work(part, i, count) of consecutive points in each part, as many as Directions takes.
template <class Work>
void each_some(const kernel::ThreadParts& parts, const Work& work) {
  parts.each([&](std::size_t part, std::size_t first, std::size_t last) {
    for (std::size_t i = first; i < last; i += Directions::most) work(part, i, std::min(Directions::most, last - i));
  });
}

/// The farthest point of each cell, in the order of cells, and the first of those as far; sets the grain of all points.
std::vector<std::size_t> far_points(const std::vector<Point3d>& points, const Frame& frame, int k,
                                    const kernel::ThreadParts& parts, Grain& grain) {
  constexpr std::size_t none = static_cast<std::size_t>(-1);
  struct Farthest {
    Grain grain = Grain::narrow;
    std::vector<double> most;
    std::vector<std::size_t> point;
    Directions found;
  };
  std::vector<Farthest> of_parts(parts.size());
  for (Farthest& own : of_parts) {
    own.most.assign(static_cast<std::size_t>(6 * k * k), -1);
    own.point.assign(own.most.size(), none);
  }
  each_some(parts, [&](std::size_t part, std::size_t i, std::size_t count) {
    Farthest& own = of_parts[part];
    own.grain = std::max(own.grain, directions_of(points.data() + i, count, frame, k, own.found));
    for (std::size_t j = 0; j < count; ++j) {
      const auto cell = static_cast<std::size_t>(own.found.cell[j]);
      if (own.found.squared[j] > own.most[cell]) own.most[cell] = own.found.squared[j], own.point[cell] = i + j;
    }
  });
  Farthest& all = of_parts[0];
  for (const Farthest& own : of_parts) {
    all.grain = std::max(all.grain, own.grain);
    for (std::size_t cell = 0; cell < all.most.size(); ++cell) {
      if (own.most[cell] > all.most[cell]) all.most[cell] = own.most[cell], all.point[cell] = own.point[cell];
    }
  }
  grain = all.grain;
  std::erase(all.point, none);
  return all.point;
}

struct Outside {
  std::int32_t cell, facet;
  std::size_t point;
};

/// The points outside, in the order of the list.
std::vector<Outside> outside_of(const Surface& surface, const CubeMap& map, const std::vector<Point3d>& points,
                                const Frame& frame, int k, const kernel::ThreadParts& parts) {
  const std::vector<double> inside = map.inside_of_cells();
  std::vector<std::vector<Outside>> of_parts(parts.size());
  std::vector<Stage> latest(parts.size(), Stage::filter);
  each_some(parts, [&](std::size_t part, std::size_t i, std::size_t count) {
    const Sides sides(surface.sides, latest[part]);
    Directions found;
    std::array<std::size_t, Directions::most> inconclusive{};
    double height = 0;
    directions_of(points.data() + i, count, frame, k, found);
    std::size_t left = 0;
    for (std::size_t j = 0; j < count; ++j) {
      inconclusive[left] = j;
      left += !(found.distance[j] < inside[static_cast<std::size_t>(found.cell[j])]);
    }
    for (std::size_t t = 0; t < left; ++t) {
      const std::size_t j = inconclusive[t], cell = static_cast<std::size_t>(found.cell[j]);
      const FramePoint p = framed(frame, points, i + j);
      for (std::size_t l = map.begins[cell]; l < map.begins[cell + 1]; ++l) {
        if (sides.of(surface.facets[static_cast<std::size_t>(map.listed[l])], p, surface.points, height) <= 0) continue;
        of_parts[part].push_back({found.cell[j], map.listed[l], i + j});
        break;
      }
    }
  });
  for (std::size_t part = 1; part < parts.size(); ++part)
    of_parts[0].insert(of_parts[0].end(), of_parts[part].begin(), of_parts[part].end());
  for (const Stage each : latest) surface.sides.note(each);
  return std::move(of_parts[0]);
}

/// Keeps each point once, sorted by cell. Equal points are in one cell.
void keep_outside(Surface& surface, const std::vector<Outside>& outside, std::size_t cells,
                  const std::vector<Point3d>& points, const Frame& frame, std::size_t threads) {
  std::vector<std::size_t> ends(cells + 1, 0);
  for (const Outside& p : outside) ++ends[static_cast<std::size_t>(p.cell) + 1];
  for (std::size_t c = 0; c < cells; ++c) ends[c + 1] += ends[c];
  std::vector<Outside> sorted(outside.size());
  for (const Outside& p : outside) sorted[ends[static_cast<std::size_t>(p.cell)]++] = p;
  struct Kept {
    std::vector<FramePoint> points;
    std::vector<std::int32_t> facets;
  };
  const kernel::ThreadParts parts(threads, sorted.size(), 1U << 13);
  std::vector<Kept> of_parts(parts.size());
  parts.each([&](std::size_t part, std::size_t first, std::size_t last) {
    const auto next_cell = [&sorted](std::size_t i) {
      while (i > 0 && i < sorted.size() && sorted[i].cell == sorted[i - 1].cell) ++i;
      return i;
    };
    first = next_cell(first), last = next_cell(last);
    auto& [own, facets] = of_parts[part];
    Seen seen(last - first);
    for (std::size_t i = first; i < last; ++i) {
      const FramePoint p = framed(frame, points, sorted[i].point);
      if (!seen.is_new(p, static_cast<std::int32_t>(own.size()), own)) continue;
      own.push_back(p), facets.push_back(sorted[i].facet);
    }
  });
  surface.points.reserve(surface.points.size() + sorted.size());
  surface.facets.reserve(surface.facets.size() + 2 * sorted.size() + 64);
  surface.open_slots(surface.facets.size());
  std::vector<std::int32_t> order;
  for (const Kept& own : of_parts) {
    for (std::size_t i = 0; i < own.points.size(); ++i) {
      const auto number = static_cast<std::int32_t>(surface.points.size());
      const std::int32_t f = own.facets[i];
      const Facet& facet = surface.facet(f);
      surface.points.push_back(own.points[i]);
      if (facet.above < 0) order.push_back(f);
      surface.keep(number, f, facet.height(own.points[i]), static_cast<std::size_t>(f));
    }
  }
  for (auto f = order.rbegin(); f != order.rend(); ++f) surface.wait(*f, static_cast<std::size_t>(*f));
}

}  // namespace

std::optional<Surface> surface_of_far_points(const std::vector<Point3d>& points, const Frame& frame, Stage& latest,
                                              std::size_t threads) {
  const kernel::ThreadParts parts(threads, points.size(), 1U << 14);
  const double directions = std::pow(static_cast<double>(points.size()), 0.25) / 2;
  const int coarse = std::clamp(static_cast<int>(std::lround(directions)), 1, 32), fine = 4 * coarse;
  Grain grain = Grain::narrow;
  const std::vector<std::size_t> far = far_points(points, frame, coarse, parts, grain);
  if (grain == Grain::lossy) return std::nullopt;
  Surface surface(frame, grain, latest);
  for (const std::size_t i : far) surface.points.push_back(framed(frame, points, i));
  if (surface.start()) return std::nullopt;
  surface.grow();
  const FramePoint centre{frame.centre[0], frame.centre[1], frame.centre[2], -1, -1};
  for (const Facet& f : surface.facets) {
    if (f.alive() && !(depth_below(f, centre) > depth * length(f))) return std::nullopt;
  }
  CubeMap map(fine, surface, centre);
  if (!map.list_facets(4 * points.size() + 100'000)) return std::nullopt;
  keep_outside(surface, outside_of(surface, map, points, frame, fine, parts), map.cells(), points, frame, threads);
  return surface;
}

}  // namespace touchstone::robust::hulls
