// SPDX-License-Identifier: Apache-2.0
#include "catalogue/rows/volumes/kdop_of_points.h"

#include "proptests/space_laws.h"
#include "robust/volumes/aabb_of_points.h"
#include "robust/volumes/kdop_of_points.h"
#include "robust/volumes/point_in_kdop.h"

namespace touchstone::proptests::kdop_of_points_tests {
namespace {

using Row = rows::kdop_of_points;
using Points = Row::Points;
using Normals = Row::Normals;
using Slabs = std::vector<Slabd>;

Rational height(const Vector3d& n, const Point3d& p) {
  return exact(n.x) * exact(p.x) + exact(n.y) * exact(p.y) + exact(n.z) * exact(p.z);
}

/// Whether no double between `end` and the exact number, and not the next one either, is at that number or beyond.
bool least_above(double end, const Rational& number) {
  if (end == infinity) return number > exact(greatest);
  if (end == -infinity || exact(end) < number) return false;
  const double below = std::nextafter(end, -infinity);
  return below == -infinity || exact(below) < number;
}

void worked(const Points& points, const Normals& normals, const std::vector<Slab<Rational>>& truth, const Slabs& robust,
            const std::string& defect_of_formula = "") {
  const Row::Question q{points, normals};
  CHECK(catalogue::ask_oracle<Row>(q).answer == truth);
  CHECK(catalogue::ask_robust<Row>(q) == robust);
  CHECK(Row::defect(q, robust) == "");
  CHECK(Row::defect(q, catalogue::ask_reference<Row>(q)) == defect_of_formula);
}

/// An honest implementation in doubles: N . P, a bound on its error, and their difference rounded outwards.
Slabs with_a_bound(const Points& points, const Normals& normals) {
  Slabs slabs;
  for (const Vector3d& n : normals) {
    Slabd slab{infinity, -infinity};
    for (const Point3d& p : points) {
      const double x = n.x * p.x, y = n.y * p.y, z = n.z * p.z, value = x + y + z;
      if (!std::isfinite(value)) return {{-infinity, infinity}};
      const double bound = (3 + 0x1p-48) * 0x1p-53 * (std::fabs(x) + std::fabs(y) + std::fabs(z)) + 0x1p-1072;
      slab.min = std::min(slab.min, std::nextafter(value - bound, -infinity));
      slab.max = std::max(slab.max, std::nextafter(value + bound, infinity));
    }
    slabs.push_back(slab);
  }
  return slabs;
}

}  // namespace

ROBUST_LAW("kdop_of_points: robust answers the narrowest slabs of doubles that hold every point", points, normals) {
  const Slabs slabs = ask(asked);
  for (std::size_t i = 0; i < normals.size(); ++i) {
    std::vector<Rational> heights;
    for (const Point3d& p : points) heights.push_back(height(normals[i], p));
    const auto [least, most] = std::minmax_element(heights.begin(), heights.end());
    if (!least_above(slabs[i].max, *most) || !least_above(-slabs[i].min, Rational(-*least))) return false;
  }
  return slabs.size() == normals.size();
}

ROBUST_LAW("kdop_of_points: every point is in the k-DOP, by point_in_kdop", points, normals) {
  const Kdop3d kdop{normals, ask(asked)};
  const auto infinite = [](const Slabd& s) { return std::isinf(s.min) || std::isinf(s.max); };
  if (std::any_of(kdop.slabs.begin(), kdop.slabs.end(), infinite)) return true;
  return std::all_of(points.begin(), points.end(),
                     [&](const Point3d& p) { return robust::point_in_kdop(kdop, p) != Location::outside; });
}

LAW("kdop_of_points: the order of the points does not matter; normals and slabs keep theirs") {
  auto [points, normals] = asked;
  points.push_back(points.front());
  std::reverse(points.begin(), points.end()), std::reverse(normals.begin(), normals.end());
  auto slabs = ask(std::tuple(points, normals));
  std::reverse(slabs.begin(), slabs.end());
  return slabs == ask(asked);
}

LAW("kdop_of_points: opposite normals have opposite slabs") {
  auto [points, normals] = asked;
  for (Vector3d& n : normals) n = {-n.x, -n.y, -n.z};
  auto slabs = ask(std::tuple(points, normals));
  for (auto& slab : slabs) slab = {-slab.max, -slab.min};
  return slabs == ask(asked);
}

ROBUST_LAW("kdop_of_points: the normals x, y and z give the box of the points", points) {
  const auto [min, max] = robust::aabb_of_points(points);
  return ask(std::tuple(points, Normals{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}})) ==
         Slabs{{min.x, max.x}, {min.y, max.y}, {min.z, max.z}};
}

TEST_CASE("kdop_of_points: p. 43's slabs worked by hand") {
  worked({{1, 2, 3}, {0, 0, 0}, {4, -1, 0}}, {{1, 0, 0}, {1, 1, 1}, {0, -2, 1}}, {{0, 4}, {0, 6}, {-1, 2}},
         {{0, 4}, {0, 6}, {-1, 2}});
  worked({{1, 2, 3}}, {{1, 1, 1}}, {{6, 6}}, {{6, 6}});                        // a point: a flat slab
  worked({{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}, {{2, 2, 2}}, {{2, 2}}, {{2, 2}});  // on a plane across the normal
}

TEST_CASE("kdop_of_points: ends between two doubles are rounded outwards; the formula loses the point") {
  const Rational tail = power_of_two(-60), one = 1;
  const double above = 1 + 0x1p-52, below = 1 - 0x1p-53;
  worked({{1, 0x1p-60, 0}}, {{1, 1, 0}}, {{one + tail, one + tail}}, {{1, above}},
         "slabs[0]: points[0] is lost above max, by 8.674e-19");
  worked({{1, -0x1p-60, 0}}, {{1, 1, 0}}, {{one - tail, one - tail}}, {{below, 1}},
         "slabs[0]: points[0] is lost below min, by 8.674e-19");
  worked({{-1, -0x1p-60, 0}, {0, 0, 0}}, {{0, 0, 1}, {1, 1, 0}}, {{0, 0}, {-one - tail, 0}}, {{0, 0}, {-above, 0}},
         "slabs[1]: points[0] is lost below min, by 8.674e-19");
}

TEST_CASE("kdop_of_points: huge, subnormal and negative zero") {
  const Rational most = exact(greatest), least = exact(tiny);
  worked({{greatest, greatest, 0}}, {{1, 1, 0}}, {{2 * most, 2 * most}}, {{greatest, infinity}},
         "slabs[0]: points[0] is lost below min, by inf");
  worked({{-greatest, -1, 0}}, {{1, 1, 0}}, {{-most - 1, -most - 1}}, {{-infinity, -greatest}},
         "slabs[0]: points[0] is lost below min, by 1");
  worked({{tiny, 0, 0}}, {{0.5, 0, 0}}, {{least / 2, least / 2}}, {{0, tiny}},
         "slabs[0]: points[0] is lost above max, by 2.47e-324");
  worked({{-tiny, 0, 0}}, {{0.25, 0, 0}}, {{-least / 4, -least / 4}}, {{-tiny, 0}},
         "slabs[0]: points[0] is lost below min, by 1.235e-324");
  worked({{-0.0, 5, 5}}, {{1, 0, -0.0}}, {{0, 0}}, {{0, 0}});
}

TEST_CASE("kdop_of_points: the checker takes honest bounds, and names what is wrong") {
  const Row::Question q{{{1, 0x1p-60, 0}, {0, 0, 0}}, {{1, 1, 0}, {0, 0, 1}}};
  const double above = 1 + 0x1p-52;
  CHECK(Row::defect(q, {{0, above}, {0, 0}}) == "");
  CHECK(Row::defect(q, {{-0x1p-1074, 1 + 0x1p-50}, {0, 0x1p-1070}}) == "");  // 4 u, 9 u are allowed
  CHECK(Row::defect(q, {{0, 1 + 0x1p-49}, {0, 0}}) == "slabs[0]: max is too far out: 1.775e-15, allowed are 9.992e-16");
  CHECK(Row::defect(q, {{0, above}, {0, 1}}) == "slabs[1]: max is too far out: 1, allowed are 7.905e-323");
  CHECK(Row::defect(q, {{0, above}, {-infinity, 0}}) == "slabs[1]: min is infinite, which is too far out");
  CHECK(Row::defect(q, {{0, 2}, {0, -tiny}}) ==
        "slabs[1]: points[1] is lost above max, by 4.941e-324");  // before others
  CHECK(Row::defect(q, {{0, not_a_number}, {0, 0}}) == "slabs[0]: not a number");
  CHECK(Row::defect(q, {{0, above}}) == "not as many slabs as normals");
  robust_law<Row>("honest bounds", [](const auto&, const auto& asked) {
    const auto& [points, normals] = asked;
    const Slabs slabs = with_a_bound(points, normals);
    const auto defined = [](const Slabd& s) { return std::isfinite(s.min) && std::isfinite(s.max); };
    return !std::all_of(slabs.begin(), slabs.end(), defined) || Row::defect(asked, slabs).empty();
  });
}

TEST_CASE("kdop_of_points: a lost point is the formula's rounding, and the verdict says which and by how much") {
  const auto judged = examined<Row>({{{1, 0x1p-60, 0}}, {{1, 1, 0}}})->judge_reference();
  CHECK(judged.verdict == catalogue::Verdict::rounding);
  CHECK(judged.remark == "slabs[0]: points[0] is lost above max, by 8.674e-19");
}

CONTRACT("kdop_of_points: the formula in double keeps its contract and is right in exact arithmetic", points, all) {
  const auto& slabs = answer;
  for (std::size_t i = 0; i < all.size(); ++i) {
    Rational size;
    for (const Point3d& p : points) {
      const Vector3d& n = all[i];
      const double x = n.x * p.x, y = n.y * p.y, z = n.z * p.z;
      if (!finite(x, y, z, x + y, x + y + z)) return true;
      const Rational sum = abs(exact(n.x) * exact(p.x)) + abs(exact(n.y) * exact(p.y)) + abs(exact(n.z) * exact(p.z));
      size = std::max(size, sum);
    }
    const Rational u = unit(), e = (3 + 8 * u) * u * size + power_of_two(-1073);
    if (!within(slabs[i].min, truth.answer[i].min, e) || !within(slabs[i].max, truth.answer[i].max, e)) return false;
  }
  return true;
}

TEST_CASE("kdop_of_points: the formula is right in exact arithmetic") { right_in_exact_arithmetic<Row>(); }

}  // namespace touchstone::proptests::kdop_of_points_tests
