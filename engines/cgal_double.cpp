// SPDX-License-Identifier: Apache-2.0
// CGAL as peer: its kernel over plain doubles, which the manual offers for speed and does not call robust.
#include <CGAL/Polygon_2_algorithms.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/intersections.h>
#include <gmpxx.h>
#include <touchstone/program/engine_main.h>

#include <boost/variant/get.hpp>
#include <stdexcept>
#include <variant>

using namespace touchstone;

/// What an intersection is, if it is one of these; nullptr else. It is a variant of Boost until CGAL 5, of std from 6
/// on.
template <class Shape, template <class...> class Variant, class... Shapes>
const Shape* held(const Variant<Shapes...>& common) {
  if constexpr (std::is_same_v<Variant<Shapes...>, std::variant<Shapes...>>) return std::get_if<Shape>(&common);
  else return boost::get<Shape>(&common);
}

/// Sets are closed; no tolerance. Degenerate segments, rays and triangles are left out where two objects are
/// intersected: its functions assume that they have none (without NDEBUG some fail an assertion on them).
struct CgalDouble {
  static constexpr const char* name = "CGAL Simple_cartesian<double> " CGAL_VERSION_STR;
  static constexpr auto boundary = Boundary::closed;

  using Kernel = CGAL::Simple_cartesian<double>;
  using Point = Kernel::Point_2;
  using Spatial = Kernel::Point_3;

  std::optional<SegmentSegment<double>> segment_segment(const Segment2d& first, const Segment2d& second) {
    const Kernel::Segment_2 a = segment(first), b = segment(second);
    if (a.is_degenerate() || b.is_degenerate()) return std::nullopt;
    SegmentSegment<double> answer{SegmentRelation::disjoint, {}, {}, {}, {}};
    const auto common = CGAL::intersection(a, b);
    contradiction(CGAL::do_intersect(a, b), common.has_value());
    if (!common) return answer;
    if (const auto* meeting = held<Point>(*common)) {
      answer.relation = SegmentRelation::point;
      answer.point = back(*meeting);
    } else {
      const auto& shared = *held<Kernel::Segment_2>(*common);
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
    if (const auto* meeting = held<Point>(*common)) {
      answer.relation = RayRelation::point;
      answer.point = back(*meeting);
    } else {
      const auto& shared = *held<Kernel::Segment_2>(*common);
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
    if (const auto* meeting = held<Point>(*common)) return {LineRelation::crossing, {}, {}, back(*meeting)};
    return {LineRelation::same, {}, {}, {}};
  }

  bool point_on_segment(const Point2d& p, const Segment2d& s) { return segment(s).has_on(point(p)); }

  Side orientation(const Point2d& p0, const Point2d& p1, const Point2d& p) {
    const CGAL::Orientation turn = CGAL::orientation(point(p0), point(p1), point(p));
    return turn == CGAL::LEFT_TURN ? Side::left : turn == CGAL::RIGHT_TURN ? Side::right : Side::on;
  }

  /// By the odd-even rule, for any ring: so its documentation.
  Location point_in_polygon(const Polygon2d& polygon, const Point2d& p) {
    const std::vector<Point> ring = points(polygon);
    const CGAL::Bounded_side side = CGAL::bounded_side_2(ring.begin(), ring.end(), point(p), Kernel());
    return side == CGAL::ON_BOUNDED_SIDE ? Location::inside
           : side == CGAL::ON_BOUNDARY   ? Location::boundary
                                         : Location::outside;
  }

  /// is_simple, is_convex and orientation of a ring; whether a corner is flat and all vertices are on one line, by
  /// `collinear`.
  PolygonConvexity polygon_convexity(const Polygon2d& polygon) {
    const std::vector<Point> ring = points(polygon);
    const std::size_t n = ring.size();
    bool repeated = false, on_a_line = true, flat = false;
    for (std::size_t i = 0; i < n; ++i) {
      const Point &p = ring[i], &q = ring[(i + 1) % n];
      repeated = repeated || p == q;
      flat = flat || CGAL::collinear(p, q, ring[(i + 2) % n]);
      for (std::size_t k = i + 2; k < n && on_a_line; ++k) on_a_line = CGAL::collinear(p, q, ring[k]);
    }
    if (repeated || on_a_line) return {PolygonClass::degenerate, false, Winding::none};
    const bool simple = CGAL::is_simple_2(ring.begin(), ring.end(), Kernel());
    if (!simple) return {PolygonClass::not_simple, false, Winding::none};
    const CGAL::Orientation turn = CGAL::orientation_2(ring.begin(), ring.end(), Kernel());
    const bool convex = CGAL::is_convex_2(ring.begin(), ring.end(), Kernel());
    return {convex ? PolygonClass::convex : PolygonClass::concave, convex && !flat,
            turn == CGAL::COUNTERCLOCKWISE ? Winding::ccw
            : turn == CGAL::CLOCKWISE      ? Winding::cw
                                           : Winding::none};
  }

  /// Triangles alone: what it has for more vertices is in packages under the GPL, which are not used here.
  std::optional<Contact> polygon_polygon(const Polygon2d& first, const Polygon2d& second) {
    if (first.size() != 3 || second.size() != 3) return std::nullopt;
    const Kernel::Triangle_2 a = triangle(first), b = triangle(second);
    if (a.is_degenerate() || b.is_degenerate()) return std::nullopt;
    const auto common = CGAL::intersection(a, b);
    contradiction(CGAL::do_intersect(a, b), common.has_value());
    if (!common) return Contact::disjoint;
    const bool thin = held<Point>(*common) != nullptr || held<Kernel::Segment_2>(*common) != nullptr;
    return thin ? Contact::touching : Contact::overlapping;
  }

  /// Triangles alone, as above.
  std::optional<PolygonNormal<double>> polygon_normal(const Polygon3d& polygon) {
    if (polygon.size() != 3) return std::nullopt;
    const Spatial p = point(polygon[0]), q = point(polygon[1]), r = point(polygon[2]);
    if (CGAL::collinear(p, q, r)) return PolygonNormal<double>{NormalClass::degenerate, {}, {}};
    const Kernel::Vector_3 normal = CGAL::normal(p, q, r), unit = CGAL::unit_normal(p, q, r);
    return PolygonNormal<double>{NormalClass::proper, Vector3d{normal.x(), normal.y(), normal.z()},
                                 Vector3d{unit.x(), unit.y(), unit.z()}};
  }

  PlaneSide point_plane(const Plane3d& plane, const Point3d& p) { return side(plane, p); }

  /// Where plane and segment meet, which is the first contact unless the start is behind the plane already.
  std::optional<PointPlaneToi<double>> point_plane_toi(const Plane3d& plane, const Point3d& start, const Point3d& end) {
    const Kernel::Segment_3 step(point(start), point(end));
    if (step.is_degenerate() || side(plane, start) == PlaneSide::back) return std::nullopt;
    PointPlaneToi<double> answer{{side(plane, end) == PlaneSide::front ? HitRelation::never : HitRelation::hit},
                                 {HitRelation::never, {}, {}}};
    const auto common = CGAL::intersection(kernel_plane(plane), step);
    contradiction(CGAL::do_intersect(kernel_plane(plane), step), common.has_value());
    if (!common) return answer;
    const auto* meeting = held<Spatial>(*common);
    answer.option_2 = {HitRelation::hit, {}, meeting ? Point3d{meeting->x(), meeting->y(), meeting->z()} : start};
    return answer;
  }

  std::optional<SegmentTriangle<double>> segment_triangle(const Segment3d& s, const Triangle3d& t) {
    const Kernel::Segment_3 edge(point(s.a), point(s.b));
    const Kernel::Triangle_3 face = triangle(t);
    if (edge.is_degenerate() || face.is_degenerate()) return std::nullopt;
    SegmentTriangle<double> answer{SegmentTriangleRelation::none, {}, {}, {}};
    const auto common = CGAL::intersection(edge, face);
    contradiction(CGAL::do_intersect(edge, face), common.has_value());
    if (!common) return answer;
    if (const auto* meeting = held<Spatial>(*common)) {
      answer.relation = SegmentTriangleRelation::point;
      answer.point = back(*meeting);
    } else {
      const auto& shared = *held<Kernel::Segment_3>(*common);
      answer.relation = SegmentTriangleRelation::segment;
      const bool forward = edge.to_vector() * shared.to_vector() > 0;
      const Point3d p = back(shared.source()), q = back(shared.target());
      answer.overlap = forward ? Segment3d{p, q} : Segment3d{q, p};
    }
    return answer;
  }

  std::optional<RayTriangle<double>> ray_triangle(const Ray3d& r, const Triangle3d& t) {
    const auto ray = kernel_ray(r);
    const Kernel::Triangle_3 face = triangle(t);
    if (!ray || face.is_degenerate()) return std::nullopt;
    RayTriangle<double> answer{SegmentTriangleRelation::none, {}, {}, {}};
    const auto common = CGAL::intersection(*ray, face);
    contradiction(CGAL::do_intersect(*ray, face), common.has_value());
    if (!common) return answer;
    const auto* meeting = held<Spatial>(*common);
    answer.relation = meeting ? SegmentTriangleRelation::point : SegmentTriangleRelation::segment;
    if (meeting) answer.point = back(*meeting);
    return answer;
  }
  std::optional<bool> ray_aabb(const Ray3d& r, const Aabb3d& box) {
    const auto ray = kernel_ray(r);
    if (!ray) return std::nullopt;
    return CGAL::do_intersect(*ray, Kernel::Iso_cuboid_3(point(box.min), point(box.max)));
  }
  std::optional<bool> segment_aabb(const Segment3d& s, const Aabb3d& box) {
    const Kernel::Segment_3 edge(point(s.a), point(s.b));
    if (edge.is_degenerate()) return std::nullopt;
    return CGAL::do_intersect(edge, Kernel::Iso_cuboid_3(point(box.min), point(box.max)));
  }
  std::optional<ClosestPoint3<double>> closest_point_on_triangle(const Point3d& p, const Triangle3d& t) {
    const Kernel::Triangle_3 face = triangle(t);
    if (face.is_degenerate()) return std::nullopt;
    return nearest(point(p), face);
  }
  std::optional<ClosestPoint3<double>> closest_point_on_segment(const Point3d& p, const Segment3d& s) {
    const Kernel::Segment_3 edge(point(s.a), point(s.b));
    if (edge.is_degenerate()) return std::nullopt;
    return nearest(point(p), edge);
  }

  std::optional<TriangleTriangleRelation> triangle_triangle(const Triangle3d& first, const Triangle3d& second) {
    const Kernel::Triangle_3 a = triangle(first), b = triangle(second);
    if (a.is_degenerate() || b.is_degenerate()) return std::nullopt;
    const auto common = CGAL::intersection(a, b);
    contradiction(CGAL::do_intersect(a, b), common.has_value());
    if (!common) return TriangleTriangleRelation::none;
    return held<Spatial>(*common)             ? TriangleTriangleRelation::point
           : held<Kernel::Segment_3>(*common) ? TriangleTriangleRelation::segment
                                              : TriangleTriangleRelation::area;
  }

 private:
  static Point point(const Point2d& p) { return {p.x, p.y}; }
  static Point2d back(const Point& p) { return {p.x(), p.y()}; }
  static Kernel::Segment_2 segment(const Segment2d& s) { return {point(s.a), point(s.b)}; }
  static Kernel::Line_2 line(const Line2d& l) { return {point(l.p), point(l.q)}; }

  static Spatial point(const Point3d& p) { return {p.x, p.y, p.z}; }
  static Point3d back(const Spatial& p) { return {p.x(), p.y(), p.z()}; }
  static Kernel::Triangle_3 triangle(const Triangle3d& t) { return {point(t.a), point(t.b), point(t.c)}; }
  static std::vector<Point> points(const Polygon2d& polygon) {
    std::vector<Point> ring;
    for (const Point2d& p : polygon.vertices) ring.push_back(point(p));
    return ring;
  }
  static Kernel::Triangle_2 triangle(const Polygon2d& p) { return {point(p[0]), point(p[1]), point(p[2])}; }
  static Kernel::Plane_3 kernel_plane(const Plane3d& plane) {
    return {plane.normal.x, plane.normal.y, plane.normal.z, plane.offset};
  }
  static PlaneSide side(const Plane3d& plane, const Point3d& p) {
    const CGAL::Oriented_side side = kernel_plane(plane).oriented_side(point(p));
    return side == CGAL::ON_POSITIVE_SIDE   ? PlaneSide::front
           : side == CGAL::ON_NEGATIVE_SIDE ? PlaneSide::back
                                            : PlaneSide::on;
  }

  /// Only where origin + direction is exact.
  static std::optional<Kernel::Ray_3> kernel_ray(const Ray3d& r) {
    const Point3d second = r.origin + r.direction;
    if (!exact_sum(r.origin.x, r.direction.x, second.x) || !exact_sum(r.origin.y, r.direction.y, second.y) ||
        !exact_sum(r.origin.z, r.direction.z, second.z))
      return std::nullopt;
    return Kernel::Ray_3(point(r.origin), point(second));
  }
  template <class Shape>
  static ClosestPoint3<double> nearest(const Spatial& p, const Shape& shape) {
    const double square = CGAL::squared_distance(p, shape);
    return {back(Kernel().construct_projected_point_3_object()(shape, p)), square, std::sqrt(square)};
  }

  static bool exact_sum(double a, double b, double sum) {
    return mpq_class(a) + mpq_class(b) == mpq_class(sum);
  }
  static void contradiction(bool do_intersect, bool intersection) {
    if (do_intersect == intersection) return;
    throw std::runtime_error(do_intersect ? "do_intersect() is true, intersection() is empty"
                                          : "do_intersect() is false, intersection() is not empty");
  }
};

TOUCHSTONE_ENGINE_MAIN(CgalDouble)
