// SPDX-License-Identifier: Apache-2.0
#include "proptests/infrastructure/judge/usual_formulas.h"

#include "audit/gate/gate.h"
#include "catalogue/rows/mixed/capsule_capsule.h"
#include "catalogue/rows/mixed/closest_point_on_triangle.h"
#include "catalogue/rows/mixed/ray_aabb.h"
#include "catalogue/rows/mixed/ray_triangle.h"
#include "catalogue/rows/mixed/segment_aabb.h"
#include "catalogue/rows/mixed/segment_segment_distance.h"
#include "catalogue/rows/mixed/sphere_capsule.h"
#include "catalogue/rows/mixed/sphere_triangle.h"
#include "catalogue/rows/mixed/triangle_aabb.h"
#include "catalogue/rows/polyhedra/segment_triangle.h"
#include "catalogue/rows/volumes/obb_obb.h"
#include "catalogue/rows/volumes/point_in_obb.h"
#include "proptests/catch.h"
#include "proptests/infrastructure/judge/by_hand.h"
#include "proptests/infrastructure/judge/foreign_formulas.h"

/// Engines of usual formulas: the gate that docs/gate.md recommends lets the right ones pass, and none with a bug.
namespace touchstone::proptests::usual_formulas_tests {
namespace {

namespace rows = catalogue::rows;
using usual::Bound;

const Asking asking{.each = 40};

/// `--fail-on algorithm,invalid,inconsistent_convention --range ordinary`
bool passes(const Tally& tally) {
  return held_against(tally, Gate{.causes = causes_named("algorithm,invalid,inconsistent_convention")}).passed();
}
template <class Row, class Formula>
void passes(const Formula& formula) {
  const Tally tally = audited<Row>(formula, asking);
  const Cell total = tally.operations[0].total();
  INFO(Row::metadata.name << ": " << total.count(Verdict::algorithm) << " algorithm, " << total.touches_open
                          << " clear touches as open sets");
  CHECK(total.count(Verdict::agree) > total.cases() / 2);
  CHECK(passes(tally));
}
/// Named as what it is, more often than as rounding.
template <class Row, class Formula>
void is_caught(const Formula& bug) {
  const Tally tally = audited<Row>(bug, asking);
  const Cell total = tally.operations[0].total();
  INFO(Row::metadata.name << ": " << total.count(Verdict::algorithm) << " algorithm, " << total.count(Verdict::rounding)
                          << " rounding");
  CHECK(total.count(Verdict::algorithm) > 5);
  CHECK_FALSE(passes(tally));
}

constexpr auto closest_pair = [](const auto& a, const auto& b, bool clamps) {
  using Pair = std::conditional_t<std::is_same_v<std::decay_t<decltype(a)>, Segment2d>, ClosestPair2<double>,
                                  ClosestPair3<double>>;
  return std::variant<ClosestPair2<double>, ClosestPair3<double>>(usual::closest_pair<Pair>(a, b, clamps));
};
constexpr auto ray_in_slabs = [](const auto& ray, const auto& box, Bound how) {
  return usual::through(usual::Slabs(std::numeric_limits<double>::infinity(), how), ray.origin, ray.direction, box);
};
constexpr auto segment_in_slabs = [](const auto& segment, const auto& box, Bound how) {
  return usual::through(usual::Slabs(1, how), segment.a, segment.b - segment.a, box);
};

/// Both of a formula that compares as closed sets do and of its bug.
template <class Row, class Formula>
void differs_from_open(const Formula& formula) {
  passes<Row>([&](const auto&... q) { return formula(q..., Bound::closed); });
  is_caught<Row>([&](const auto&... q) { return formula(q..., Bound::open); });
}

}  // namespace

TEST_CASE("usual formulas: a ray and a triangle, a segment and a triangle (Moeller and Trumbore)") {
  differs_from_open<rows::ray_triangle>(usual::ray_triangle);
  differs_from_open<rows::segment_triangle>(usual::segment_triangle);
}

TEST_CASE("usual formulas: nearest points of segments and triangles (Ericson), and what they decide") {
  passes<rows::segment_segment_distance>([](const auto& a, const auto& b) { return closest_pair(a, b, true); });
  is_caught<rows::segment_segment_distance>([](const auto& a, const auto& b) { return closest_pair(a, b, false); });
  passes<rows::closest_point_on_triangle>(usual::closest_point_on_triangle);
  differs_from_open<rows::capsule_capsule>(usual::capsule_capsule);
  differs_from_open<rows::sphere_capsule>(usual::sphere_capsule);
  differs_from_open<rows::sphere_triangle>(usual::sphere_triangle);
}

TEST_CASE("usual formulas: rays and segments through boxes, by slabs") {
  differs_from_open<rows::ray_aabb>(ray_in_slabs);
  differs_from_open<rows::segment_aabb>(segment_in_slabs);
}

TEST_CASE("usual formulas: boxes in any orientation, and a triangle in a box, by separating axes") {
  const auto boxes = [](const Obb3d& a, const Obb3d& b, Bound how) { return usual::obb_obb(a, b, how); };
  differs_from_open<rows::obb_obb>(boxes);
  is_caught<rows::obb_obb>([](const Obb3d& a, const Obb3d& b) { return usual::obb_obb(a, b, Bound::closed, false); });
  differs_from_open<rows::point_in_obb>(usual::point_in_obb);
  passes<rows::triangle_aabb>([](const Triangle3d& t, const Aabb3d& b) { return usual::triangle_aabb(t, b); });
  is_caught<rows::triangle_aabb>(
      [](const Triangle3d& t, const Aabb3d& b) { return usual::triangle_aabb(t, b, false); });
}

TEST_CASE("usual formulas: a touch on which one of them is in doubt says nothing of the convention") {
  // Down on an edge of a triangle with the determinant 3, whose reciprocal is rounded: u + v = 1 is in doubt, v = 0
  // is not.
  const auto ray_from = [](const char* origin) {
    const std::string question = std::string(R"({"ray":{"origin":)") + origin +
                                 R"(,"direction":[0,0,-1]},"triangle":[[0,0,0],[3,0,0],[0,1,0]]})";
    return Case{"ray_triangle", question.c_str()}.judge(R"({"relation":"none"})");
  };
  const Judgement in_doubt = ray_from("[1.5,0.5,1]"), clear = ray_from("[1.5,0,1]");
  for (const Judgement& touch : {in_doubt, clear}) {
    CHECK(touch.verdict == Verdict::convention);
    CHECK(touch.touch_reading == -1);
  }
  CHECK_FALSE(in_doubt.clear);
  CHECK(clear.clear);
  const Operation& operation = operation_of_row<rows::ray_triangle>();
  Cell cell;
  count(cell, {operation, operation.zeros(), "point"}, in_doubt);
  CHECK(cell.touches_open == 0);
  count(cell, {operation, operation.zeros(), "point"}, clear);
  CHECK(cell.touches_open == 1);
}

TEST_CASE("usual formulas: without the judge's knowledge of them right ones are accused") {
  RowFunctions alone = operation_of_row<rows::ray_triangle>().row();
  REQUIRE_FALSE(alone.standard.empty());
  alone.standard.clear();
  const Operation operation(alone);
  const auto formula = [](const Ray3d& ray, const Triangle3d& t) { return usual::ray_triangle(ray, t); };
  CHECK_FALSE(passes(audited<rows::ray_triangle>(formula, {.each = 40, .operation = &operation})));
}

}  // namespace touchstone::proptests::usual_formulas_tests
