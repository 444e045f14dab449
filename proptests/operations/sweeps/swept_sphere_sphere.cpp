// SPDX-License-Identifier: Apache-2.0
#include "catalogue/rows/sweeps/swept_sphere_sphere.h"

#include "proptests/motion_laws.h"
#include "proptests/space_laws.h"

namespace touchstone::proptests::swept_sphere_sphere_tests {
namespace {

using Row = rows::swept_sphere_sphere;
using Answer = exact_answer_t<Row>;
using oracle::Surd;

const Answer misses{HitRelation::never, std::nullopt};
Answer at(const Surd& t) { return {HitRelation::hit, t}; }

/// p and v: position and velocity of a as b sees them; r: the sum of the radii, halved between the two.
Row::Question seen(const Vector3d& p, const Vector3d& v, double r) {
  return {{{p.x, p.y, p.z}, r / 2}, {{0, 0, 0}, r / 2}, v, {0, 0, 0}};
}

constexpr Worked<Row> worked;

/// x + y where that is a double.
std::optional<double> sum(double x, double y) {
  const double s = x + y;
  if (!finite(s) || exact(s) != Rational(exact(x) + exact(y))) return std::nullopt;
  return s;
}
template <class Triple>
std::optional<Triple> sum(const Triple& a, const Vector3d& b) {
  const auto x = sum(a.x, b.x), y = sum(a.y, b.y), z = sum(a.z, b.z);
  if (!x || !y || !z) return std::nullopt;
  return Triple{*x, *y, *z};
}

/// A vector that belongs to the question, of about its size.
Vector3d some_vector(const Row::Question& question) {
  const auto& [a, b, va, vb] = question;
  return {b.center.y, va.x, a.center.z};
}

struct Distance {
  Surd squared, half_slope;  ///< of the centers at t, and half of how fast that grows
};

Distance distance_at(const Row::Question& question, const Surd& t) {
  const auto& [a, b, va, vb] = question;
  Distance total{Rational(0), Rational(0)};
  const auto add = [&](double from, double to, double v, double w) {
    const Surd velocity = Rational(exact(v) - exact(w)), d = Surd(Rational(exact(from) - exact(to))) + t * velocity;
    total = {total.squared + d * d, total.half_slope + d * velocity};
  };
  add(a.center.x, b.center.x, va.x, vb.x), add(a.center.y, b.center.y, va.y, vb.y);
  add(a.center.z, b.center.z, va.z, vb.z);
  return total;
}

bool zero(double t) { return t == 0; }
bool zero(const Surd& t) { return sgn(t) == 0; }

Rational reach(const Row::Question& question) {
  return exact(std::get<0>(question).radius) + exact(std::get<1>(question).radius);
}

}  // namespace

LAW("swept_sphere_sphere: the balls may be exchanged with their velocities", a, b, va, vb) {
  return equal(ask(Row::Question{b, a, vb, va}), ask(asked));
}

LAW("swept_sphere_sphere: a common velocity and a common place play no part") {
  const auto answer = ask(asked);
  const Vector3d offset = some_vector(asked);
  for (const Vector3d& w : {offset, Vector3d{3, -5, 7}}) {
    const auto& [a, b, va, vb] = asked;
    const auto at_a = sum(a.center, w), at_b = sum(b.center, w);
    if (at_a && at_b && !equal(ask(Row::Question{{*at_a, a.radius}, {*at_b, b.radius}, va, vb}), answer)) return false;
    const auto to_a = sum(va, w), to_b = sum(vb, w);
    if (to_a && to_b && !equal(ask(Row::Question{a, b, *to_a, *to_b}), answer)) return false;
  }
  return true;
}

LAW("swept_sphere_sphere: only the sum of the radii counts", a, b, va, vb) {
  const auto both = sum(a.radius, b.radius);
  return !both || equal(ask(Row::Question{{a.center, *both}, {b.center, 0}, va, vb}), ask(asked));
}

VELOCITIES_LAW("swept_sphere_sphere", 2, 3)

LAW("swept_sphere_sphere: larger balls never meet later", a, b, va, vb) {
  const auto answer = ask(asked);
  for (const double larger : {catalogue::moved_by_ulps(a.radius, 1), a.radius + a.radius / 4 + tiny}) {
    if (!finite(larger)) continue;
    const auto then = ask(Row::Question{{a.center, larger}, b, va, vb});
    if (answer.t && (!then.t || *then.t > *answer.t)) return false;
  }
  return true;
}

LAW("swept_sphere_sphere: a motion and the same backwards both meet, or neither does", a, b, va, vb) {
  const auto end_a = sum(a.center, va), end_b = sum(b.center, vb);
  if (!end_a || !end_b) return true;
  const Row::Question back{{*end_a, a.radius}, {*end_b, b.radius}, -1.0 * va, -1.0 * vb};
  return ask(back).relation == ask(asked).relation;
}

LAW("swept_sphere_sphere: with equal velocities, and at rest, the balls meet at the start or never", a, b, va) {
  const auto rest = ask(Row::Question{a, b, {0, 0, 0}, {0, 0, 0}}), together = ask(Row::Question{a, b, va, va});
  const bool meet = distance_at(asked, Rational(0)).squared <= Surd(Rational(reach(asked) * reach(asked)));
  return equal(rest, together) && rest.t.has_value() == meet && (!meet || zero(*rest.t));
}

TEST_CASE(
    "swept_sphere_sphere: at the exact t the centers are as far apart as the radii reach, and were further before") {
  law_of<Row>(
      "oracle: first contact", [](const auto& asked) { return catalogue::ask_oracle<Row>(asked).answer; },
      [](const auto& ask, const auto& asked) {
        const auto answer = ask(asked);
        const Surd touch(Rational(reach(asked) * reach(asked)));
        const bool apart = distance_at(asked, Rational(0)).squared > touch;
        if (!answer.t) return apart && distance_at(asked, Rational(1)).squared > touch;
        if (zero(*answer.t)) return !apart;
        // A parabola that is above at the start and does not rise where it touches has not touched before.
        const Distance first = distance_at(asked, *answer.t);
        return apart && first.squared == touch && sgn(first.half_slope) <= 0 && sgn(*answer.t) > 0 &&
               *answer.t <= Surd(Rational(1));
      },
      3);
}

TEST_CASE("swept_sphere_sphere: p. 23's smaller root worked by hand") {
  worked(seen({-6, 0, 0}, {8, 0, 0}, 2), at(Rational(1, 2)), 4);  // (8 t - 6)^2 = 4; the least is 0 - 4
  // (3 t - 2)^2 + 1 = 4: t = (2 - sqrt(3)) / 3; the least is 1 - 4.
  worked(seen({-2, 1, 0}, {3, 0, 0}, 2), at(Surd(Rational(2, 3), Rational(-1, 3), 3)), 3);
  worked(seen({-2, 2, 0}, {4, 0, 0}, 2), at(Rational(1, 2)), 0);  // (4 t - 2)^2 = 0: tangent
  worked(seen({-4, 0, 0}, {2, 0, 0}, 2), at(Rational(1)), 0);     // (2 t - 4)^2 = 4: at the very end
  worked(seen({-5, 0, 0}, {2, 0, 0}, 2), misses, 5);              // short of it: 3^2 - 4
  worked(seen({-2, 3, 0}, {4, 0, 0}, 2), misses, 5);              // past it: 9 - 4
  worked(seen({-5, 0, 0}, {-2, 0, 0}, 2), misses, 21);            // away: 25 - 4 at the start
  worked(seen({-5, 0, 0}, {0, 0, 0}, 2), misses, 21);             // at rest: 0 / 0 is no t
  // p = (1, 2, 2) times 3, v = -p, r = 3: |1 - t| 9 = 3.
  worked(seen({3, 6, 6}, {-3, -6, -6}, 3), at(Rational(2, 3)), 9);
}

TEST_CASE("swept_sphere_sphere: p. 51's two moving balls worked by hand") {
  // Seen from b: from (-12, 5, 0) with (24, 0, 0), radii 5 in all: tangent halfway.
  worked({{{-11, 6, 1}, 2}, {{1, 1, 1}, 3}, {12, 1, 0}, {-12, 1, 0}}, at(Rational(1, 2)), 0);
  // From (0, 0, 10) with (0, 0, -8), radii 4 in all: 10 - 8 t = 4.
  worked({{{0, 0, 5}, 1}, {{0, 0, -5}, 3}, {0, 0, -4}, {0, 0, 4}}, at(Rational(3, 4)), 12);
  // Points: from (4, 0, 0) with (-5, 0, 0); and with (-5, 1, 0), |p x v|^2 / v . v = 16 / 26.
  worked({{{4, 0, 0}, 0}, {{0, 0, 0}, 0}, {-5, 0, 0}, {0, 0, 0}}, at(Rational(4, 5)), 0);
  worked({{{4, 0, 0}, 0}, {{0, 0, 0}, 0}, {-5, 1, 0}, {0, 0, 0}}, misses, Rational(8, 13));
}

TEST_CASE(
    "swept_sphere_sphere: balls that meet at the start hit there; the smaller root is not where the balls first meet") {
  worked(seen({-2, 0, 0}, {-1, 0, 0}, 2), at(Rational(0)), 0, "algorithm");  // touching, they part: -4
  worked(seen({-2, 0, 0}, {1, 0, 0}, 2), at(Rational(0)), 3);                // touching, they go deeper: (t - 2)^2 = 4
  worked(seen({0, 2, 0}, {3, 0, 0}, 2), at(Rational(0)), 0);                 // touching, along each other: 9 t^2 = 0
  worked(seen({-1, 0, 0}, {4, 0, 0}, 2), at(Rational(0)), 4, "algorithm");   // one in the other: -1/4
  worked(seen({-1, 0, 0}, {0, 0, 0}, 2), at(Rational(0)), 3, "algorithm");   // 0 / 0
  worked(seen({-2, 0, 0}, {0, 0, 0}, 2), at(Rational(0)), 0, "algorithm");   // 0 / 0
  worked(seen({0, 0, 0}, {0, 0, 0}, 0), at(Rational(0)), 0, "algorithm");    // one point
}

TEST_CASE("swept_sphere_sphere: rounding misses a tangent, and sees a hit far from the line") {
  // The line passes at sqrt((93/64)^2 + (124/64)^2) = 155/64, the radii together. With X = 2^54 + 3 2^28, exact is
  // C = X + 9. Doubles there are multiples of 4: B^2 / (4 A) = X + 8 by rounding, but p . p is X + 8, then X + 12, then
  // X + 16, and C is X + 12.
  const double x = -(0x1p27 + 3);
  worked({{{x, 93.0 / 64, 124.0 / 64}, 1}, {{0, 0, 0}, 91.0 / 64}, {0x1p28, 0, 0}, {0, 0, 0}},
         at(Rational(Rational(-x) / Rational(0x1p28))), 0, "rounding");
  // It passes at 2, the radii reach to 1; p . p and C are 2^60.
  worked(seen({-0x1p30, 2, 0}, {0x1p31, 0, 0}, 1), misses, 3, "rounding");
}

ROBUST_LAW("swept_sphere_sphere: the relation alone is that of the answer") {
  const auto answer = ask(asked);
  return Row::decision::robust(asked) == answer.relation &&
         (answer.relation == HitRelation::hit) == answer.t.has_value();
}

CONTRACT("swept_sphere_sphere: the formula in double keeps its contract", a, b, va, vb) {
  const Vector3d p = a.center - b.center, v = va - vb;
  const double r = a.radius + b.radius, square = dot(v, v), linear = 2 * dot(p, v), constant = dot(p, p) - r * r;
  const double d = linear * linear - 4 * square * constant;
  const Row::Question question{a, b, va, vb};
  const Rational q = distance_at(question, Rational(0)).squared.rational_part() + reach(question) * reach(question);
  const Rational speed = distance_at({{{0, 0, 0}, 0}, {{0, 0, 0}, 0}, va, vb}, Rational(1)).squared.rational_part();
  for (const Rational& x : {q, speed})
    if (x < power_of_two(-480) || x > power_of_two(480)) return true;
  const Rational u = unit(), error_of_d = 104 * u * speed * q, found = exact(d);
  if (found < -error_of_d)
    return answer.relation == HitRelation::never && equal(truth.answer.relation, answer.relation);
  if (!(found > error_of_d)) return true;
  // e(t), put together in double: (1 + 2^-40) is more than all roundings of that.
  const double s = std::sqrt(d), t = (-linear - s) / (2 * square), size = q.get_d();
  const double e = (7 * std::sqrt(Rational(q / speed).get_d()) + 53 * size / s + 9 * std::fabs(t)) * 0x1p-53 + tiny;
  const Rational error = exact(e) * (1 + power_of_two(-40)), at = exact(t);
  if (at > error && at < 1 - error) {
    return answer.relation == HitRelation::hit && truth.answer.relation == HitRelation::hit &&
           Surd(Rational(at - error)) <= *truth.answer.t && *truth.answer.t <= Surd(Rational(at + error));
  }
  if (at > 1 + error || (at < -error && exact(constant) > 7 * u * q))
    return answer.relation == HitRelation::never && truth.answer.relation == HitRelation::never;
  return true;
}

TEST_CASE("swept_sphere_sphere: in exact arithmetic the formula is wrong of balls alone that meet at the start") {
  right_but_at_the_start<Row>();
}

}  // namespace touchstone::proptests::swept_sphere_sphere_tests
