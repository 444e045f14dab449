// SPDX-License-Identifier: Apache-2.0
#include "catalogue/rows/sweeps/swept_aabb_aabb.h"

#include "proptests/motion_laws.h"
#include "proptests/space_laws.h"
#include "robust/volumes/aabb_aabb.h"

namespace touchstone::proptests::swept_aabb_aabb_tests {
namespace {

using Row = rows::swept_aabb_aabb;
using InPlane = Row::InPlane;
using InSpace = Row::InSpace;
using Answer = exact_answer_t<Row>;

const Answer misses{HitRelation::never, std::nullopt};
Answer at(const Rational& t) { return {HitRelation::hit, t}; }

constexpr Aabb2d square{{0, 0}, {4, 4}};
constexpr Aabb3d cube{{0, 0, 0}, {4, 4, 4}};

/// Holds of a question in the plane or in space: `holds(ask, a, b, velocity)`.
template <class Holds>
auto of_boxes(const Holds& holds) {
  return [holds](const auto& ask, const auto& asked) {
    return catalogue::applied([&](const auto& a, const auto& b, const auto& v) { return holds(ask, a, b, v); }, asked);
  };
}

/// The numbers of one axis: both intervals and the velocity.
struct Axis {
  double a_min, a_max, b_min, b_max, velocity;
};
std::vector<Axis> axes_of(const Aabb2d& a, const Aabb2d& b, const Vector2d& v) {
  return {{a.min.x, a.max.x, b.min.x, b.max.x, v.x}, {a.min.y, a.max.y, b.min.y, b.max.y, v.y}};
}
std::vector<Axis> axes_of(const Aabb3d& a, const Aabb3d& b, const Vector3d& v) {
  return {{a.min.x, a.max.x, b.min.x, b.max.x, v.x},
          {a.min.y, a.max.y, b.min.y, b.max.y, v.y},
          {a.min.z, a.max.z, b.min.z, b.max.z, v.z}};
}

/// By how much the intervals of that axis are apart at t: 0 where they touch, negative where they overlap.
Rational gap_at(const Axis& m, const Rational& t) {
  const Rational displacement(t * exact(m.velocity));
  return std::max(Rational(exact(m.b_min) - exact(m.a_max) - displacement),
                  Rational(exact(m.a_min) + displacement - exact(m.b_max)));
}

/// Moved by v, where that is exact.
template <class Box, class Vector>
std::optional<Box> moved(Box box, const Vector& v) {
  bool kept = true;
  const auto move = [&kept](double& x, double by) {
    const double sum = x + by;
    kept = kept && finite(sum) && exact(sum) == Rational(exact(x) + exact(by));
    x = sum;
  };
  for (auto* p : {&box.min, &box.max}) {
    move(p->x, v.x), move(p->y, v.y);
    if constexpr (requires { v.z; }) move(p->z, v.z);
  }
  return kept ? std::optional(box) : std::nullopt;
}

Vector2d reversed(const Vector2d& v) { return {-v.x, -v.y}; }
Vector3d reversed(const Vector3d& v) { return {-v.x, -v.y, -v.z}; }

constexpr Worked<Row> worked;

}  // namespace

LAW("swept_aabb_aabb: either box may be the one that moves, the other way", a, b, v) {
  return equal(ask(std::tuple(a, b, v)), ask(std::tuple(b, a, reversed(v))));
}

LAW("swept_aabb_aabb: a motion and the same backwards both meet, or neither does", a, b, v) {
  const auto end = moved(a, v);
  return !end || ask(std::tuple(*end, b, reversed(v))).relation == ask(std::tuple(a, b, v)).relation;
}

VELOCITIES_LAW("swept_aabb_aabb", 2)

LAW("swept_aabb_aabb: a common place plays no part", a, b, v) {
  auto offset = v;
  offset.x = 0x1p44 + 3, offset.y = -5;
  for (const auto& by : {offset, v}) {
    const auto first = moved(a, by), second = moved(b, by);
    if (first && second && !equal(ask(std::tuple(*first, *second, v)), ask(std::tuple(a, b, v)))) return false;
  }
  return true;
}

LAW("swept_aabb_aabb: a larger box never meets later", a, b, v) {
  const auto answer = ask(std::tuple(a, b, v));
  auto larger = a;
  larger.min.x = catalogue::moved_by_ulps(a.min.x, -1), larger.max.y = catalogue::moved_by_ulps(a.max.y, 1);
  const auto then = ask(std::tuple(larger, b, v));
  return !answer.t || (then.t && *then.t <= *answer.t);
}

LAW("swept_aabb_aabb: at t = 0 exactly where aabb_aabb sees contact; at rest, there or never", a, b, v) {
  const auto answer = ask(std::tuple(a, b, v)), rest = ask(std::tuple(a, b, std::decay_t<decltype(v)>{}));
  const bool meet = robust::aabb_aabb(a, b) != Contact::disjoint;
  return (rest.t.has_value() && *rest.t == 0) == meet && rest.t.has_value() == meet && (!meet || equal(answer, rest)) &&
         (meet || !answer.t || *answer.t >= 0);
}

LAW("swept_aabb_aabb: boxes of the plane made one high have the answer of the plane, whether they rise or not", a, b,
    v) {
  if constexpr (requires { a.min.z; }) return true;
  else {
    const auto high = [](const Aabb2d& box, double z) {
      return Aabb3d{{box.min.x, box.min.y, 0}, {box.max.x, box.max.y, z}};
    };
    const auto answer = ask(std::tuple(a, b, v));
    return equal(ask(InSpace{high(a, 1), high(b, 1), {v.x, v.y, 1}}), answer) &&
           equal(ask(InSpace{high(a, 0), high(b, 0), {v.x, v.y, 0}}), answer);
  }
}

TEST_CASE(
    "swept_aabb_aabb: at the exact t the boxes touch on an axis on which they come nearer, and on no axis are apart") {
  law_of<Row>(
      "oracle: first contact", [](const auto& asked) { return catalogue::ask_oracle<Row>(asked).answer; },
      of_boxes([](const auto& ask, const auto& a, const auto& b, const auto& v) {
        const auto answer = ask(std::tuple(a, b, v));
        if (!answer.t) return true;
        bool entry = *answer.t == 0;
        for (const Axis& m : axes_of(a, b, v)) {
          const Rational gap = gap_at(m, *answer.t), before = gap_at(m, Rational(*answer.t - 1));
          if (gap > 0) return false;
          entry = entry || (gap == 0 && before > 0);
        }
        return entry && *answer.t >= 0 && *answer.t <= 1;
      }),
      3);
}

TEST_CASE("swept_aabb_aabb: p. 51's times worked by hand, and how far a has to be moved to miss or to meet") {
  const Aabb2d beyond{{6, 1}, {9, 3}};
  // x: from 2 / 4 to 10 / 4; y: from -5 / 4 to 3 / 4. By 1 / 2 on both axes, both are 5 / 8.
  worked(InPlane{{{-2, 0}, {0, 4}}, {{2, -1}, {8, 3}}, {4, 4}}, at(Rational(1, 2)), Rational(1, 2));
  worked(InPlane{square, beyond, {3, 0}}, at(Rational(2, 3)), 1);               // by 1, and a only just gets there
  worked(InPlane{square, beyond, {1, 0}}, misses, 1);                           // 2 - 1
  worked(InPlane{square, beyond, {-3, 0}}, misses, 2);                          // away: 2 at the start
  worked(InPlane{square, beyond, {0, 0}}, misses, 2);                           // at rest
  worked(InPlane{square, beyond, {8, 8}}, at(Rational(1, 4)), Rational(1, 2));  // x: 2 / 8; y: until 3 / 8
  worked(InPlane{square, beyond, {8, 16}}, misses, Rational(1, 3));  // y: until 3 / 16; by 1 / 3, both are 5 / 24
  worked(InSpace{cube, {{6, 1, -7}, {9, 3, -5}}, {2, 0, -5}}, at(Rational(1)), 0);  // on x and z at the end
  // x: from 2 / 4; z: from 5 / 10 to 11 / 10. By 12 / 7, both x's entry and z's exit are 13 / 14.
  worked(InSpace{cube, {{6, 1, -7}, {9, 3, -5}}, {4, 0, -10}}, at(Rational(1, 2)), Rational(12, 7));
}

TEST_CASE("swept_aabb_aabb: touching is a hit: corner by corner, along a face, at the start and at the end") {
  worked(InPlane{square, {{8, -8}, {12, -2}}, {8, -4}}, at(Rational(1, 2)), 2);  // both enter; y ends 2 deep
  worked(InPlane{square, {{6, -6}, {8, 0}}, {2, 1}}, misses, Rational(2, 3));    // y: until 0 / 1; x: from 2 / 2
  worked(InPlane{{{-4, -4}, {0, 0}}, {{4, -12}, {12, 0}}, {8, 8}}, at(Rational(1, 2)), 0);  // corner by corner
  worked(InPlane{square, {{6, 4}, {9, 5}}, {4, 0}}, at(Rational(1, 2)), 0);                 // along y = 4
  worked(InPlane{square, {{4, 1}, {9, 3}}, {-1, 1}}, at(Rational(0)), 0);                   // they part
  worked(InPlane{square, {{4, 1}, {9, 3}}, {1, 1}}, at(Rational(0)), 1);                    // they go deeper, to 1
  worked(InPlane{square, {{4, 1}, {9, 3}}, {0, 1}}, at(Rational(0)), 0);                    // along x = 4
  worked(InPlane{square, {{6, 1}, {9, 3}}, {2, 1}}, at(Rational(1)), 0);
  worked(InPlane{square, square, {1, 1}}, at(Rational(0)), 4);
}

TEST_CASE("swept_aabb_aabb: flat boxes and points are entered, or grazed") {
  worked(InPlane{{{0, 0}, {0, 0}}, {{2, -1}, {2, 3}}, {4, 2}}, at(Rational(1, 2)), Rational(4, 3));  // y = 1 there
  worked(InPlane{{{0, 0}, {0, 0}}, {{2, 1}, {2, 1}}, {4, 2}}, at(Rational(1, 2)), 0);
  worked(InPlane{{{0, 0}, {0, 0}}, {{2, 1}, {2, 1}}, {4, 3}}, misses, Rational(2, 7));  // x: 1/2; y: 1/3
  worked(InPlane{{{1, 1}, {1, 1}}, {{1, 1}, {1, 1}}, {0, 0}}, at(Rational(0)), 0);
}

TEST_CASE("swept_aabb_aabb: rounding moves an entry to an exit") {
  // x: from (1 + 2^-60) / 4, which is 1 / 4 in double; y: until 1 / 4.
  worked(InPlane{{{-1, 0}, {-0x1p-60, 1}}, {{1, -1}, {2, 1}}, {4, 4}}, misses, power_of_two(-61), "rounding");
}

CONTRACT("swept_aabb_aabb: the formula in double keeps its contract", a, b, v) {
  struct Time {
    Rational value, error;
    std::size_t axis;
  };
  std::vector<Time> entries, exits;
  Rational first, error;
  for (const Axis& m : axes_of(a, b, v)) {
    const double near = m.b_min - m.a_max, far = m.b_max - m.a_min;
    if (!finite(near, far)) return true;
    if (m.velocity == 0) {
      if (near > 0 || far < 0) return answer.relation == HitRelation::never;
      continue;
    }
    const auto time = [&](double from, double to) {
      const Rational t((exact(to) - exact(from)) / exact(m.velocity));
      return Time{t, Rational(3 * unit() * abs(t) + power_of_two(-1074)), entries.size()};
    };
    const Time one = time(m.a_max, m.b_min), two = time(m.a_min, m.b_max);
    exits.push_back(m.velocity > 0 ? two : one), entries.push_back(m.velocity > 0 ? one : two);
  }
  entries.push_back({0, 0, entries.size()}), exits.push_back({1, 0, entries.size()});
  for (const Time& entry : entries) {
    for (const Time& exit : exits)
      if (entry.axis != exit.axis && abs(Rational(entry.value - exit.value)) <= entry.error + exit.error) return true;
    if (entry.value > first) first = entry.value;
    if (entry.error > error) error = entry.error;
  }
  if (answer.relation != truth.answer.relation) return false;
  return !answer.t || within(*answer.t, *truth.answer.t, Rational(3 * unit() * first + power_of_two(-1074)));
}

TEST_CASE("swept_aabb_aabb: the formula is right in exact arithmetic") { right_in_exact_arithmetic<Row>(); }

}  // namespace touchstone::proptests::swept_aabb_aabb_tests
