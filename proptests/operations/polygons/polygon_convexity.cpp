// SPDX-License-Identifier: Apache-2.0
#include "catalogue/rows/polygons/polygon_convexity.h"

#include <cstdint>
#include <numeric>

#include "catalogue/families/rings.h"
#include "catalogue/operation/probes/explained.h"
#include "catalogue/rows/polygons/polygon_convexity_interior_angles.h"
#include "proptests/closed_rings.h"
#include "proptests/forward_error.h"
#include "robust/polygons/polygon_convexity.h"
#include "robust/rings/simple.h"

namespace touchstone::proptests::polygon_convexity_tests {
namespace {

using Row = rows::polygon_convexity;
using ByAngles = rows::polygon_convexity_interior_angles;

constexpr PolygonConvexity convex_ccw{PolygonClass::convex, true, Winding::ccw},
    convex_cw{PolygonClass::convex, true, Winding::cw}, flat_ccw{PolygonClass::convex, false, Winding::ccw},
    flat_cw{PolygonClass::convex, false, Winding::cw}, concave_ccw{PolygonClass::concave, false, Winding::ccw},
    concave_cw{PolygonClass::concave, false, Winding::cw}, not_simple{PolygonClass::not_simple, false, Winding::none},
    degenerate{PolygonClass::degenerate, false, Winding::none};

PolygonConvexity turned_over(PolygonConvexity answer) {
  answer.orientation = answer.orientation == Winding::ccw  ? Winding::cw
                       : answer.orientation == Winding::cw ? Winding::ccw
                                                           : Winding::none;
  return answer;
}

/// A worked example for both methods of the deck.
void both(const Polygon2d& polygon, const PolygonConvexity& expected, const std::string& by_lines = "agree",
          const std::string& by_angles = "agree") {
  example<Row>({polygon}, expected, by_lines);
  example<ByAngles>({polygon}, expected, by_angles);
}

}  // namespace

LAW("polygon_convexity: the ring from another vertex on is the same, the other way round it turns over") {
  const PolygonConvexity answer = ask(asked);
  Polygon2d ring = opened(std::get<0>(asked));
  if (repeats(ring)) return true;
  std::rotate(ring.vertices.begin(), ring.vertices.begin() + 1, ring.vertices.end());
  if (!equal(ask(Row::Question{ring}), answer)) return false;
  std::reverse(ring.vertices.begin(), ring.vertices.end());
  return equal(ask(Row::Question{ring}), turned_over(answer));
}

LAW("polygon_convexity: a repeated vertex makes a ring degenerate, a spike makes it no longer simple", ring) {
  const PolygonConvexity answer = ask(asked);
  Polygon2d repeated = ring, spiked = ring;
  repeated.vertices.insert(repeated.vertices.begin(), Point2d(ring[0]));
  if (!equal(ask(Row::Question{repeated}), degenerate)) return false;
  if (answer.polygon_class == PolygonClass::degenerate) return true;
  // Along the first edge and back: one of those detours lies on the ring itself.
  spiked.vertices.insert(spiked.vertices.begin(), {ring[0], ring[1]});
  return equal(ask(Row::Question{spiked}), not_simple);
}

LAW("polygon_convexity: a vertex in the middle of an edge takes strictness away and nothing else") {
  if (!on_lattice(asked)) return true;
  PolygonConvexity answer = ask(asked);
  Polygon2d ring = std::get<0>(asked);
  const Point2d p = ring[0], q = ring[1];
  for (Point2d& vertex : ring.vertices) vertex = {2 * vertex.x, 2 * vertex.y};
  if (!(p == q)) ring.vertices.insert(ring.vertices.begin() + 1, {p.x + q.x, p.y + q.y});
  answer.strict = false;
  return equal(ask(Row::Question{ring}), answer);
}

LAW("polygon_convexity: any three corners of a strictly convex ring, in order, go the same way round", given) {
  const PolygonConvexity answer = ask(asked);
  const Polygon2d ring = opened(given);
  if (!answer.strict) return answer.polygon_class == PolygonClass::convex || !answer.strict;
  for (std::size_t i = 2; i < ring.size(); ++i) {
    if (!equal(ask(Row::Question{Polygon2d{{ring[0], ring[i - 1], ring[i]}}}), answer)) return false;
  }
  return true;
}

ROBUST_LAW("polygon_convexity: convex and concave rings are those that the search for edges that meet finds simple") {
  const PolygonConvexity answer = ask(asked);
  const bool simple = !robust::ring_defect(opened(std::get<0>(asked)));
  const bool proper = answer.polygon_class == PolygonClass::convex || answer.polygon_class == PolygonClass::concave;
  return simple == proper && (answer.orientation == Winding::none) == !proper &&
         (!answer.strict || answer.polygon_class == PolygonClass::convex);
}

TEST_CASE("polygon_convexity: p. 5's line test and p. 6's angles worked by hand") {
  // The square: E is 0 or 16 for every edge and vertex; four angles of pi/2 add up to 2 pi.
  both({{{0, 0}, {4, 0}, {4, 4}, {0, 4}}}, convex_ccw);
  both({{{0, 4}, {4, 4}, {4, 0}, {0, 0}}}, convex_cw);
  both({{{0, 0}, {1, 0}, {0, 1}}}, convex_ccw);
  // (2, 0) has the angle pi: 3 pi/2 + pi/2 + pi = 3 pi.
  both({{{0, 0}, {2, 0}, {4, 0}, {4, 4}, {0, 4}}}, flat_ccw);
  both({{{0, 4}, {4, 4}, {4, 0}, {2, 0}, {0, 0}}}, flat_cw);
  // The dart: (1, 1) lies on the same side of (4, 0) -> (0, 4) as (0, 0), and the edge to it has (0, 0) and (0, 4) on
  // different sides.
  both({{{0, 0}, {4, 0}, {1, 1}, {0, 4}}}, concave_ccw);
  both({{{0, 4}, {1, 1}, {4, 0}, {0, 0}}}, concave_cw);
  // An L: five right angles and one of 3 pi/2 are 4 pi.
  both({{{0, 0}, {4, 0}, {4, 2}, {2, 2}, {2, 4}, {0, 4}}}, concave_ccw);
}

LAW("polygon_convexity: the first vertex once more at the end changes nothing", ring) {
  const Polygon2d vertices = opened(ring);
  return repeats(vertices) || equal(ask(Row::Question{closed(vertices)}), ask(Row::Question{vertices}));
}

TEST_CASE("polygon_convexity: a last position that repeats the first is dropped, once") {
  both({{{0, 0}, {4, 0}, {4, 4}, {0, 4}, {0, 0}}}, convex_ccw);
  both({{{0, 4}, {4, 4}, {4, 0}, {0, 0}, {0, 4}}}, convex_cw);
  both({{{0, 0}, {1, 0}, {0, 1}, {-0.0, 0}}}, convex_ccw);
  both({{{0, 0}, {4, 0}, {1, 1}, {0, 4}, {0, 0}}}, concave_ccw);
  both({{{0, 0}, {4, 4}, {4, 0}, {0, 4}, {0, 0}}}, not_simple, "algorithm");
  both({{{0, 0}, {1, 1}, {3, 3}, {0, 0}}}, degenerate, "algorithm", "algorithm");
  both({{{0, 0}, {4, 0}, {0, 4}, {0, 0}, {0, 0}}}, degenerate, "algorithm", "algorithm");
  both({{{1, 1}, {1, 1}, {1, 1}, {1, 1}}}, degenerate, "algorithm", "algorithm");
}

TEST_CASE("polygon_convexity: what neither method of the deck sees") {
  // A figure eight turns 0 times, which the sum of angles tells: 4 pi.
  both({{{0, 0}, {4, 4}, {4, 0}, {0, 4}}}, not_simple, "algorithm");
  // The pentagram turns twice; every line has vertices on both sides.
  both({{{0, 3}, {2, -3}, {-3, 1}, {3, 1}, {-2, -3}}}, not_simple, "algorithm");
  // Twice round a triangle: no line has. The angles add up to 2 pi, (6 - 4) pi.
  both({{{0, 0}, {4, 0}, {0, 4}, {0, 0}, {4, 0}, {0, 4}}}, not_simple, "algorithm");
  // A loop inside, and one outside that undoes it: the ring turns once.
  both({{{0, 0},
         {6, 0},
         {6, 6},
         {2, 6},
         {2, 8},
         {4, 8},
         {4, 4},
         {0, 4},
         {0, 2},
         {-2, 2},
         {-2, 3},
         {1, 3},
         {1, 1},
         {0, 1}}},
       not_simple, "algorithm", "algorithm");
  // A vertex on an edge, and one on a vertex.
  both({{{0, 0}, {4, 0}, {4, 4}, {2, 0}, {0, 4}}}, not_simple, "algorithm", "algorithm");
  both({{{0, 0}, {2, 2}, {4, 0}, {4, 4}, {2, 2}, {0, 4}}}, not_simple, "algorithm", "algorithm");
  // A spike.
  both({{{0, 0}, {4, 0}, {4, 4}, {6, 6}, {4, 4}, {0, 4}}}, not_simple, "algorithm", "algorithm");
  // Degenerate ones: all sides are 0, or the edge without length has no side; its angle is 0 / 0.
  both({{{0, 0}, {1, 1}, {3, 3}, {2, 2}}}, degenerate, "algorithm", "algorithm");
  both({{{0, 0}, {0, 0}, {4, 0}, {0, 4}}}, degenerate, "algorithm", "algorithm");
  both({{{1, 1}, {1, 1}, {2, 1}, {2, 1}}}, degenerate, "algorithm", "algorithm");
}

TEST_CASE("polygon_convexity: rounding bends flat vertices and straightens bent ones") {
  // (0.3, 0.1) typed as doubles is beside the segment from (0, 0) to (0.9, 0.3): docs/judging.md.
  example<Row>({Polygon2d{{{0, 0}, {0.3, 0.1}, {0.9, 0.3}, {0, 1}}}}, concave_ccw, "agree");
  // E at (2 - 2^-51, 2) is 1 * 2 - (1 + 2^-52)(2 - 2^-51) = 2^-103, and both methods lose it.
  const double more = 1 + 0x1p-52, less = 1 - 0x1p-52;
  both({{{0, 0}, {1, more}, {2 * less, 2}, {-2, 2}}}, convex_ccw, "rounding", "rounding");
  // Products that underflow or overflow.
  both({{{0, 0}, {tiny, 0}, {tiny, tiny}, {0, tiny}}}, convex_ccw, "rounding", "rounding");
  both({{{0, 0}, {huge / 2, huge / 4}, {huge, 0.75 * huge}}}, convex_ccw, "rounding", "rounding");
}

TEST_CASE("polygon_convexity: rings of a thousand vertices") {
  // On the parabola y = x^2, closed by its chord: strictly convex. A zigzag below a roof: concave.
  Polygon2d parabola, zigzag;
  for (int i = 0; i < 1000; ++i) parabola.vertices.push_back({static_cast<double>(i), static_cast<double>(i) * i});
  for (int i = 0; i < 1000; ++i) zigzag.vertices.push_back({static_cast<double>(i), i % 2 == 0 ? 0.0 : 1e-9});
  zigzag.vertices.push_back({500, 1e9});
  CHECK(equal(robust::polygon_convexity(parabola), convex_ccw));
  CHECK(equal(robust::polygon_convexity(zigzag), concave_ccw));
  std::swap(parabola.vertices[400], parabola.vertices[401]);
  CHECK(equal(robust::polygon_convexity(parabola), not_simple));
}

TEST_CASE("polygon_convexity: the line test is right in exact arithmetic for every simple ring") {
  const auto& operation = *catalogue::find_operation("polygon_convexity");
  never(
      operation, "the line test is right in exact arithmetic for simple rings",
      [](const Question& question) -> std::string {
        const auto asked = typed<Row>(question);
        const Polygon2d& ring = std::get<0>(asked);
        if (validation::fewer_than_three(ring.vertices) || robust::ring_defect(opened(ring))) return "";
        const auto formula = catalogue::ask_reference<Row>(catalogue::converted<catalogue::Exact>(
            asked, [](double number) { return catalogue::Exact(exact(number)); }));
        return equal(formula, catalogue::ask_oracle<Row>(asked).answer)
                   ? ""
                   : "the formula is wrong even in exact arithmetic";
      },
      3);
}

TEST_CASE("polygon_convexity: both formulas in double are right beyond the margins of their contracts") {
  contract<Row>("the forward error bound of the line test", [](const auto& truth, const PolygonConvexity& answer,
                                                               const Polygon2d& given) {
    const Polygon2d ring = opened(given);
    if (truth.answer.orientation == Winding::none) return true;  // not simple
    const Rational u = unit();
    bool sides_certain = true;
    for (std::size_t i = 0; i < ring.size(); ++i) {
      const Point2d a = ring[i], b = ring.next(i);
      for (std::size_t k = 2; k < ring.size(); ++k) {
        const Point2d& p = ring[(i + k) % ring.size()];
        const double left = (p.y - a.y) * (b.x - a.x), right = (p.x - a.x) * (b.y - a.y);
        if (!finite(left, right, left - right)) return true;
        sides_certain =
            sides_certain && size(left - right) > (3 + 16 * u) * u * (size(left) + size(right)) + power_of_two(-1073);
      }
    }
    if (!sides_certain) return true;
    if (answer.polygon_class != truth.answer.polygon_class || answer.strict != truth.answer.strict) return false;
    if (answer.polygon_class == PolygonClass::convex) return answer.orientation == truth.answer.orientation;
    double area = 0;
    Rational products(0);
    for (std::size_t i = 1; i + 1 < ring.size(); ++i) {
      const Vector2d v = ring[i] - ring[0], w = ring[i + 1] - ring[0];
      area += v.x * w.y - v.y * w.x;
      if (!finite(area)) return true;
      products += size(v.x * w.y) + size(v.y * w.x);
    }
    const auto n = static_cast<std::uint64_t>(ring.size());
    const bool certain = size(area) > Rational(n + 2) * u * products + Rational(n) * power_of_two(-1073);
    return !certain || answer.orientation == truth.answer.orientation;
  });
  std::uint64_t promised = 0;
  contract<ByAngles>(
      "the margin of the interior angles",
      [&](const auto& truth, const PolygonConvexity& answer, const Polygon2d& given) {
        const Polygon2d ring = opened(given);
        if (truth.answer.orientation == Winding::none) return true;
        for (std::size_t i = 0; i < ring.size(); ++i) {
          const auto corner = moderate_corner(ring, i);
          if (!corner) return true;
          const auto& [v, w] = *corner;
          const Rational sine = cross(v, w);
          if (sine * sine <= dot(v, v) * dot(w, w) * power_of_two(-40)) return true;
        }
        ++promised;
        return equal(answer, truth.answer);
      },
      96);
  CHECK(promised > 100);
}

TEST_CASE("polygon_convexity: ask shows both methods") {
  const Operation& operation = *catalogue::find_operation("polygon_convexity");
  const auto crossed = operation.parse(catalogue::parse_line(R"({"polygon":[[0,0],[4,4],[4,0],[0,4]]})"));
  const auto said = catalogue::explained(*operation.examine(crossed));
  CHECK(catalogue::one_line(said["reference"]["answer"]) ==
        R"({"class":"concave","strict":false,"orientation":"none"})");
  CHECK(said["reference"]["cause"] == "algorithm");
  CHECK(catalogue::one_line(said["reference_interior_angles"]["answer"]) ==
        R"({"class":"not_simple","strict":false,"orientation":"none"})");
  CHECK(said["reference_interior_angles"]["verdict"] == "agree");
  const Operation& method = *catalogue::find_operation("polygon_convexity_interior_angles");
  CHECK_FALSE(catalogue::explained(*method.examine(method.zeros())).contains("reference_interior_angles"));
}

}  // namespace touchstone::proptests::polygon_convexity_tests
