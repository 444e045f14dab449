// SPDX-License-Identifier: Apache-2.0
#include "oracle/sweeps/swept_convex_polyhedra.h"

#include <array>
#include <stdexcept>
#include <utility>
#include <vector>

#include "geometry/validation.h"
#include "oracle/exact/solids/meeting_solids.h"

namespace touchstone::oracle {
namespace {

using SweptConvexPolyhedraProgram = LinearProgram<Integer>;

template <class Number>
Motion validated_swept_convex_polyhedra(const Mesh<Number>& a, const Mesh<Number>& b, const Vector3<Number>& velocity) {
  validation::validate_numbers("a", a), validation::validate_numbers("b", b),
      validation::validate_numbers("velocity", velocity);
  const ConvexMesh first("a", a), second("b", b);
  return motion(first, second, {exact(velocity.x), exact(velocity.y), exact(velocity.z)});
}

std::vector<Rational> listed(const Coordinates& p) { return {Rational(p[0]), Rational(p[1]), Rational(p[2])}; }

Integer product(const Coordinates& p, const Coordinates& q) { return Integer(p[0] * q[0] + p[1] * q[1] + p[2] * q[2]); }

/// A normal n with n . velocity > 0 and n . p + t n . velocity <= n . q for all vertices p of a and q of b. Variables:
/// the positive and the negative parts of n, and of a number in between; n . velocity is 1 in the unit's square.
std::vector<Rational> touching_normal_swept_convex_polyhedra(const Motion& m, const Rational& t) {
  std::vector<SweptConvexPolyhedraProgram::Row> rows(m.a.size() + m.b.size() + 1,
                                                     SweptConvexPolyhedraProgram::Row::at_most);
  rows.back() = SweptConvexPolyhedraProgram::Row::equal;
  SweptConvexPolyhedraProgram program(8, rows);
  const auto set = [&program](int row, int variable, const Integer& coefficient) {
    program.set_coefficient(row, variable, coefficient);
    program.set_coefficient(row, variable + 1, Integer(-coefficient));
  };
  int row = 0;
  const Integer& d = t.get_den();
  for (const Coordinates& p : m.a) {
    for (std::size_t k = 0; k < 3; ++k)
      set(row, static_cast<int>(2 * k), Integer(d * p[k] + t.get_num() * m.velocity[k]));
    set(row++, 6, Integer(-d));
  }
  for (const Coordinates& q : m.b) {
    for (std::size_t k = 0; k < 3; ++k) set(row, static_cast<int>(2 * k), Integer(-q[k]));
    set(row++, 6, Integer(1));
  }
  for (std::size_t k = 0; k < 3; ++k) set(row, static_cast<int>(2 * k), m.velocity[k]);
  program.set_right_side(row, product(m.velocity, m.velocity));
  if (!program.feasible()) throw std::logic_error("solids that first meet on the way are separated until then");
  const auto part = [&program](int k) {
    return Rational(rational(Integer(program.numerator(2 * k) - program.numerator(2 * k + 1))));
  };
  return {part(0), part(1), part(2)};
}

Certificate of_hit(const Motion& m, const Meeting& meeting, const Rational& t) {
  std::array<Rational, 3> point;
  for (std::size_t j = 0; j < m.b.size(); ++j) {
    const Rational weight = meeting.value(static_cast<int>(m.a.size() + j));
    for (std::size_t k = 0; k < 3; ++k) point[k] += weight * m.b[j][k];
  }
  std::vector<Rational> common;
  for (const Rational& coordinate : point) common.push_back(Rational(coordinate * m.unit));
  if (sgn(t) == 0) return {"start", {{"point", std::move(common)}}};
  return {"first_contact", {{"point", std::move(common)}, {"normal", touching_normal_swept_convex_polyhedra(m, t)}}};
}

Truth<FirstContact<Rational>> truth_swept_convex_polyhedra(Motion m) {
  Meeting meeting(m);
  if (!meeting.program().feasible()) {
    const auto& y = meeting.program().farkas();
    return {{HitRelation::never, std::nullopt},
            Rational(distance(m) * m.unit),
            [x = Integer(-y[0]), y = Integer(-y[1]), z = Integer(-y[2])] {
              return Certificate{"separating_axis", {{"normal", listed({x, y, z})}}};
            }};
  }
  const Rational t = meeting.optimum(meeting.time()), margin(depth(m) * m.unit);
  return {{HitRelation::hit, t}, margin, [m = std::move(m), meeting = std::move(meeting), t] {
            return of_hit(m, meeting, t);
          }};
}

}  // namespace

template <Exact Number>
Truth<FirstContact<Rational>> swept_convex_polyhedra(const Mesh<Number>& a, const Mesh<Number>& b,
                                                     const Vector3<Number>& velocity) {
  return truth_swept_convex_polyhedra(validated_swept_convex_polyhedra(a, b, velocity));
}
template Truth<FirstContact<Rational>> swept_convex_polyhedra(const Meshd&, const Meshd&, const Vector3d&);
template Truth<FirstContact<Rational>> swept_convex_polyhedra(const Mesh<Rational>&, const Mesh<Rational>&,
                                                              const Vector3<Rational>&);

}  // namespace touchstone::oracle
