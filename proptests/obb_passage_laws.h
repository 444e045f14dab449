// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <vector>

#include "proptests/box_laws.h"
#include "proptests/passage_laws.h"
#include "reference/mixed/segment_obb.h"
#include "robust/mixed/ray_aabb.h"
#include "robust/mixed/segment_aabb.h"

/// Laws of a ray or a segment and an oriented box.
namespace touchstone::proptests {

namespace obb_passages {

using namespace passages;
inline constexpr Obb3d unit_cube{{0, 0, 0}, {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}};
inline constexpr Obb3d dependent{{0, 0, 0}, {{1, 1, 0}, {0, 1, 1}, {1, 2, 1}}};

/// What the laws need to know of a ray or a segment: its start and its way, as the formula computes it, and exactly.
inline Point3d start(const Ray3d& r) { return r.origin; }
inline Point3d start(const Segment3d& s) { return s.a; }
inline Vector3d way(const Ray3d& r) { return r.direction; }
inline Vector3d way(const Segment3d& s) { return s.b - s.a; }
inline Vector3<Rational> exact_way(const Ray3d& r) { return exact_vector(r.direction); }
inline Vector3<Rational> exact_way(const Segment3d& s) { return exact_point(s.b) - exact_point(s.a); }
inline Passage<Rational> by_formula(const Ray3d& r, const Obb3d& box) {
  return reference::ray_obb<Rational>({exact_point(r.origin), exact_vector(r.direction)}, exact_obb(box));
}
inline Passage<Rational> by_formula(const Segment3d& s, const Obb3d& box) {
  return reference::segment_obb<Rational>({exact_point(s.a), exact_point(s.b)}, exact_obb(box));
}
inline Passage<double> in_aabb(const Ray3d& r, const Aabb3d& box) { return robust::ray_aabb(r, box); }
inline Passage<double> in_aabb(const Segment3d& s, const Aabb3d& box) { return robust::segment_aabb(s, box); }

inline bool is_nearest(double number, const Rational& exactly) { return number == catalogue::nearest(exactly); }
inline bool is_nearest(const Rational& number, const Rational& exactly) { return number == exactly; }
/// Where the half axes are at right angles, an answer is, or rounds, that of the formula in exact arithmetic, but for a
/// segment without length.
template <class Answer, class Line>
bool is_by_formula(const Answer& answer, const Line& line, const Obb3d& box) {
  if (!has_right_angles(box) || (ends<Line> && equal(way(line), Vector3d{0, 0, 0}))) return true;
  const Passage<Rational> exactly = by_formula(line, box);
  if (answer.relation != exactly.relation) return false;
  return !exactly.first || (is_nearest(*answer.first, *exactly.first) && is_nearest(*answer.last, *exactly.last));
}

/// What reference/mixed/ray_obb.h and segment_obb.h promise.
template <class Line, class Answer>
bool slabs_keep(const Answer& answer, const Line& line, const Obb3d& box) {
  struct Time {
    Rational value, error;
    std::size_t axis;
  };
  std::vector<Time> entries{{0, 0, 3}}, exits;
  if (ends<Line>) exits.push_back({1, 0, 4});
  const Rational u = unit(), underflow = power_of_two(-1073);
  const Vector3<Rational> d = exact_point(start(line)) - exact_point(box.center), v = exact_way(line);
  std::size_t axis = 0;
  for (const Vector3d& h : {box.half_axes.u, box.half_axes.v, box.half_axes.w}) {
    const Vector3<Rational> a = exact_vector(h);
    const double length = dot(h, h), along = dot(h, start(line) - box.center), climb = dot(h, way(line));
    if (!finite(length, along, climb, along + length, along - length)) return true;
    const auto sizes = [&a](const Vector3<Rational>& x) {
      return Rational(abs(a.x * x.x) + abs(a.y * x.y) + abs(a.z * x.z));
    };
    const Rational reach = dot(a, a), height = dot(a, d), f = dot(a, v), q = sizes(v),
                   of_n = (5 + 12 * u) * u * (sizes(d) + reach) + power_of_two(-1071),
                   of_f = (ends<Line> ? Rational(4 + 7 * u) : Rational(3 + 4 * u)) * u * q + underflow;
    if (sgn(q) == 0) {
      const Rational inside(reach - abs(height));
      if (abs(inside) <= of_n) return true;
      if (sgn(inside) < 0) return answer.relation == Relation::none;
      continue;
    }
    if (abs(f) <= of_f || !finite((-length - along) / climb, (length - along) / climb)) return true;
    const auto time = [&](const Rational& side) {
      const Rational t((side - height) / f), of_quotient((of_n + abs(t) * of_f) / (abs(f) - of_f));
      return Time{t, Rational((1 + 2 * u) * of_quotient + u * abs(t) + underflow / 2), axis};
    };
    const Time one = time(Rational(-reach)), other = time(reach);
    entries.push_back(sgn(f) > 0 ? one : other), exits.push_back(sgn(f) > 0 ? other : one);
    ++axis;
  }
  for (const Time& entry : entries)
    for (const Time& exit : exits)
      if (entry.axis != exit.axis && abs(Rational(entry.value - exit.value)) <= entry.error + exit.error) return true;
  const Passage<Rational> exactly = by_formula(line, box);
  if (answer.relation != exactly.relation) return false;
  if (answer.relation == Relation::none) return true;
  const auto as_good = [](double t, const Rational& right, const std::vector<Time>& times) {
    Rational error;
    for (const Time& each : times) error = std::max(error, each.error);
    return within(t, right, error);
  };
  return as_good(*answer.first, *exactly.first, entries) && as_good(*answer.last, *exactly.last, exits);
}

}  // namespace obb_passages

/// OBB_PASSAGE_LAWS("ray_obb") is six test cases, in the types of the file's `Row`.
#define OBB_PASSAGE_LAWS(operation)                                                                                    \
  LAW(operation ": first comes before last, and both are on the line", line) {                                         \
    return in_order(ask(asked), ends<std::decay_t<decltype(line)>>);                                                   \
  }                                                                                                                    \
  LAW(operation ": a box that is twice as large is met wherever it was, not later, and left not earlier", line, box) { \
    const auto larger = twice_as_large(box);                                                                           \
    return !larger || held_by(ask(asked), ask(Row::Question{line, *larger}));                                          \
  }                                                                                                                    \
  LAW(operation ": a box that is written in another way is met at the same times") {                                   \
    return equal(ask(in_another_order<1>(asked)), ask(asked));                                                         \
  }                                                                                                                    \
  ROBUST_LAW(operation ": a box along the axes has the passage of the axis-aligned one", line, box) {                  \
    const auto straight = straightened(box);                                                                           \
    if (!on_lattice(asked) || !straight) return true;                                                                  \
    return equal(ask(Row::Question{line, straight->obb}), obb_passages::in_aabb(line, straight->aabb));                \
  }                                                                                                                    \
  LAW(operation ": at right angles the formula is right in exact arithmetic, but for points", line, box) {             \
    return obb_passages::is_by_formula(ask(asked), line, box);                                                         \
  }                                                                                                                    \
  CONTRACT(operation ": the formula in double keeps its contract", line, box) {                                        \
    return obb_passages::slabs_keep(answer, line, box);                                                                \
  }

}  // namespace touchstone::proptests
