// SPDX-License-Identifier: Apache-2.0
// CGAL as peer: its kernel over plain doubles, which the manual offers for speed and does not call robust.
#include <CGAL/Simple_cartesian.h>
#include <CGAL/intersections.h>

#include <stdexcept>

#include "audit/engines/adapter.h"

using namespace touchstone;

/// Segments and rays are closed; no tolerance. Degenerate segments and rays are left out where two objects are
/// intersected: its functions assume that the two have a direction (without NDEBUG some fail an assertion on them).
struct CgalDouble {
  static constexpr const char* name = "CGAL Simple_cartesian<double> " CGAL_VERSION_STR;
  static constexpr auto boundary = Boundary::closed;

  using Kernel = CGAL::Simple_cartesian<double>;
  using Point = Kernel::Point_2;

  std::optional<SegmentSegment<double>> segment_segment(const Segment2d& first, const Segment2d& second) {
    const Kernel::Segment_2 a = segment(first), b = segment(second);
    if (a.is_degenerate() || b.is_degenerate()) return std::nullopt;
    SegmentSegment<double> answer{SegmentRelation::disjoint, {}, {}, {}, {}};
    const auto common = CGAL::intersection(a, b);
    contradiction(CGAL::do_intersect(a, b), common.has_value());
    if (!common) return answer;
    if (const auto* meeting = boost::get<Point>(&*common)) {
      answer.relation = SegmentRelation::point;
      answer.point = back(*meeting);
    } else {
      const auto& shared = boost::get<Kernel::Segment_2>(*common);
      answer.relation = SegmentRelation::overlap;
      answer.overlap = Segment2d{back(shared.min()), back(shared.max())};
    }
    return answer;
  }

  /// CGAL keeps a ray as its origin and a second point: only where origin + direction is exact is it the same ray.
  std::optional<RaySegment<double>> ray_segment(const Ray2d& r, const Segment2d& s) {
    const Point2d second = r.origin + r.direction;
    if (!exact_sum(r.origin.x, r.direction.x, second.x) || !exact_sum(r.origin.y, r.direction.y, second.y))
      return std::nullopt;
    const Kernel::Ray_2 ray(point(r.origin), point(second));
    const Kernel::Segment_2 other = segment(s);
    if (ray.is_degenerate() || other.is_degenerate()) return std::nullopt;
    RaySegment<double> answer{RayRelation::none, {}, {}, {}};
    const auto common = CGAL::intersection(ray, other);
    contradiction(CGAL::do_intersect(ray, other), common.has_value());
    if (!common) return answer;
    if (const auto* meeting = boost::get<Point>(&*common)) {
      answer.relation = RayRelation::point;
      answer.point = back(*meeting);
    } else {
      const auto& shared = boost::get<Kernel::Segment_2>(*common);
      answer.relation = RayRelation::overlap;
      const Point2d p = back(shared.source()), q = back(shared.target());
      const bool forward = r.direction.x != 0 ? (p.x < q.x) == (r.direction.x > 0) : (p.y < q.y) == (r.direction.y > 0);
      answer.overlap = forward ? Segment2d{p, q} : Segment2d{q, p};
    }
    return answer;
  }

  LineLine<double> line_line(const Line2d& first, const Line2d& second) {
    const auto common = CGAL::intersection(line(first), line(second));
    if (!common) return {LineRelation::parallel, {}, {}, {}};
    if (const auto* meeting = boost::get<Point>(&*common)) return {LineRelation::crossing, {}, {}, back(*meeting)};
    return {LineRelation::same, {}, {}, {}};
  }

  bool point_on_segment(const Point2d& p, const Segment2d& s) { return segment(s).has_on(point(p)); }

  Side orientation(const Point2d& p0, const Point2d& p1, const Point2d& p) {
    const CGAL::Orientation turn = CGAL::orientation(point(p0), point(p1), point(p));
    return turn == CGAL::LEFT_TURN ? Side::left : turn == CGAL::RIGHT_TURN ? Side::right : Side::on;
  }

 private:
  static Point point(const Point2d& p) { return {p.x, p.y}; }
  static Point2d back(const Point& p) { return {p.x(), p.y()}; }
  static Kernel::Segment_2 segment(const Segment2d& s) { return {point(s.a), point(s.b)}; }
  static Kernel::Line_2 line(const Line2d& l) { return {point(l.p), point(l.q)}; }

  static bool exact_sum(double a, double b, double sum) {
    return audit::exact_value(a) + audit::exact_value(b) == audit::exact_value(sum);
  }
  static void contradiction(bool do_intersect, bool intersection) {
    if (do_intersect == intersection) return;
    throw std::runtime_error(do_intersect ? "do_intersect() is true, intersection() is empty"
                                          : "do_intersect() is false, intersection() is not empty");
  }
};

TOUCHSTONE_ENGINE_MAIN(CgalDouble)
