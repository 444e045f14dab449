// SPDX-License-Identifier: Apache-2.0
#include "oracle/sweeps/swept_obb_obb.h"

#include <functional>
#include <optional>
#include <stdexcept>
#include <utility>
#include <vector>

#include "oracle/exact/numbers/space.h"
#include "oracle/exact/systems/linear_program.h"
#include "oracle/exact/systems/zonotope.h"

namespace touchstone::oracle {
namespace {

/// In units of the scale: the half axes of a, then of b; the center of b, and as seen from that of a; the velocity.
struct MovingObb {
  std::vector<Vector3<Integer>> edges;
  Vector3<Integer> center, way, velocity;

  Integer reach(const Vector3<Integer>& normal) const {
    Integer sum(0);
    for (const Vector3<Integer>& edge : edges) sum += abs(dot(normal, edge));
    return sum;
  }
  /// Twice the solid of all displacements, and the origin as seen from its middle.
  Zonotope differences() const {
    std::vector<Vector3<Integer>> doubled{velocity};
    for (const Vector3<Integer>& edge : edges) doubled.push_back(Integer(2) * edge);
    return Zonotope(std::move(doubled));
  }
  Vector3<Integer> from_middle() const { return Integer(2) * way - velocity; }
};

/// t, and a common point then, less the center of b.
struct CommonPoint {
  Rational t;
  Vector3<Rational> point;
};

/// Variable 0 is t, variable 1 + i the coefficient of edge i, plus 1. The way is t times the velocity and the sum of
/// the edges, each with its coefficient.
std::optional<CommonPoint> first_common_point(const MovingObb& m) {
  using Program = LinearProgram<Integer>;
  std::vector<Program::Row> rows(3, Program::Row::equal);
  rows.resize(10, Program::Row::at_most);
  Program program(7, rows);
  const auto set = [&program, &m](int row, auto coordinate) {
    program.set_coefficient(row, 0, m.velocity.*coordinate);
    Integer sum = m.way.*coordinate;
    for (int i = 0; i < 6; ++i) {
      const Integer& edge = m.edges[static_cast<std::size_t>(i)].*coordinate;
      program.set_coefficient(row, 1 + i, edge), sum += edge;
    }
    program.set_right_side(row, sum);
  };
  set(0, &Vector3<Integer>::x), set(1, &Vector3<Integer>::y), set(2, &Vector3<Integer>::z);
  for (int i = 0; i < 7; ++i) {
    program.set_coefficient(3 + i, i, Integer(1));
    program.set_right_side(3 + i, Integer(i == 0 ? 1 : 2));
  }
  if (!program.feasible()) return std::nullopt;
  std::vector<Integer> cost(7);
  cost[0] = 1;
  program.minimise(cost);
  const auto value = [&program](int i) { return quotient(program.numerator(i), program.denominator()); };
  CommonPoint found{value(0), {0, 0, 0}};
  for (int i = 3; i < 6; ++i) {
    const Vector3<Integer>& edge = m.edges[static_cast<std::size_t>(i)];
    const Rational back(1 - value(1 + i));
    found.point = found.point + back * Vector3<Rational>{Rational(edge.x), Rational(edge.y), Rational(edge.z)};
  }
  return found;
}

/// The normal of the face of the differences at the start over which the way, shortened by the motion, enters at t.
Vector3<Integer> normal_at(const MovingObb& m, const Rational& t) {
  for (std::size_t i = 0; i < 6; ++i)
    for (std::size_t j = 0; j < i; ++j) {
      Vector3<Integer> n = cross(m.edges[i], m.edges[j]);
      if (sgn(dot(n, m.velocity)) < 0) n = Integer(-1) * n;
      const Integer speed = dot(n, m.velocity);
      if (sgn(speed) > 0 && t * speed == dot(n, m.way) - m.reach(n)) return n;
    }
  throw std::logic_error("boxes that first meet on the way do so over a face of their differences");
}

std::vector<Rational> listed(const Vector3<Integer>& v) { return {Rational(v.x), Rational(v.y), Rational(v.z)}; }

template <class Scale>
std::function<Certificate()> certificate_swept_obb_obb(const Scale& scale, const MovingObb& m,
                                                       const std::optional<CommonPoint>& first) {
  return [scale, m, first]() -> Certificate {
    if (!first) return {"separating_axis", {{"normal", listed(m.differences().deciding(m.from_middle()).normal)}}};
    const auto& [t, from_center] = *first;
    const auto actual = [&scale](const Rational& x, const Integer& center) {
      return scale.actual(Rational(x + center), 1);
    };
    std::vector<Rational> point{actual(from_center.x, m.center.x), actual(from_center.y, m.center.y),
                                actual(from_center.z, m.center.z)};
    if (sgn(t) == 0) return {"start", {{"point", std::move(point)}}};
    return {"first_contact", {{"point", std::move(point)}, {"normal", listed(normal_at(m, t))}}};
  };
}

}  // namespace

template <Exact Number>
Truth<FirstContact<Rational>> swept_obb_obb(const Obb3<Number>& a, const Obb3<Number>& b,
                                            const Vector3<Number>& velocity) {
  validation::validate_numbers("a", a), validation::validate_numbers("b", b);
  validation::validate_numbers("velocity", velocity);
  validate_parallelepiped("a", a), validate_parallelepiped("b", b);
  const Point3<Number>&c = a.center, &d = b.center;
  const auto& [u, v, w] = a.half_axes;
  const auto& [x, y, z] = b.half_axes;
  const CommonScale<Number, 27> scale({u.x, u.y, u.z, v.x, v.y, v.z, w.x,        w.y,        w.z,  //
                                       x.x, x.y, x.z, y.x, y.y, y.z, z.x,        z.y,        z.z,  //
                                       c.x, c.y, c.z, d.x, d.y, d.z, velocity.x, velocity.y, velocity.z});
  const auto at = [&scale](std::size_t i) {
    return Vector3<Integer>{scale.integer(i), scale.integer(i + 1), scale.integer(i + 2)};
  };
  const MovingObb m{{at(0), at(3), at(6), at(9), at(12), at(15)}, at(21), at(21) - at(18), at(24)};
  const std::optional<CommonPoint> first = first_common_point(m);
  FirstContact<Rational> answer{HitRelation::never, std::nullopt};
  if (first) answer = {HitRelation::hit, first->t};
  const Rational doubled = m.differences().deciding(m.from_middle()).squared_distance();
  return {std::move(answer), scale.actual(Rational(doubled / 4), 2), certificate_swept_obb_obb(scale, m, first)};
}
template Truth<FirstContact<Rational>> swept_obb_obb(const Obb3d&, const Obb3d&, const Vector3d&);
template Truth<FirstContact<Rational>> swept_obb_obb(const Obb3<Rational>&, const Obb3<Rational>&,
                                                     const Vector3<Rational>&);

}  // namespace touchstone::oracle
