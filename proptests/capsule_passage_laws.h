// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <utility>

#include "oracle/mixed/ray_sphere.h"
#include "oracle/mixed/segment_sphere.h"
#include "proptests/passage_laws.h"
#include "robust/mixed/ray_sphere.h"
#include "robust/mixed/segment_sphere.h"
#include "robust/mixed/sphere_capsule.h"

/// Laws of a ray or a segment and a capsule.
namespace touchstone::proptests {

namespace capsule_passages {

using namespace surd_passages;

inline constexpr Segment3d axis{{0, 0, 0}, {4, 0, 0}}, point{{0, 0, 0}, {0, -0.0, 0}};
inline constexpr Capsule3d bar{axis, 2}, slanted{{{0, 0, 0}, {6, 8, 0}}, 5};
inline const Surd root(Rational(0), Rational(1), Rational(3));
inline Surd whole(int n) { return Surd(Rational(n)); }

inline bool holds_point(const Capsule3d& capsule, const Point3d& p) {
  return robust::sphere_capsule({p, 0}, capsule) != Contact::disjoint;
}

inline Passage<double> in_ball(const Ray3d& r, const Sphere3d& ball) { return robust::ray_sphere(r, ball); }
inline Passage<double> in_ball(const Segment3d& s, const Sphere3d& ball) { return robust::segment_sphere(s, ball); }
inline Passage<Surd> truly_in_ball(const Ray3d& r, const Sphere3d& ball) { return oracle::ray_sphere(r, ball).answer; }
inline Passage<Surd> truly_in_ball(const Segment3d& s, const Sphere3d& ball) {
  return oracle::segment_sphere(s, ball).answer;
}
inline Vector3d way(const Ray3d& r) { return r.direction; }
inline Vector3d way(const Segment3d& s) { return s.b - s.a; }
inline Rational speed(const Ray3d& r) { return squared_distance(Vector3d{0, 0, 0}, r.direction); }
inline Rational speed(const Segment3d& s) { return squared_distance(s.a, s.b); }

/// What reference/mixed/ray_capsule.h and segment_capsule.h promise.
template <class Answer, class Line>
bool end_balls_keep(const Answer& answer, const Line& line, const Capsule3d& capsule) {
  const double r = capsule.radius;
  for (const Point3d& end : {capsule.segment.a, capsule.segment.b}) {
    const Rational q = squared_distance(start_of(line), end) + exact(r) * exact(r);
    const CertainRoots roots = certain_roots(start_of(line) - end, way(line), r, q, speed(line), ends<Line>);
    if (!roots.hit) continue;
    const Passage<Surd> ball = truly_in_ball(line, {end, r});
    if (answer.relation == Relation::none || ball.relation == Relation::none) return false;
    if (Surd(Rational(exact(*answer.first) - roots.of_first)) > *ball.first) return false;
    if (finite(*answer.last) && Surd(Rational(exact(*answer.last) + roots.of_last)) < *ball.last) return false;
  }
  return true;
}

}  // namespace capsule_passages

/// CAPSULE_PASSAGE_LAWS("ray_capsule") is five test cases, in the types of the file's `Row`.
#define CAPSULE_PASSAGE_LAWS(operation)                                                                            \
  LAW(operation ": first comes before last, and both are on the line", line) {                                     \
    return in_order(ask(asked), ends<std::decay_t<decltype(line)>>);                                               \
  }                                                                                                                \
  LAW(operation ": a capsule that grows is met wherever it was, not later, and left not earlier", line, capsule) { \
    auto larger = capsule;                                                                                         \
    larger.radius = catalogue::moved_by_ulps(larger.radius, 2);                                                    \
    return held_by(ask(asked), ask(std::tuple(line, larger)));                                                     \
  }                                                                                                                \
  LAW(operation ": a capsule whose ends are exchanged is met at the same times", line, capsule) {                  \
    auto same = capsule;                                                                                           \
    std::swap(same.segment.a, same.segment.b);                                                                     \
    return equal(ask(asked), ask(std::tuple(line, same)));                                                         \
  }                                                                                                                \
  ROBUST_LAW(operation ": a ball at an end is part of the capsule, and a capsule of one point is the ball", line,  \
             capsule) {                                                                                            \
    const auto& [a, b] = capsule.segment;                                                                          \
    const auto answer = ask(asked);                                                                                \
    for (const Point3d& end : {a, b}) {                                                                            \
      const auto ball = capsule_passages::in_ball(line, {end, capsule.radius});                                    \
      if (!held_by(ball, answer)) return false;                                                                    \
      if (!equal(ask(std::tuple(line, Capsule3d{{end, end}, capsule.radius})), ball)) return false;                \
    }                                                                                                              \
    return true;                                                                                                   \
  }                                                                                                                \
  CONTRACT(operation ": the formula in double keeps its contract", line, capsule) {                                \
    return capsule_passages::end_balls_keep(answer, line, capsule);                                                \
  }

}  // namespace touchstone::proptests
