// SPDX-License-Identifier: Apache-2.0
#define BOOST_ALLOW_DEPRECATED_HEADERS  // some of its own includes are
#include <touchstone/program/engine_main.h>

#include <boost/geometry.hpp>
#include <boost/geometry/geometries/point_xy.hpp>
#include <boost/geometry/geometries/polygon.hpp>
#include <boost/geometry/geometries/segment.hpp>
#include <boost/version.hpp>
#include <deque>
#include <stdexcept>

namespace bg = boost::geometry;
using namespace touchstone;

/// Boost.Geometry's geometries are closed: `intersects` and `covered_by` count ends and touches, `within` does not. No
/// tolerance is documented. A segment whose ends are equal and a ring that has a spike or crosses itself are invalid by
/// its own is_valid, and for invalid input nothing is promised.
struct BoostGeometry {
  static constexpr const char* name = "Boost.Geometry " BOOST_LIB_VERSION;
  static constexpr auto boundary = Boundary::closed;

  using Point = bg::model::d2::point_xy<double>;
  using Segment = bg::model::segment<Point>;
  using Polygon = bg::model::polygon<Point>;

  std::optional<SegmentSegment<double>> segment_segment(const Segment2d& first, const Segment2d& second) {
    const Segment a = segment(first), b = segment(second);
    if (!bg::is_valid(a) || !bg::is_valid(b)) return std::nullopt;
    std::deque<Point> common;
    bg::intersection(a, b, common);
    if (bg::intersects(a, b) == common.empty()) {
      throw std::runtime_error(common.empty() ? "intersects() is true, intersection() is empty"
                                              : "intersects() is false, intersection() is not empty");
    }
    SegmentSegment<double> answer{SegmentRelation::disjoint, {}, {}, {}, {}};
    if (common.empty()) return answer;
    const Point2d p = point(common.front()), q = point(common.back());
    answer.relation = p == q ? SegmentRelation::point : SegmentRelation::overlap;
    if (p == q) answer.point = p;
    else answer.overlap = p.x < q.x || (p.x == q.x && p.y < q.y) ? Segment2d{p, q} : Segment2d{q, p};
    return answer;
  }

  std::optional<bool> point_on_segment(const Point2d& p, const Segment2d& s) {
    const Segment closed = segment(s);
    if (!bg::is_valid(closed)) return std::nullopt;
    return bg::covered_by(Point(p.x, p.y), closed);
  }

  Side orientation(const Point2d& p0, const Point2d& p1, const Point2d& p) {
    const int side =
        bg::strategy::side::side_by_triangle<>::apply(Point(p0.x, p0.y), Point(p1.x, p1.y), Point(p.x, p.y));
    return side > 0 ? Side::left : side < 0 ? Side::right : Side::on;
  }

  /// Where is_valid throws, `within` would answer: whether the ring is valid is not known, so it is not asked.
  std::optional<Location> point_in_polygon(const Polygon2d& ring, const Point2d& p) { return location(ring, p); }
  std::optional<Location> point_in_region(const Region2d& region, const Point2d& p) { return location(region, p); }

  std::optional<Contact> polygon_polygon(const Polygon2d& a, const Polygon2d& b) { return contact(a, b); }
  std::optional<Contact> region_region(const Region2d& a, const Region2d& b) { return contact(a, b); }

 private:
  template <class Solid>
  static std::optional<Location> location(const Solid& of, const Point2d& p) {
    const Polygon solid = polygon(of);
    try {
      if (!bg::is_valid(solid)) return std::nullopt;
    } catch (const std::exception&) {
      return std::nullopt;
    }
    const Point point(p.x, p.y);
    const bool within = bg::within(point, solid), covered = bg::covered_by(point, solid);
    if (within && !covered) throw std::runtime_error("within() is true, covered_by() is false");
    return within ? Location::inside : covered ? Location::boundary : Location::outside;
  }

  /// By what interiors and boundaries share in the DE-9IM matrix.
  template <class Solid>
  static std::optional<Contact> contact(const Solid& first, const Solid& second) {
    const Polygon a = polygon(first), b = polygon(second);
    if (!bg::is_valid(a) || !bg::is_valid(b)) return std::nullopt;
    const std::string shared = bg::relation(a, b).str();
    if (shared[0] != 'F') return Contact::overlapping;
    const bool apart = shared[1] == 'F' && shared[3] == 'F' && shared[4] == 'F';
    return apart ? Contact::disjoint : Contact::touching;
  }

  static Segment segment(const Segment2d& s) { return {Point(s.a.x, s.a.y), Point(s.b.x, s.b.y)}; }
  static Point2d point(const Point& p) { return {p.x(), p.y()}; }
  /// Closed and clockwise, as its default is: `correct` sees to both.
  static Polygon polygon(const Region2d& region) {
    Polygon solid;
    const auto fill = [](auto& made, const Polygon2d& ring) {
      for (const Point2d& p : ring.vertices) made.emplace_back(p.x, p.y);
    };
    fill(solid.outer(), region.outer);
    solid.inners().resize(region.holes.size());
    for (std::size_t i = 0; i < region.holes.size(); ++i) fill(solid.inners()[i], region.holes[i]);
    bg::correct(solid);
    return solid;
  }
  static Polygon polygon(const Polygon2d& ring) { return polygon(Region2d{ring, {}}); }
};

TOUCHSTONE_ENGINE_MAIN(BoostGeometry)
