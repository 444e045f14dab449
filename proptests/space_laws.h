// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "proptests/forward_error.h"

/// Laws of questions in space.
namespace touchstone::proptests {

/// An exchange of the axes with signs, the normal turned with them: exact for every double.
struct AxisMap {
  int from[3];
  double sign[3];

  template <class T>
  requires requires(T v) { v.x, v.y, v.z; }
  void place(T& v) const {
    const auto old = v;
    const auto part = [&](int i) { return from[i] == 0 ? old.x : from[i] == 1 ? old.y : old.z; };
    const auto turned = [&](int i) { return decltype(old.x)(sign[i] < 0 ? -part(i) : part(i)); };
    v = {turned(0), turned(1), turned(2)};
  }
  template <class T>
  T operator()(T value) const {
    for_each_part(value, *this);
    return value;
  }
};

/// The axes turned round, exchanged (a reflection), and turned over; with the first two every signed exchange can be
/// made.
inline constexpr std::array<AxisMap, 4> axis_maps{
    {{{1, 2, 0}, {1, 1, 1}}, {{1, 0, 2}, {1, 1, 1}}, {{0, 1, 2}, {1, -1, 1}}, {{2, 0, 1}, {-1, 1, -1}}}};

/// Whether every number is an integer of at most 40 bits, so that small integer shifts and multiples do not round.
template <class Asked>
bool on_small_lattice(const Asked& asked) {
  bool whole = true;
  audit::for_each_number(asked,
                         [&](const double& n) { whole = whole && std::fabs(n) <= 0x1p40 && n == std::trunc(n); });
  return whole;
}

/// N . p + d as the slide's formula computes it, and the bound e(E) of reference/planes/point_plane.h.
struct HeightBound {
  double computed;
  bool overflow;
  Rational error;

  HeightBound(const Plane3d& plane, const Point3d& p) {
    const double x = plane.normal.x * p.x, y = plane.normal.y * p.y, z = plane.normal.z * p.z;
    computed = x + y + z + plane.offset;
    overflow = !finite(x, y, z, x + y, x + y + z, computed);
    if (overflow) return;
    const Rational u = unit();
    error = (4 + 16 * u) * u * (size(x) + size(y) + size(z) + size(plane.offset)) + power_of_two(-1073);
  }
  bool certain() const { return !overflow && size(computed) > error; }
};

}  // namespace touchstone::proptests
