// SPDX-License-Identifier: Apache-2.0
#include "catalogue/rows/planes/point_plane.h"

#include <cstdint>

#include "proptests/rounded_answers.h"
#include "proptests/space_laws.h"
#include "robust/planes/point_ground_plane.h"

namespace touchstone::proptests::point_plane_tests {
namespace {

using Row = rows::point_plane;

PlaneSide other(PlaneSide s) {
  return s == PlaneSide::front ? PlaneSide::back : s == PlaneSide::back ? PlaneSide::front : PlaneSide::on;
}

template <class R>
PointPlane<R> turned(const PointPlane<R>& answer) {
  return {other(answer.side), R(-answer.signed_distance)};
}

double rounded(double number) { return number; }
double rounded(const catalogue::TrueNumber& number) { return catalogue::nearest(number); }

/// The distance is rational.
void worked(const Row::Question& question, const PointPlane<Rational>& expected,
            const std::string& by_reference = "agree") {
  example<Row>(question, {expected.side, expected.signed_distance}, by_reference);
}

/// The double nearest to 1 / sqrt(2) = 0.70710678118654752440.
constexpr double root_half = 0x1.6a09e667f3bcdp-1;

constexpr Gives<Row> gives;

}  // namespace

LAW("point_plane: the plane turned over has the front behind, at the opposite distance", plane, p) {
  return equal(ask(Row::Question{{-1.0 * plane.normal, -plane.offset}, p}), turned(ask(asked)));
}

LAW("point_plane: a point mirrored in the origin, with the offset's sign changed, is at the opposite distance", plane,
    p) {
  return equal(ask(Row::Question{{plane.normal, -plane.offset}, {-p.x, -p.y, -p.z}}), turned(ask(asked)));
}

EQUATION_LAW("point_plane", 0)

LAW("point_plane: exchanges of the axes keep the answer") {
  const auto answer = ask(asked);
  return std::all_of(axis_maps.begin(), axis_maps.end(),
                     [&](const AxisMap& map) { return equal(ask(map(asked)), answer); });
}

LAW("point_plane: a step across the plane keeps the answer, a shift of both keeps it, on the lattice", plane, p) {
  if (!on_small_lattice(asked) || catalogue::largest(plane.normal) > 0x1p20) return true;
  const auto answer = ask(asked);
  const Vector3d step = cross(plane.normal, Vector3d{3, -5, 7}), shift{11, -13, 17};
  return equal(ask(Row::Question{plane, p + step}), answer) &&
         equal(ask(Row::Question{{plane.normal, plane.offset - dot(plane.normal, shift)}, p + shift}), answer);
}

LAW("point_plane: lengths times a power of two are at that multiple of the distance") {
  const auto answer = ask(asked);
  for (const int k : {1, -29, 300, -300, 1000, -1000}) {
    auto larger = asked, back = asked;
    Row::scale(larger, k);
    back = larger;
    Row::scale(back, -k);
    if (numbers_of(back) != numbers_of(asked)) continue;
    const auto found = ask(larger);
    if (found.side != answer.side || !scaled_number(rounded(answer.signed_distance), rounded(found.signed_distance), k))
      return false;
  }
  return true;
}

LAW("point_plane: the side is the distance's sign, also where the distance rounds to zero") {
  const auto answer = ask(asked);
  if constexpr (is_exact<std::remove_cvref_t<decltype(answer)>>) {
    return (answer.side == PlaneSide::on) == (sgn(answer.signed_distance) == 0) &&
           (answer.side == PlaneSide::front) == (sgn(answer.signed_distance) > 0);
  } else {
    return answer.side == robust::point_plane_side(std::get<0>(asked), std::get<1>(asked)) &&
           (answer.side == PlaneSide::back) == std::signbit(answer.signed_distance) &&
           (answer.side != PlaneSide::on || answer.signed_distance == 0);
  }
}

ROBUST_LAW("point_plane: over the ground it is point_ground_plane, and the distance is y") {
  const Point3d& p = std::get<1>(asked);
  for (const double up : {1.0, 3.0, tiny, huge}) {
    const auto answer = ask(Row::Question{{{0, up, 0}, 0}, p});
    const Height height = robust::point_ground_plane(p);
    if (static_cast<int>(height) != static_cast<int>(answer.side) || answer.signed_distance != p.y) return false;
  }
  return true;
}

TEST_CASE("point_plane: p. 22's N . p + d worked by hand") {
  worked({{{0, 1, 0}, -2}, {5, 3, 7}}, {PlaneSide::front, 1});               // 3 - 2
  worked({{{2, 1, 2}, -9}, {1, 2, 4}}, {PlaneSide::front, 1});               // (2 + 2 + 8 - 9) / 3
  worked({{{2, 1, 2}, -9}, {1, 2, 2.5}}, {PlaneSide::on, 0});                // 2 + 2 + 5 - 9
  worked({{{2, 3, 6}, 0}, {-1, 0, 0}}, {PlaneSide::back, Rational(-2, 7)});  // -2 / sqrt(4 + 9 + 36)
  worked({{{-4, 0, 3}, 10}, {1, 9, -2}}, {PlaneSide::on, 0});                // -4 - 6 + 10
  worked({{{0.5, 0, 0}, 0}, {3, 1, 1}}, {PlaneSide::front, 3});              // 1.5 / 0.5
  gives({{{1, 1, 0}, 0}, {1, 0, 5}}, {PlaneSide::front, root_half});         // 1 / sqrt(2)
  gives({{{1, 0, -1}, 0}, {0, 5, 1}}, {PlaneSide::back, -root_half});
}

TEST_CASE("point_plane: rounding hides a side, and moves a point off the plane") {
  // 10 times the double 0.1 is 1 + 2^-54: the product rounds to 1.
  gives({{{10, 0, 0}, -1}, {0.1, 0, 0}}, {PlaneSide::front, 0x1p-54 / 10}, "rounding");
  gives({{{1, 1, 1}, -0x1p53}, {0x1p53, 1, 0}}, {PlaneSide::front, 0x1.279a74590331cp-1},
        "rounding");  // 1 / sqrt(3) = 0.57735026918962576451
}

TEST_CASE("point_plane: normals so long or short that N . N leaves the range") {
  worked({{{0, 0x1p600, 0}, 0}, {0, 3, 0}}, {PlaneSide::front, 3}, "rounding");  // divided by infinity: 0
  worked({{{0, 0x1p-600, 0}, 0}, {0, 3, 0}}, {PlaneSide::front, 3}, "invalid");  // divided by 0
  worked({{{0, tiny, 0}, tiny}, {0, 3, 0}}, {PlaneSide::front, 4}, "invalid");
  worked({{{0, huge, 0}, -huge}, {0, -1, 0}}, {PlaneSide::back, -2}, "invalid");  // -infinity / infinity
}

TEST_CASE("point_plane: ties go to the even neighbour") {
  gives({{{0, 1, 0}, 0.5}, {0, 0x1p52, 0}}, {PlaneSide::front, 0x1p52});
  gives({{{0, 1, 0}, 0.5}, {0, 0x1p52 + 1, 0}}, {PlaneSide::front, 0x1p52 + 2});
  gives({{{0, -2, 0}, -1}, {7, 0x1p52 + 1, 9}}, {PlaneSide::back, -(0x1p52 + 2)});
}

TEST_CASE("point_plane: of two broken rules the first is named, also where only the side is asked") {
  const auto refusal_of_side = [](const Plane3d& plane) -> std::string {
    try {
      robust::point_plane_side(plane, {1, 2, 3});
    } catch (const InvalidInput& refused) {
      return refused.what();
    }
    return "answered";
  };
  CHECK(refusal_of_side({{0, 0, -0.0}, 1}) ==
        "plane.normal: nonzero normal");  // the filter must not take the offset for the answer
  CHECK(refusal_of_side({{0, 1, 0}, infinity}) == "plane.offset: finite number");
}

CONTRACT("point_plane: the formula in double has the right side beyond the margin of its contract", plane, p) {
  const HeightBound e(plane, p);
  return !e.certain() || truth.answer.side == answer.side;
}

CONTRACT("point_plane: the formula in double has the distance within the bound of its contract", plane, p) {
  const HeightBound e(plane, p);
  const double q = dot(plane.normal, plane.normal), length = std::sqrt(q);
  if (e.overflow || !(q >= 0x1p-960) || !finite(q, answer.signed_distance)) return true;
  const Rational u = unit();
  const std::int64_t bits = 1200;  // the root is not rational
  const Rational distance = truth.answer.signed_distance.enclosure(bits).low;
  return within(answer.signed_distance, distance,
                (1 + 8 * u) * e.error / exact(length) + 5 * u * size(answer.signed_distance) + power_of_two(-1074) -
                    power_of_two(-bits));
}

TEST_CASE("point_plane: the formula is right in exact arithmetic") { right_in_exact_arithmetic<Row>(); }

}  // namespace touchstone::proptests::point_plane_tests
