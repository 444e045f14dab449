// SPDX-License-Identifier: Apache-2.0
#include <geos_c.h>
#include <touchstone/program/engine_main.h>

#include "geos_session.h"

using namespace touchstone;

/// The constructions of GEOS: GEOSIntersection of two closed segments, of two polygons. Its vertices are rounded, and
/// where a first attempt in full precision fails it snaps; how far is not part of its interface, so no tolerance is
/// declared.
struct GeosOverlay {
  static constexpr const char* name = "GEOS " GEOS_VERSION " (overlay)";
  static constexpr auto boundary = Boundary::closed;

  std::optional<SegmentSegment<double>> segment_segment(const Segment2d& first, const Segment2d& second) {
    const auto a = geos_.line(first), b = geos_.line(second);
    if (!geos_.valid(a) || !geos_.valid(b)) return std::nullopt;
    const auto common = geos_.owned(GEOSIntersection_r(geos_.context(), a.get(), b.get()));
    SegmentSegment<double> answer{SegmentRelation::disjoint, {}, {}, {}, {}};
    if (geos_.checked(GEOSisEmpty_r(geos_.context(), common.get()))) return answer;
    const int type = GEOSGeomTypeId_r(geos_.context(), common.get());
    if (type == GEOS_POINT) {
      answer.relation = SegmentRelation::point;
      answer.point = geos_.vertex(common.get(), 0);
    } else if (type == GEOS_LINESTRING) {
      answer.relation = SegmentRelation::overlap;
      const Point2d p = geos_.vertex(common.get(), 0),
                    q = geos_.vertex(common.get(), GEOSGeomGetNumPoints_r(geos_.context(), common.get()) - 1);
      answer.overlap = p.x < q.x || (p.x == q.x && p.y < q.y) ? Segment2d{p, q} : Segment2d{q, p};
    } else {
      throw std::runtime_error("GEOSIntersection of two segments is neither a point nor a line string");
    }
    return answer;
  }

  /// By the dimension of what they have in common.
  std::optional<Contact> polygon_polygon(const Polygon2d& a, const Polygon2d& b) { return contact(a, b); }
  std::optional<Contact> region_region(const Region2d& a, const Region2d& b) { return contact(a, b); }

 private:
  template <class Solid>
  std::optional<Contact> contact(const Solid& first, const Solid& second) {
    const auto a = geos_.polygon(first), b = geos_.polygon(second);
    if (!geos_.valid(a) || !geos_.valid(b)) return std::nullopt;
    const auto common = geos_.owned(GEOSIntersection_r(geos_.context(), a.get(), b.get()));
    if (geos_.checked(GEOSisEmpty_r(geos_.context(), common.get()))) return Contact::disjoint;
    return GEOSGeom_getDimensions_r(geos_.context(), common.get()) == 2 ? Contact::overlapping : Contact::touching;
  }
  GeosSession geos_;
};

TOUCHSTONE_ENGINE_MAIN(GeosOverlay)
