// SPDX-License-Identifier: Apache-2.0
#include "catalogue/rows/planes/polygon_normal.h"

#include <cstdint>

#include "proptests/closed_rings.h"
#include "proptests/rounded_answers.h"
#include "proptests/space_laws.h"
#include "robust/planes/point_plane.h"

namespace touchstone::proptests::polygon_normal_tests {
namespace {

using Row = rows::polygon_normal;

template <class R>
PolygonNormal<R> opposite(PolygonNormal<R> answer) {
  for (auto* v : {&answer.normal, &answer.unit}) {
    if (*v) *v = Vector3<R>{R(-(*v)->x), R(-(*v)->y), R(-(*v)->z)};
  }
  return answer;
}

template <class R>
std::vector<R> coordinates(const std::optional<Vector3<R>>& v) {
  return v ? std::vector<R>{v->x, v->y, v->z} : std::vector<R>{};
}

constexpr double third_root = 0x1.279a74590331cp-1;  // 1 / sqrt(3) = 0.57735026918962576451
constexpr double sixth_root = 0x1.a20bd700c2c3ep-2,
                 two_sixth_roots = 0x1.a20bd700c2c3ep-1;  // 1 / sqrt(6) = 0.40824829046386301637

constexpr Gives<Row> answers;
void gives(const Polygon3d& polygon, const Vector3d& normal, const Vector3d& unit,
           const std::string& by_reference = "agree") {
  answers({polygon}, {NormalClass::proper, normal, unit}, by_reference);
}
void degenerate(const Polygon3d& polygon, const std::string& by_reference = "agree") {
  answers({polygon}, {NormalClass::degenerate, std::nullopt, std::nullopt}, by_reference);
}

}  // namespace

LAW("polygon_normal: it does not depend on which vertex is the first") {
  auto ring = std::get<0>(asked);
  if (ring.size() == 3 && repeats(ring)) return true;
  const auto answer = ask(asked);
  for (int i = 0; i < 3; ++i) {
    std::rotate(ring.vertices.begin(), ring.vertices.begin() + 1, ring.vertices.end());
    if (!equal(ask(Row::Question{ring}), answer)) return false;
  }
  return true;
}

LAW("polygon_normal: the ring the other way round faces the other way") {
  auto ring = std::get<0>(asked);
  std::reverse(ring.vertices.begin(), ring.vertices.end());
  return equal(ask(Row::Question{ring}), opposite(ask(asked)));
}

LAW("polygon_normal: a vertex twice in a row, and a way there and back, change nothing") {
  auto twice = std::get<0>(asked), spike = twice;
  twice.vertices.insert(twice.vertices.begin() + 1, Point3d(twice[1]));
  const Point3d second = spike[1];
  spike.vertices.insert(spike.vertices.begin() + 2, {Point3d{3, tiny, -7}, second});
  const auto answer = ask(asked);
  return equal(ask(Row::Question{twice}), answer) && equal(ask(Row::Question{spike}), answer);
}

LAW("polygon_normal: exchanges of the axes exchange the coordinates, and turn a mirrored ring over") {
  static constexpr std::array<bool, axis_maps.size()> mirrors{false, true, true, false};
  const auto answer = ask(asked);
  for (std::size_t i = 0; i < axis_maps.size(); ++i) {
    auto expected = axis_maps[i](answer);
    if (mirrors[i]) expected = opposite(expected);
    if (!equal(ask(axis_maps[i](asked)), expected)) return false;
  }
  return true;
}

LAW("polygon_normal: lengths times 2^k have the same unit normal, and areas times 4^k") {
  const auto times_two_to = [](Row::Question question, int k) {
    catalogue::for_each_number(question, [k](double& number) { number = std::ldexp(number, k); });
    return question;
  };
  const auto answer = ask(asked);
  for (const int k : {1, -29, 300, -300}) {
    const auto larger = times_two_to(asked, k);
    if (numbers_of(times_two_to(larger, -k)) != numbers_of(asked)) continue;
    const auto found = ask(larger);
    if (found.normal_class != answer.normal_class || !equal(found.unit, answer.unit)) return false;
    const auto before = coordinates(answer.normal), after = coordinates(found.normal);
    for (std::size_t i = 0; i < before.size(); ++i) {
      if (!scaled_number(before[i], after[i], 2 * k)) return false;
    }
  }
  return true;
}

LAW("polygon_normal: a shift of the lattice changes nothing") {
  if (!on_small_lattice(asked)) return true;
  auto moved = std::get<0>(asked);
  for (Point3d& p : moved.vertices) p = p + Vector3d{12345, -67890, 424242};
  return equal(ask(Row::Question{moved}), ask(asked));
}

ROBUST_LAW("polygon_normal: the unit normal has length 1 but for its roundings") {
  const auto answer = ask(asked);
  if (!answer.unit) return true;
  const Rational x = exact(answer.unit->x), y = exact(answer.unit->y), z = exact(answer.unit->z);
  // Each coordinate is off by half an ulp, 2^-53 relatively, or by 2^-1075; 2^-52 + 2^-106 in the squares' sum.
  return abs(Rational(x * x + y * y + z * z - 1)) <= power_of_two(-51);
}

ROBUST_LAW("polygon_normal: the vertices of a triangle are on the plane with its normal", ring) {
  const auto answer = ask(asked);
  double size = 0;
  catalogue::for_each_number(asked, [&](const double& n) { size = std::max(size, std::fabs(n)); });
  if (!on_small_lattice(asked) || size > 0x1p15 || !answer.normal || ring.size() != 3) return true;
  const Plane3d plane{*answer.normal, -dot(*answer.normal, ring[0] - Point3d{0, 0, 0})};
  return std::all_of(ring.vertices.begin(), ring.vertices.end(),
                     [&](const Point3d& p) { return robust::point_plane_side(plane, p) == PlaneSide::on; });
}

TEST_CASE("polygon_normal: p. 21's cross product of two edges worked by hand") {
  gives({{{0, 0, 0}, {2, 0, 0}, {0, 3, 0}}}, {0, 0, 6}, {0, 0, 1});                      // (2,0,0) x (-2,3,0)
  gives({{{0, 0, 0}, {2, -1, 0}, {2, 0, -1}}}, {1, 2, 2}, {1.0 / 3, 2.0 / 3, 2.0 / 3});  // (2,-1,0) x (0,1,-1)
  gives({{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}}, {1, 1, 1}, {third_root, third_root, third_root});
  gives({{{0, 0, 1}, {0, 1, 0}, {1, 0, 0}}}, {-1, -1, -1}, {-third_root, -third_root, -third_root});
  gives({{{0, 0, 5}, {1, 0, 5}, {1, 1, 5}, {0, 1, 5}}}, {0, 0, 2}, {0, 0, 1});  // twice the unit square
}

TEST_CASE("polygon_normal: where two edges do not tell what the ring does") {
  gives({{{3, 0, 0}, {1, 1, 0}, {0, 3, 0}, {0, 0, 0}}}, {0, 0, 6}, {0, 0, 1},
        "algorithm");  // a dart, reflex at (1, 1): (-2, 1) x (-1, 2) = -3
  gives({{{0, 0, 0}, {1, 0, 0}, {2, 0, 0}, {0, 1, 0}}}, {0, 0, 2}, {0, 0, 1}, "algorithm");  // flat at v1
  gives({{{0, 0, 0}, {0, 0, 0}, {1, 0, 0}, {0, 1, 0}}}, {0, 0, 1}, {0, 0, 1}, "algorithm");  // repeated
  gives({{{0, 0, 0}, {1, 0, 0}, {1, 1, 1}, {0, 1, 0}}}, {-1, -1, 2}, {-sixth_root, -sixth_root, two_sixth_roots},
        "algorithm");  // not planar: (0, -1, 1) + (-1, 0, 1)
}

TEST_CASE("polygon_normal: degenerate rings") {
  degenerate({{{1, 2, 3}, {1, 2, 3}, {1, 2, 3}, {1, 2, 3}}});
  degenerate({{{0, 0, 0}, {1, 2, 3}, {3, 6, 9}, {-1, -2, -3}}});
  degenerate({{{0, 0, 0}, {1, 1, 0}, {1, 0, 0}, {0, 1, 0}}}, "algorithm");  // a figure of eight
  degenerate({{{0.0, -0.0, 0.0}, {0.0, 0.0, 0.0}, {-0.0, tiny, 0.0}}});
  degenerate({{{huge, huge, huge}, {-huge, -huge, -huge}, {0, 0, 0}}}, "rounding");  // infinity - infinity
}

TEST_CASE("polygon_normal: beyond and below the range the unit normal is right") {
  gives({{{0, 0, 0}, {huge, 0, 0}, {0, huge, 0}}}, {0, 0, infinity}, {0, 0, 1}, "invalid");
  gives({{{0, 0, 0}, {tiny, 0, 0}, {0, -tiny, 0}}}, {0, 0, -0.0}, {0, 0, -1}, "rounding");
  gives({{{0, 0, 0}, {0x1p-600, 0, 0}, {0, 0x1p-600, 0x1p-600}}}, {0, -0.0, 0},
        {0, -0x1.6a09e667f3bcdp-1, 0x1.6a09e667f3bcdp-1}, "rounding");
  gives({{{0, 0, 0}, {huge, 0, 0}, {0, 1, tiny}}}, {0, -(huge * tiny), huge}, {0, -tiny, 1},
        "rounding");  // N . N is infinite
}

TEST_CASE("polygon_normal: rounding hides an area") {
  // (2^27 + 1)(2^27 - 1) = 2^54 - 1 rounds to 2^54 = 2^27 2^27.
  gives({{{0, 0, 0}, {0x1p27 + 1, 0x1p27, 0}, {0x1p28 + 1, 0x1p28 - 1, 0}}}, {0, 0, -1}, {0, 0, -1}, "rounding");
}

TEST_CASE("polygon_normal: a last position that repeats the first changes nothing") {
  gives({{{0, 0, 5}, {1, 0, 5}, {1, 1, 5}, {0, 1, 5}, {0, 0, 5}}}, {0, 0, 2}, {0, 0, 1});
  gives({{{0, 0, 0}, {2, -1, 0}, {2, 0, -1}, {0, -0.0, 0}}}, {1, 2, 2}, {1.0 / 3, 2.0 / 3, 2.0 / 3});
  degenerate({{{0, 0, 0}, {1, 1, 1}, {2, 2, 2}, {0, 0, 0}}});
}

CONTRACT("polygon_normal: the formula in double keeps its contract for the first three vertices", ring) {
  const Vector3d v = ring[1] - ring[0], w = ring[2] - ring[1], n = cross(v, w);
  const double q = dot(n, n), s = std::sqrt(q);
  const std::array<double, 6> products{v.y * w.z, v.z * w.y, v.z * w.x, v.x * w.z, v.x * w.y, v.y * w.x};
  if (!(q >= 0x1p-960) || !finite(q, v.x, v.y, v.z, w.x, w.y, w.z)) return true;
  const Rational u = unit();
  Rational d = 3 * power_of_two(-1073);
  for (const double product : products) d += (4 + 20 * u) * u * size(product);
  const auto of_three = oracle::polygon_normal(Polygon3d{{ring[0], ring[1], ring[2]}}).answer;
  if ((1 - 4 * u) * exact(s) > d &&
      (of_three.normal_class != NormalClass::proper || answer.normal_class != NormalClass::proper))
    return false;
  if (!of_three.unit || !answer.unit) return true;
  const std::int64_t bits = 1200;  // the roots are not rational
  const auto close = [&](double computed, const oracle::Surd& right) {
    return within(computed, right.enclosure(bits).low,
                  5 * u * size(computed) + (2 + 8 * u) * d / exact(s) + power_of_two(-1074) - power_of_two(-bits));
  };
  return close(answer.unit->x, of_three.unit->x) && close(answer.unit->y, of_three.unit->y) &&
         close(answer.unit->z, of_three.unit->z);
}

ROBUST_LAW("polygon_normal: of a triangle the formula is right in exact arithmetic", ring) {
  if (ring.size() != 3) return true;
  const catalogue::RowFunctions& row = catalogue::operation_of_row<Row>().row();
  const Question question = catalogue::packed(asked);
  return catalogue::same_as_truth(*row.answer, row.solve(question).answer, row.reference_exactly(question),
                                  catalogue::Reading::less);
}

}  // namespace touchstone::proptests::polygon_normal_tests
