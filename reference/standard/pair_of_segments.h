// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "geometry/answers.h"
#include "geometry/capsules.h"
#include "reference/mixed/segment_segment_distance.h"

/// Nearest points of two segments, parallel ones and points among them. Contracts:
/// reference/mixed/segment_segment_distance.h, reference/mixed/capsule_capsule.h. In exact arithmetic both formulas are
/// right except for which of several nearest pairs they name, and of capsules without an interior.
namespace touchstone::reference::standard {

/// Parameters of the points a0 + s (a1 - a0) and b0 + t (b1 - b0).
template <class Real>
struct Parameters {
  Real s, t;
};

/// Half the squared distance of two points of the lines, a quadratic function of the parameters, by its coefficients.
template <class Real>
struct SquareOfDistance {
  Real vv, vw, ww, vr, wr;

  template <class Point>
  SquareOfDistance(const Point& a0, const Point& a1, const Point& b0, const Point& b1) {
    const auto v = a1 - a0, w = b1 - b0, r = a0 - b0;
    vv = dot(v, v), vw = dot(v, w), ww = dot(w, w), vr = dot(v, r), wr = dot(w, r);
  }
};

/// Each parameter is moved into [0, 1] in its turn; the first is 0 if the lines are parallel (Ericson, Real-Time
/// Collision Detection, 5.1.9).
struct ByClamping {
  template <class Real>
  static Parameters<Real> parameters(const SquareOfDistance<Real>& q) {
    const Real zero(0);
    if (q.vv == zero && q.ww == zero) return {zero, zero};
    if (q.vv == zero) return {zero, in_unit_interval<Real>(Real(q.wr / q.ww))};
    if (q.ww == zero) return {in_unit_interval<Real>(Real(-q.vr / q.vv)), zero};
    const Real determinant = Real(q.vv * q.ww - q.vw * q.vw);
    const Real s =
        determinant == zero ? zero : in_unit_interval<Real>(Real(Real(q.vw * q.wr - q.vr * q.ww) / determinant));
    const Real t = Real(Real(q.vw * s + q.wr) / q.ww);
    if (t < zero) return {in_unit_interval<Real>(Real(-q.vr / q.vv)), zero};
    if (t > Real(1)) return {in_unit_interval<Real>(Real(Real(q.vw - q.vr) / q.vv)), Real(1)};
    return {s, t};
  }
};

/// The least value of a convex quadratic function on a square: along the line on which its derivative by s is 0, as far
/// as that is in the square (Eberly, Robust computation of distance between line segments, 2015). No determinant of
/// nearly parallel lines is divided by.
struct OnSquare {
  template <class Real>
  static Parameters<Real> parameters(const SquareOfDistance<Real>& q) {
    const Real zero(0), one(1);
    // The derivative by s is vv s - vw t + vr, that by t is ww t - vw s - wr.
    const auto best_s = [&](const Real& t) {
      const Real at_0 = Real(q.vr - q.vw * t);
      return root_in_unit_interval<Real>(at_0, Real(q.vv + at_0));
    };
    const auto best_t = [&](const Real& s) {
      const Real at_0 = Real(-q.wr - q.vw * s);
      return root_in_unit_interval<Real>(at_0, Real(q.ww + at_0));
    };
    const Real s_below = best_s(zero), s_above = best_s(one);
    const bool at_0 = s_below <= zero && s_above <= zero, at_1 = s_below >= one && s_above >= one;
    if (at_0 || at_1) return {at_0 ? zero : one, best_t(at_0 ? zero : one)};
    const auto enters = [&](const Real& s, const Real& t) -> Parameters<Real> {
      if (zero < s && s < one) return {s, t};
      return {s, in_unit_interval<Real>(Real(Real(q.vv * s + q.vr) / q.vw))};
    };
    const Parameters<Real> from = enters(s_below, zero), to = enters(s_above, one);
    const auto slope = [&](const Parameters<Real>& at) { return Real(q.ww * at.t - q.vw * at.s - q.wr); };
    const Real first = slope(from), last = slope(to);
    const auto on_side = [&](const Parameters<Real>& end, const Real& clamped) -> Parameters<Real> {
      if (zero < clamped && clamped < one) return end;
      return {clamped, best_t(clamped)};
    };
    if (first >= zero) return on_side(from, s_below);
    if (last <= zero) return on_side(to, s_above);
    const Real part = Real(first / Real(first - last)), rest = Real(one - part);
    return {Real(rest * from.s + part * to.s), Real(rest * from.t + part * to.t)};
  }

 private:
  /// Where a function that rises from one value at 0 to another at 1 is 0, moved into [0, 1].
  template <class Real>
  static Real root_in_unit_interval(const Real& at_0, const Real& at_1) {
    return at_0 >= Real(0) ? Real(0) : at_1 <= Real(0) ? Real(1) : Real(at_0 / Real(at_0 - at_1));
  }
};

template <class Form, class Real, class Point>
NearestEnds<Point> nearest_ends(const Point& a0, const Point& a1, const Point& b0, const Point& b1) {
  const auto [s, t] = Form::parameters(SquareOfDistance<Real>(a0, a1, b0, b1));
  return {a0 + s * (a1 - a0), b0 + t * (b1 - b0)};
}

template <class Form, class Real>
ClosestPair2<Real> segment_segment_distance(const Segment2<Real>& a, const Segment2<Real>& b) {
  using std::sqrt;
  const auto [x, y] = nearest_ends<Form, Real>(a.a, a.b, b.a, b.b);
  const Real square = dot(x - y, x - y);
  return {x, y, square, Real(sqrt(square))};
}
template <class Form, class Real>
ClosestPair3<Real> segment_segment_distance(const Segment3<Real>& a, const Segment3<Real>& b) {
  using std::sqrt;
  const auto [x, y] = nearest_ends<Form, Real>(a.a, a.b, b.a, b.b);
  const Real square = dot(x - y, x - y);
  return {x, y, square, Real(sqrt(square))};
}

template <class Form, class Real>
Contact capsule_capsule(const Capsule3<Real>& a, const Capsule3<Real>& b) {
  const auto [x, y] = nearest_ends<Form, Real>(a.segment.a, a.segment.b, b.segment.a, b.segment.b);
  const Real distance = dot(x - y, x - y), sum = Real(a.radius + b.radius), reach = Real(sum * sum);
  return distance > reach ? Contact::disjoint : distance < reach ? Contact::overlapping : Contact::touching;
}

}  // namespace touchstone::reference::standard
