// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>

#include "robust/hulls/facet.h"

namespace touchstone::robust::hulls {

/// A convex surface of triangles that grows until no point is above it (quickhull). Each facet keeps the points that
/// are strictly above it; each point is kept once. The farthest of a facet's points is added: the facets that it is
/// above are removed, and triangles between it and the edges of the hole take their place and their points.
///
/// "Above" is strict and exact. So the facets that go are connected, even where others lie in one plane with the
/// point, and so are those that stay (in the dual polytope each are the vertices on one side of a plane): the hole is
/// bounded by one cycle that meets itself nowhere. No new triangle is degenerate, because the point is not on the
/// plane of the facet beyond the hole's edge. A point above a removed facet and above no new one is inside: it is below
/// both facets of each edge of the hole, hence below the planes between them. Facets of one plane, and corners inside
/// edges and faces, remain until the end (faces.h).
class Surface {
 public:
  Surface(const Frame& frame, Grain grain, Stage& latest) : sides(frame, grain, latest) {}

  /// Makes the first facets of four points that are not coplanar, and distributes the others over them. If all are
  /// coplanar, nothing changes, and the corners of a largest simplex, which is smaller, are returned.
  std::optional<std::vector<FramePoint>> start();

  /// Grows until no facet has a point above it.
  void grow();

  /// Called before points are assigned to facets: each of these facets gets a slot below `count`, which begins empty.
  void open_slots(std::size_t count) { farthest_.assign(count, 0), kept_.assign(count, 0); }
  /// Point q is `height` above facet f, which has that slot.
  void keep(std::int32_t q, std::int32_t f, double height, std::size_t slot);
  /// Queues the facet to be grown over: long lists in turn, short ones at once, while their points are in the cache.
  void wait(std::int32_t f, std::size_t slot);

  Facet& facet(std::int32_t f) { return facets[static_cast<std::size_t>(f)]; }
  FramePoint& point(std::int32_t p) { return points[static_cast<std::size_t>(p)]; }
  int side(const Facet& f, const FramePoint& p, double& height) const { return sides.of(f, p, points, height); }

  std::vector<FramePoint> points;
  std::vector<Facet> facets;  ///< those that are not alive are free
  Sides sides;

 private:
  struct Edge {
    std::int32_t from, to, beyond;
  };

  std::int32_t facet_of(std::int32_t a, std::int32_t b, std::int32_t c);
  void hand_out_loose();
  void add_farthest_of(std::int32_t f);
  void see_from(std::int32_t f, const FramePoint& p);

  std::vector<std::int32_t> marks_, free_, stack_, queue_, seen_, loose_, fresh_;
  std::vector<Edge> rim_;
  std::vector<double> farthest_;    ///< height of the farthest point, by slot
  std::vector<std::int32_t> kept_;  ///< number of points, by slot
  std::int32_t stamp_ = 0;
};

}  // namespace touchstone::robust::hulls
