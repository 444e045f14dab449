// SPDX-License-Identifier: Apache-2.0
#include "catalogue/rows/polygons/convex_partition.h"
#include "catalogue/rows/polygons/triangulate_polygon.h"
#include "catalogue/rows/volumes/bounding_sphere.h"
#include "catalogue/rows/volumes/convex_hull.h"
#include "catalogue/rows/volumes/convex_hull_2d.h"
#include "catalogue/rows/volumes/kdop_of_points.h"
#include "catalogue/rows/volumes/obb_of_points.h"
#include "proptests/catch.h"
#include "proptests/infrastructure/judge/foreign_formulas.h"

/// Answers that a checker refuses: bugs are no rounding, and what rounding spoils is no bug.
namespace touchstone::proptests::planted_defects_tests {
namespace {

namespace rows = catalogue::rows;
namespace robust = ::touchstone::robust;
using Points = std::vector<Point3d>;
using Pieces = std::vector<std::vector<Index>>;

/// At least that share is wrong by `algorithm`, and a third of that at most by `rounding`: questions whose points are
/// an ulp from a plane are asked on purpose.
template <class Row, class Formula>
void is_seen(double share, const Formula& formula, bool binary32 = false) {
  const Cell total = audited<Row>(formula, {.each = 30, .binary32 = binary32}).operations[0].total();
  const auto part = [&](std::uint64_t n) { return static_cast<double>(n) / static_cast<double>(total.cases()); };
  INFO(Row::metadata.name << ": " << total.cases() << " cases, " << total.count(Verdict::algorithm) << " algorithm, "
                          << total.count(Verdict::rounding) << " rounding");
  CHECK(part(total.count(Verdict::algorithm)) >= share);
  CHECK(3 * total.count(Verdict::rounding) <= total.count(Verdict::algorithm));
}

/// Where the textbook formula fails by rounding alone and its answer is well formed, it is not accused when somebody
/// else gives it.
template <class Row>
void is_excused() {
  std::uint64_t excused = 0;
  const RowFunctions& row = operation_of_row<Row>().row();
  const auto textbook = [](const auto&... q) { return Row::reference(q...); };
  audited<Row>(textbook, {.each = 60}, [&](const Examination& question, const Judgement& judgement) {
    if (question.judge_reference().verdict != Verdict::rounding) return;
    const Excess excess = row.excess(question.question(), question.formula(), question.nearest_truth());
    INFO(one_line(question.operation().print(question.question())) << ": " << judgement.remark);
    CHECK(judgement.verdict == (excess ? Verdict::rounding : Verdict::algorithm));
    excused += judgement.verdict == Verdict::rounding;
  });
  INFO(row.metadata->name);
  CHECK(excused > 0);
}

ConvexHull inwards(const Points& points) {
  ConvexHull hull = robust::convex_hull(points);
  if (!hull.faces) return {3, {}, {}, {}, std::vector<Face>()};
  for (Face& face : *hull.faces) std::swap(face.b, face.c);
  return hull;
}
ConvexHull one_face_less(const Points& points) {
  ConvexHull hull = robust::convex_hull(points);
  if (hull.faces) hull.faces->pop_back();
  return hull;
}
ConvexHull segment_alone(const Points& points) {
  return {1, {}, IndexPair{0, static_cast<Index>(points.size() - 1)}, {}, {}};
}
ConvexHull2 clockwise(const std::vector<Point2d>& points) {
  ConvexHull2 hull = robust::convex_hull_2d(points);
  if (hull.polygon) std::reverse(hull.polygon->begin(), hull.polygon->end());
  return hull;
}
Pieces fan(const Polygon2d& polygon) {
  Pieces pieces;
  for (Index i = 1; i + 1 < polygon.size(); ++i) pieces.push_back({0, i, i + 1});
  return pieces;
}
Pieces one_piece_less(Pieces pieces) {
  pieces.pop_back();
  return pieces;
}

}  // namespace

TEST_CASE("planted defects: hulls whose faces look inwards, lack a face, or know one dimension") {
  is_seen<rows::convex_hull>(0.9, inwards);
  is_seen<rows::convex_hull>(0.7, inwards, true);
  is_seen<rows::convex_hull>(0.5, one_face_less);
  is_seen<rows::convex_hull>(0.5, segment_alone);
  is_seen<rows::convex_hull_2d>(0.5, clockwise);
}

TEST_CASE("planted defects: polygons cut from one corner whatever their shape, and with a piece left out") {
  is_seen<rows::triangulate_polygon>(0.2, fan);
  is_seen<rows::triangulate_polygon>(0.95,
                                     [](const Polygon2d& p) { return one_piece_less(robust::triangulate_polygon(p)); });
  is_seen<rows::convex_partition>(0.95, [](const Polygon2d& p) { return one_piece_less(robust::convex_partition(p)); });
}

TEST_CASE("planted defects: balls, slabs and boxes that are too small, too large or elsewhere") {
  const auto ball = [](double factor, double moved) {
    return [=](const Points& points, const std::optional<SphereMethod>& method) {
      Sphere3d found = robust::bounding_sphere(points, method.value_or(SphereMethod::smallest));
      found.radius *= factor;
      found.center.x += moved;
      return found;
    };
  };
  is_seen<rows::bounding_sphere>(0.8, ball(0.5, 0));
  is_seen<rows::bounding_sphere>(0.8, ball(0.999999, 0));
  is_seen<rows::bounding_sphere>(0.8, ball(3, 0));
  is_seen<rows::kdop_of_points>(0.6, [](const Points& points, const std::vector<Vector3d>& normals) {
    std::vector<Slabd> slabs = robust::kdop_of_points(points, normals);
    for (Slabd& slab : slabs) std::swap(slab.min, slab.max);
    return slabs;
  });
  const auto box = [](double factor) {
    return [=](const Points& points) {
      Obb3d found = robust::obb_of_points(points);
      found.half_axes.u = factor * found.half_axes.u;
      return found;
    };
  };
  is_seen<rows::obb_of_points>(0.6, box(0.9));
  is_seen<rows::obb_of_points>(0.6, box(1.1));
}

TEST_CASE("planted defects: what rounding spoils in a textbook formula is no defect of who uses it") {
  is_excused<rows::convex_hull>();
  is_excused<rows::convex_hull_2d>();
  is_excused<rows::triangulate_polygon>();
  is_excused<rows::convex_partition>();
  is_excused<rows::kdop_of_points>();
  is_excused<rows::bounding_sphere>();
  is_excused<rows::obb_of_points>();
}

}  // namespace touchstone::proptests::planted_defects_tests
