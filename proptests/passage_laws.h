// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "geometry/rays.h"
#include "oracle/exact/numbers/surd.h"
#include "proptests/forward_error.h"

/// Laws of a ray or a segment and a solid, in the plane and in space.
namespace touchstone::proptests {

using oracle::Surd;

template <class Place>
std::vector<double> coordinates(const Place& p) {
  if constexpr (requires { p.z; }) return {p.x, p.y, p.z};
  else return {p.x, p.y};
}

/// In space, at z = 0.
inline Point3d in_space(const Point2d& p) { return {p.x, p.y, 0}; }
inline Point3d in_space(const Point3d& p) { return p; }
inline Vector3d in_space(const Vector2d& v) { return {v.x, v.y, 0}; }
inline Vector3d in_space(const Vector3d& v) { return v; }
inline Ray3d in_space(const Ray2d& r) { return {in_space(r.origin), in_space(r.direction)}; }
inline Ray3d in_space(const Ray3d& r) { return r; }
inline Segment3d in_space(const Segment2d& s) { return {in_space(s.a), in_space(s.b)}; }
inline Segment3d in_space(const Segment3d& s) { return s; }
inline Sphere3d in_space(const Circle2d& c) { return {in_space(c.center), c.radius}; }
inline Sphere3d in_space(const Sphere3d& s) { return s; }
inline Aabb3d in_space(const Aabb2d& b) { return {in_space(b.min), in_space(b.max)}; }
inline Aabb3d in_space(const Aabb3d& b) { return b; }

/// A solid that holds another is met wherever that is, and not later, and left not earlier.
template <class Answer>
bool held_by(const Answer& inner, const Answer& outer) {
  if (inner.relation == PassageRelation::none) return true;
  return outer.relation == PassageRelation::hit && *outer.first <= *inner.first && *inner.last <= *outer.last;
}

/// first comes before last, both of them from 0 on, and up to 1 where the line ends.
template <class Answer>
bool in_order(const Answer& answer, bool ends) {
  using Number = std::decay_t<decltype(*answer.first)>;
  if (answer.relation == PassageRelation::none) return !answer.first && !answer.last;
  const Number zero(0), one(1);
  return zero <= *answer.first && *answer.first <= *answer.last && (!ends || *answer.last <= one);
}

/// found 2^k = t
inline bool divided(double t, double found, int k) { return scaled_number(t, found, -k); }
inline bool divided(const Rational& t, const Rational& found, int k) { return t == found * exact(std::ldexp(1, k)); }
inline bool divided(const Surd& t, const Surd& found, int k) { return t == found * Surd(exact(std::ldexp(1, k))); }

/// A direction times a power of two divides first and last by it.
template <class Row>
inline constexpr auto directions_divide_t = [](const auto& ask, const auto& asked) {
  const auto divides = [&](const auto& question) {
    const auto answer = ask(asked);
    for (const int k : {1, -29, 300}) {
      auto other = question;
      auto& v = std::get<0>(other).direction;
      const auto given = coordinates(v);
      v = std::ldexp(1, k) * v;
      if (coordinates(std::ldexp(1, -k) * v) != given) continue;
      const auto found = ask(typename Row::Question(other));
      if (found.relation != answer.relation) return false;
      if (answer.first && !divided(*answer.first, *found.first, k)) return false;
      if (answer.last && !divided(*answer.last, *found.last, k)) return false;
    }
    return true;
  };
  if constexpr (requires { asked.index(); }) return std::visit(divides, asked);
  else return divides(asked);
};

/// What one axis sees of a line and a box: `to` is the end of a segment, or the direction of a ray.
struct SlabAxis {
  double from, to, min, max;
};

/// Whether the line is a segment, which ends; and what it says after its start: its end or its direction.
template <class Line>
inline constexpr bool ends = requires(const Line& line) {
  line.b;
};
inline const auto& start_of(const auto& line) {
  if constexpr (ends<std::decay_t<decltype(line)>>) return line.a;
  else return line.origin;
}
inline const auto& goal_of(const auto& line) {
  if constexpr (ends<std::decay_t<decltype(line)>>) return line.b;
  else return line.direction;
}

/// What reference/mixed/ray_aabb.h and segment_aabb.h promise of times that are off by 3 u or 4 u of themselves.
template <class Truth, class Answer, class Line, class Box>
bool slab_times_keep(const Truth& truth, const Answer& answer, const Line& line, const Box& box) {
  constexpr bool ends = proptests::ends<Line>;
  constexpr int roundings = ends ? 4 : 3;
  const auto start = coordinates(start_of(line)), goal = coordinates(goal_of(line)), low = coordinates(box.min),
             high = coordinates(box.max);
  std::vector<SlabAxis> axes;
  for (std::size_t k = 0; k < start.size(); ++k) axes.push_back({start[k], goal[k], low[k], high[k]});
  struct Time {
    Rational value, error;
    std::size_t axis;
  };
  std::vector<Time> entries{{0, 0, axes.size()}}, exits;
  for (std::size_t k = 0; k < axes.size(); ++k) {
    const auto& [from, to, min, max] = axes[k];
    const double displacement = ends ? to - from : to;
    if (!finite(min - from, max - from, displacement)) return true;
    if (displacement == 0) {
      if (from < min || max < from) return answer.relation == PassageRelation::none;
      continue;
    }
    const Rational exactly(ends ? Rational(exact(to) - exact(from)) : exact(to));
    if (!finite((min - from) / displacement, (max - from) / displacement)) return true;
    const auto time = [&, from = from](double side) {
      const Rational t((exact(side) - exact(from)) / exactly);
      return Time{t, Rational(roundings * unit() * abs(t) + power_of_two(-1073)), k};
    };
    entries.push_back(time(displacement > 0 ? min : max)), exits.push_back(time(displacement > 0 ? max : min));
  }
  if (exits.empty()) return true;  // a segment of length zero
  if (ends) exits.push_back({1, 0, axes.size() + 1});
  for (const Time& entry : entries)
    for (const Time& exit : exits)
      if (entry.axis != exit.axis && abs(Rational(entry.value - exit.value)) <= entry.error + exit.error) return true;
  if (answer.relation != truth.answer.relation) return false;
  if (answer.relation == PassageRelation::none) return true;
  const auto as_good = [&](double t, const Rational& right) {
    return !finite(t) || within(t, right, Rational(roundings * unit() * right + power_of_two(-1073)));
  };
  return as_good(*answer.first, *truth.answer.first) && as_good(*answer.last, *truth.answer.last);
}

/// What reference/mixed/ray_sphere.h and segment_sphere.h promise of both roots, p and v as they are computed, q = p .
/// p + r^2 and speed = v . v as they are: a certain miss, or a certain hit with roots off by so much; or nothing.
struct CertainRoots {
  bool miss = false, hit = false;
  Rational of_first{}, of_last{};
};
template <class Vector>
CertainRoots certain_roots(const Vector& p, const Vector& v, double r, const Rational& q, const Rational& speed,
                           bool ends) {
  CertainRoots found;
  for (const Rational& x : {q, speed})
    if (x < power_of_two(-480) || x > power_of_two(480)) return found;
  const double square = dot(v, v), linear = 2 * dot(p, v), constant = dot(p, p) - r * r;
  const double d = linear * linear - 4 * square * constant;
  const Rational error_of_d = 104 * unit() * speed * q;
  found.miss = exact(d) < -error_of_d;
  if (!(exact(d) > error_of_d)) return found;
  const double s = std::sqrt(d), smaller = (-linear - s) / (2 * square), greater = (s - linear) / (2 * square);
  // e(T), put together in double: (1 + 2^-40) is more than all roundings of that.
  const auto error_of = [&](double t) {
    const double e = (7 * std::sqrt(Rational(q / speed).get_d()) + 53 * q.get_d() / s + 9 * std::fabs(t)) * 0x1p-53;
    return Rational(exact(e + tiny) * (1 + power_of_two(-40)));
  };
  const Rational e = found.of_first = error_of(smaller), f = found.of_last = error_of(greater);
  const Rational t = exact(smaller), w = exact(greater);
  found.miss = w < -f || (ends && t > 1 + e);
  found.hit = w > f && (!ends || t < 1 - e);
  return found;
}
template <class Truth, class Answer, class Vector>
bool roots_keep(const Truth& truth, const Answer& answer, const Vector& p, const Vector& v, double r, const Rational& q,
                const Rational& speed, bool ends) {
  const auto [miss, hit, e, f] = certain_roots(p, v, r, q, speed, ends);
  if (!miss && !hit) return true;
  const PassageRelation relation = hit ? PassageRelation::hit : PassageRelation::none;
  if (answer.relation != relation || truth.answer.relation != relation) return false;
  const auto near = [](double found, const Surd& right, const Rational& error) {
    return Surd(Rational(exact(found) - error)) <= right && right <= Surd(Rational(exact(found) + error));
  };
  return miss || (near(*answer.first, *truth.answer.first, e) && near(*answer.last, *truth.answer.last, f));
}

/// The squared distance of two points, exactly.
template <class Place>
Rational squared_distance(const Place& p, const Place& q) {
  const auto x = coordinates(p), y = coordinates(q);
  Rational sum;
  for (std::size_t k = 0; k < x.size(); ++k)
    sum += Rational(exact(x[k]) - exact(y[k])) * Rational(exact(x[k]) - exact(y[k]));
  return sum;
}

inline bool reversed(const std::optional<Surd>& t, const std::optional<Surd>& s) {
  return t.has_value() == s.has_value() && (!t || *s == Surd(Rational(1)) - *t);
}

/// Words of worked examples.
namespace passages {
using Relation = PassageRelation;
inline const Passage<Rational> none{Relation::none, {}, {}};
inline Passage<Rational> from_to(const Rational& first, const Rational& last) { return {Relation::hit, first, last}; }
}  // namespace passages
namespace surd_passages {
using Relation = PassageRelation;
inline const Passage<Surd> none{Relation::none, {}, {}};
inline Passage<Surd> from_to(const Surd& first, const Surd& last) { return {Relation::hit, first, last}; }
}  // namespace surd_passages

/// AABB_PASSAGE_LAWS("ray_aabb", "ray") is four test cases, in the types of the file's `Row`; the others are alike.
#define AABB_PASSAGE_LAWS(operation, kind)                                                                          \
  LAW(operation ": first comes before last, and both are on the " kind, line) {                                     \
    return in_order(ask(asked), ends<std::decay_t<decltype(line)>>);                                                \
  }                                                                                                                 \
  LAW(operation ": a box that holds another is met wherever that is, not later, and left not earlier", line, box) { \
    auto larger = box;                                                                                              \
    larger.max.x = catalogue::moved_by_ulps(box.max.x, 1), larger.min.y = catalogue::moved_by_ulps(box.min.y, -3);  \
    return held_by(ask(asked), ask(std::tuple(line, larger)));                                                      \
  }                                                                                                                 \
  LAW(operation ": in the plane the same as in space, in a flat box or in one with an inside", line, box) {         \
    if constexpr (requires { box.min.z; }) return true;                                                             \
    const auto answer = ask(asked);                                                                                 \
    const auto& [low, high] = in_space(box);                                                                        \
    const Aabb3d thick{{low.x, low.y, -1}, {high.x, high.y, 1}};                                                    \
    return equal(ask(Row::InSpace{in_space(line), {low, high}}), answer) &&                                         \
           equal(ask(Row::InSpace{in_space(line), thick}), answer);                                                 \
  }                                                                                                                 \
  CONTRACT(operation ": the formula in double keeps its contract", line, box) {                                     \
    return slab_times_keep(truth, answer, line, box);                                                               \
  }
#define BALL_PASSAGE_LAWS(operation, kind)                                                                   \
  LAW(operation ": first comes before last, and both are on the " kind, line) {                              \
    return in_order(ask(asked), ends<std::decay_t<decltype(line)>>);                                         \
  }                                                                                                          \
  LAW(operation ": a ball that grows is met wherever it was, not later, and left not earlier", line, ball) { \
    auto larger = ball;                                                                                      \
    larger.radius = catalogue::moved_by_ulps(larger.radius, 2);                                              \
    return held_by(ask(asked), ask(std::tuple(line, larger)));                                               \
  }                                                                                                          \
  LAW(operation ": in the plane the same as in space", line, ball) {                                         \
    return equal(ask(Row::InSpace{in_space(line), in_space(ball)}), ask(asked));                             \
  }
#define REVERSED_PASSAGE_LAW(operation)                                                     \
  LAW(operation ": the reversed segment enters where the segment leaves", segment, solid) { \
    const std::decay_t<decltype(segment)> back{segment.b, segment.a};                       \
    const auto answer = ask(asked), found = ask(std::tuple(back, solid));                   \
    if (segment.a == segment.b) return equal(answer, found);                                \
    return answer.relation == found.relation && reversed(answer.first, found.last) &&       \
           reversed(answer.last, found.first);                                              \
  }
#define DIRECTION_PASSAGE_LAW(operation)                                                   \
  TEST_CASE(operation ": a direction times a power of two divides first and last by it") { \
    law<Row>("longer and shorter", directions_divide_t<Row>);                              \
  }

}  // namespace touchstone::proptests
