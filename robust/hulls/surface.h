// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>
#include <optional>
#include <utility>

#include "robust/hulls/facet.h"


namespace touchstone::robust::hulls {

/// Elements that a vector makes without a value have none: the thread that sets one first touches its memory first.
template <class T>
struct Unset : std::allocator<T> {
  template <class Other>
  struct rebind {
    using other = Unset<Other>;
  };
  template <class Other, class... Args>
  void construct(Other* at, Args&&... args) {
    if constexpr (sizeof...(args) == 0) ::new (static_cast<void*>(at)) Other;
    else ::new (static_cast<void*>(at)) Other(std::forward<Args>(args)...);
  }
};

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
  Surface(const Frame& frame, Grain grain, Stage& latest) : sides(frame, grain, latest), whole_(sides) {}

  /// Makes the first facets of four points that are not coplanar, and distributes the others over them. If all are
  /// coplanar, nothing changes, and the corners of a largest simplex, which is smaller, are returned.
  std::optional<std::vector<FramePoint>> start();

  /// Grows until no facet has a point above it: the facets' order depends on the number of threads, no more.
  void grow(std::size_t threads = 1);

  /// Called before points are assigned to facets: each of these facets gets a slot below `count`, which begins empty.
  void open_slots(std::size_t count) { open_slots(whole_, count); }
  /// Point q is `height` above facet f, which has that slot.
  void keep(std::int32_t q, std::int32_t f, double height, std::size_t slot) { keep(whole_, q, f, height, slot); }
  /// Queues the facet to be grown over: long lists in turn, short ones at once, while their points are in the cache.
  void wait(std::int32_t f, std::size_t slot) { wait(whole_, f, slot); }

  Facet& facet(std::int32_t f) { return facets[static_cast<std::size_t>(f)]; }
  FramePoint& point(std::int32_t p) { return points[static_cast<std::size_t>(p)]; }

  std::vector<FramePoint> points;
  std::vector<Facet, Unset<Facet>> facets;  ///< those that are not alive are free
  Sides sides;

 private:
  struct Edge {
    std::int32_t from, to, beyond;
  };
  /// The state of what grows: the whole surface, or one of its regions while others do.
  struct Growth {
    explicit Growth(const Sides& of) : sides(of) {}

    Sides sides;
    std::vector<std::int32_t> free, stack, queue, seen, loose, fresh;
    std::vector<Edge> rim;
    std::vector<double> farthest;    ///< height of the farthest point, by slot
    std::vector<std::int32_t> kept;  ///< number of points, by slot
    std::int32_t stamp = 0;
    // Only a region has these.
    std::int16_t region = -1;
    std::int32_t next_free = 0, end_of_free = 0;
    std::vector<std::int32_t> blocked;      ///< facets whose farthest point needs another region's
    std::vector<std::int32_t> first_edges;  ///< by corner, for one hole
  };

  std::int32_t facet_of(Growth& own, std::int32_t a, std::int32_t b, std::int32_t c);
  static void open_slots(Growth& own, std::size_t count) { own.farthest.assign(count, 0), own.kept.assign(count, 0); }
  void keep(Growth& own, std::int32_t q, std::int32_t f, double height, std::size_t slot);
  static void wait(Growth& own, std::int32_t f, std::size_t slot);
  void hand_out_loose(Growth& own);
  void add_farthest_of(Growth& own, std::int32_t f);
  bool see_from(Growth& own, std::int32_t f, const FramePoint& p);
  void grow(Growth& own);
  std::int32_t& first_edge(Growth& own, std::int32_t corner) {
    return own.region < 0 ? point(corner).next : own.first_edges[static_cast<std::size_t>(corner)];
  }
  int side(const Growth& own, const Facet& f, const FramePoint& p, double& height) const {
    return own.sides.of(f, p, points, height);
  }
  bool belongs_to(const Growth& own, std::int32_t f) const {
    return own.region < 0 || regions_[static_cast<std::size_t>(f)] == own.region;
  }
  void make_ready(Growth& own, std::int16_t region);
  /// False if too few points wait for that.
  bool grow_regions(std::size_t threads, std::size_t axis);

  Growth whole_;
  std::vector<std::int32_t> marks_;    ///< by facet
  std::vector<std::int16_t> regions_;  ///< by facet, while regions grow
};

}  // namespace touchstone::robust::hulls
