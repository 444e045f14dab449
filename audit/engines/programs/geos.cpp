// SPDX-License-Identifier: Apache-2.0
#include <geos_c.h>

#include <functional>
#include <memory>
#include <stdexcept>

#include "audit/engines/adapter.h"

using namespace touchstone;

/// GEOS through its C interface. Geometries are closed sets in the DE-9IM model and its predicates have no tolerance. A line
/// string of length zero is invalid (GEOSisValid), and predicates on invalid geometries promise nothing. The relation of two segments is
/// the predicate's (GEOSRelate); where the construction (GEOSIntersection) contradicts it, that is an error.
struct Geos {
  static constexpr const char* name = "GEOS " GEOS_VERSION;
  static constexpr auto boundary = Boundary::closed;

  Geos() : context_(GEOS_init_r(), GEOS_finish_r) {
    GEOSContext_setErrorMessageHandler_r(
        context_.get(), [](const char* message, void* said) { *static_cast<std::string*>(said) = message; }, &said_);
  }

  std::optional<SegmentSegment<double>> segment_segment(const Segment2d& first, const Segment2d& second) {
    const Geometry a = line(first), b = line(second);
    if (!valid(a) || !valid(b)) return std::nullopt;
    const SegmentRelation relation = relate(a, b);
    SegmentSegment<double> answer{relation, {}, {}, {}, {}};
    const Geometry common = owned(GEOSIntersection_r(context_.get(), a.get(), b.get()));
    const bool empty = checked(GEOSisEmpty_r(context_.get(), common.get()));
    const int type = GEOSGeomTypeId_r(context_.get(), common.get());
    if (relation == SegmentRelation::point && !empty && type == GEOS_POINT) {
      answer.point = coordinates(common, 0);
    } else if (relation == SegmentRelation::overlap && !empty && type == GEOS_LINESTRING) {
      const int last = GEOSGeomGetNumPoints_r(context_.get(), common.get()) - 1;
      const Point2d p = coordinates(common, 0), q = coordinates(common, static_cast<unsigned>(last));
      answer.overlap = p.x < q.x || (p.x == q.x && p.y < q.y) ? Segment2d{p, q} : Segment2d{q, p};
    } else if (relation != SegmentRelation::disjoint || !empty) {
      throw std::runtime_error(std::string("GEOSRelate says ") + audit::Words<SegmentRelation>::words[static_cast<int>(relation)] +
                               ", GEOSIntersection is " + (empty ? "empty" : type == GEOS_POINT ? "a point" : "a line string"));
    }
    return answer;
  }

  std::optional<bool> point_on_segment(const Point2d& p, const Segment2d& s) {
    const Geometry point = owned(GEOSGeom_createPointFromXY_r(context_.get(), p.x, p.y)), closed = line(s);
    if (!valid(closed)) return std::nullopt;
    return checked(GEOSIntersects_r(context_.get(), point.get(), closed.get()));
  }

  /// 1 is a left turn: so says geos/algorithm/Orientation.h, and so it answers. The comment in geos_c.h of 3.11 has it reversed.
  Side orientation(const Point2d& p0, const Point2d& p1, const Point2d& p) {
    const int index = GEOSOrientationIndex_r(context_.get(), p0.x, p0.y, p1.x, p1.y, p.x, p.y);
    if (index == 2) throw std::runtime_error(said_);
    return index > 0 ? Side::left : index < 0 ? Side::right : Side::on;
  }

 private:
  struct Destroy {
    GEOSContextHandle_t context;
    void operator()(GEOSGeometry* geometry) const { GEOSGeom_destroy_r(context, geometry); }
  };
  using Geometry = std::unique_ptr<GEOSGeometry, Destroy>;

  Geometry owned(GEOSGeometry* geometry) {
    if (geometry == nullptr) throw std::runtime_error(said_);
    return Geometry(geometry, {context_.get()});
  }
  bool checked(char result) {
    if (result == 2) throw std::runtime_error(said_);
    return result == 1;
  }
  /// By the dimension of what the interiors and boundaries share in the DE-9IM matrix.
  SegmentRelation relate(const Geometry& a, const Geometry& b) {
    const std::unique_ptr<char, std::function<void(char*)>> matrix(GEOSRelate_r(context_.get(), a.get(), b.get()),
                                                                   [this](char* text) { GEOSFree_r(context_.get(), text); });
    if (!matrix) throw std::runtime_error(said_);
    const char* shared = matrix.get();
    if (shared[0] == '1') return SegmentRelation::overlap;
    const bool apart = shared[0] == 'F' && shared[1] == 'F' && shared[3] == 'F' && shared[4] == 'F';
    return apart ? SegmentRelation::disjoint : SegmentRelation::point;
  }
  bool valid(const Geometry& geometry) { return checked(GEOSisValid_r(context_.get(), geometry.get())); }

  Geometry line(const Segment2d& s) {
    const double ends[] = {s.a.x, s.a.y, s.b.x, s.b.y};
    return owned(GEOSGeom_createLineString_r(context_.get(), GEOSCoordSeq_copyFromBuffer_r(context_.get(), ends, 2, 0, 0)));
  }
  Point2d coordinates(const Geometry& geometry, unsigned i) {
    Point2d p{};
    GEOSCoordSeq_getXY_r(context_.get(), GEOSGeom_getCoordSeq_r(context_.get(), geometry.get()), i, &p.x, &p.y);
    return p;
  }

  std::unique_ptr<GEOSContextHandle_HS, decltype(&GEOS_finish_r)> context_;
  std::string said_;
};

TOUCHSTONE_ENGINE_MAIN(Geos)
