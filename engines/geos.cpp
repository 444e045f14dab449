// SPDX-License-Identifier: Apache-2.0
#include <geos_c.h>
#include <touchstone/program/engine_main.h>

#include <algorithm>

#include "geos_session.h"

using namespace touchstone;

/// The predicates of GEOS. Geometries are closed sets in the DE-9IM model, without a tolerance. Its constructions are
/// audited apart (geos_overlay): the two contradict each other now and then, and neither is always the one that is
/// right.
struct Geos {
  static constexpr const char* name = "GEOS " GEOS_VERSION " (predicates)";
  static constexpr auto boundary = Boundary::closed;

  /// By the dimension of what interiors and boundaries share in the DE-9IM matrix.
  std::optional<SegmentRelation> segment_segment(const Segment2d& first, const Segment2d& second) {
    const auto a = geos_.line(first), b = geos_.line(second);
    if (!geos_.valid(a) || !geos_.valid(b)) return std::nullopt;
    const std::string shared = geos_.relate(a, b);
    if (shared[0] == '1') return SegmentRelation::overlap;
    return apart(shared) ? SegmentRelation::disjoint : SegmentRelation::point;
  }

  std::optional<bool> point_on_segment(const Point2d& p, const Segment2d& s) {
    const auto point = geos_.point(p), closed = geos_.line(s);
    if (!geos_.valid(closed)) return std::nullopt;
    return geos_.checked(GEOSIntersects_r(geos_.context(), point.get(), closed.get()));
  }

  /// 1 is a left turn: so says geos/algorithm/Orientation.h, and so it answers. The comment in geos_c.h of 3.11 has it
  /// reversed.
  Side orientation(const Point2d& p0, const Point2d& p1, const Point2d& p) {
    const int index = GEOSOrientationIndex_r(geos_.context(), p0.x, p0.y, p1.x, p1.y, p.x, p.y);
    if (index == 2) geos_.fail();
    return index > 0 ? Side::left : index < 0 ? Side::right : Side::on;
  }

  std::optional<Location> point_in_polygon(const Polygon2d& ring, const Point2d& p) { return location(ring, p); }
  std::optional<Location> point_in_region(const Region2d& region, const Point2d& p) { return location(region, p); }

  std::optional<Contact> polygon_polygon(const Polygon2d& a, const Polygon2d& b) { return contact(a, b); }
  std::optional<Contact> region_region(const Region2d& a, const Region2d& b) { return contact(a, b); }

  /// Every vertex is triangulated, flat ones too (geos/triangulate/polygon/PolygonEarClipper.h); the corners of its
  /// triangles go round clockwise.
  std::optional<std::vector<std::vector<Index>>> triangulate_polygon(const Polygon2d& ring) {
    const auto solid = geos_.polygon(ring);
    if (!geos_.valid(solid)) return std::nullopt;
    const auto all = geos_.owned(GEOSConstrainedDelaunayTriangulation_r(geos_.context(), solid.get()));
    std::vector<std::vector<Index>> triangles;
    for (int i = 0; i < GEOSGetNumGeometries_r(geos_.context(), all.get()); ++i) {
      const auto* triangle = geos_.made(GEOSGetGeometryN_r(geos_.context(), all.get(), i));
      const auto* corners = geos_.made(GEOSGetExteriorRing_r(geos_.context(), triangle));
      triangles.emplace_back();
      for (const int corner : {2, 1, 0}) {
        const auto place = std::find(ring.vertices.begin(), ring.vertices.end(), geos_.vertex(corners, corner));
        if (place == ring.vertices.end()) throw std::runtime_error("a triangle has a corner that is no vertex");
        triangles.back().push_back(static_cast<Index>(place - ring.vertices.begin()));
      }
    }
    return triangles;
  }

 private:
  template <class Solid>
  std::optional<Location> location(const Solid& of, const Point2d& p) {
    const auto point = geos_.point(p), solid = geos_.polygon(of);
    if (!geos_.valid(solid)) return std::nullopt;
    const std::string shared = geos_.relate(point, solid);
    return shared[0] != 'F' ? Location::inside : shared[1] != 'F' ? Location::boundary : Location::outside;
  }
  template <class Solid>
  std::optional<Contact> contact(const Solid& first, const Solid& second) {
    const auto a = geos_.polygon(first), b = geos_.polygon(second);
    if (!geos_.valid(a) || !geos_.valid(b)) return std::nullopt;
    const std::string shared = geos_.relate(a, b);
    return shared[0] != 'F' ? Contact::overlapping : apart(shared) ? Contact::disjoint : Contact::touching;
  }
  static bool apart(const std::string& shared) {
    return shared[0] == 'F' && shared[1] == 'F' && shared[3] == 'F' && shared[4] == 'F';
  }

  GeosSession geos_;
};

TOUCHSTONE_ENGINE_MAIN(Geos)
