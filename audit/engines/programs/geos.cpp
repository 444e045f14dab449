// SPDX-License-Identifier: Apache-2.0
#include <geos_c.h>

#include <functional>

#include "audit/engines/adapter.h"
#include "audit/engines/programs/geos_session.h"

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
    const std::unique_ptr<char, std::function<void(char*)>> matrix(
        geos_.made(GEOSRelate_r(geos_.context(), a.get(), b.get())),
        [this](char* text) { GEOSFree_r(geos_.context(), text); });
    const char* shared = matrix.get();
    if (shared[0] == '1') return SegmentRelation::overlap;
    const bool apart = shared[0] == 'F' && shared[1] == 'F' && shared[3] == 'F' && shared[4] == 'F';
    return apart ? SegmentRelation::disjoint : SegmentRelation::point;
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

 private:
  GeosSession geos_;
};

TOUCHSTONE_ENGINE_MAIN(Geos)
