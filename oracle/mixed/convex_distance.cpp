// SPDX-License-Identifier: Apache-2.0
#include "oracle/mixed/convex_distance.h"

#include "geometry/validation.h"
#include "oracle/exact/shapes/nearest_pair.h"
#include "oracle/exact/solids/meeting_solids.h"
#include "oracle/exact/solids/solid_distance.h"

namespace touchstone::oracle {
namespace {

Truth<ConvexDistance<Surd>> meeting(const Motion& m, const Meeting& found) {
  std::vector<Rational> on_a, on_b;
  for (std::size_t i = 0; i < m.a.size(); ++i) on_a.push_back(found.value(static_cast<int>(i)));
  for (std::size_t j = 0; j < m.b.size(); ++j) on_b.push_back(found.value(static_cast<int>(m.a.size() + j)));
  return {{ConvexRelation::meeting, {}, {}, {}, {}},
          Rational(depth(m) * m.unit),
          [on_a = std::move(on_a), on_b = std::move(on_b)] {
            return Certificate{"common_point", {{"on_a", on_a}, {"on_b", on_b}}};
          }};
}

Truth<ConvexDistance<Surd>> apart(const Motion& m, const IntegerSolid& a, const IntegerSolid& b) {
  const Vector3<Rational> displacement = shortest_displacement(a, b);
  const Point3<Rational> on_a = first_nearest(a, b, displacement), on_b = on_a + Rational(-1) * displacement;
  const auto in_units = [&m](const Point3<Rational>& p) {
    return in_space({Rational(p.x * m.unit), Rational(p.y * m.unit), Rational(p.z * m.unit)});
  };
  std::vector<Rational> first = multiplier(a.hull(), b.hull(), on_a, displacement);
  for (Rational& coordinate : first) coordinate *= m.unit;
  const Rational square(dot(displacement, displacement) * m.unit * m.unit);
  auto truth = truth_of_distance(ConvexDistance<Surd>{ConvexRelation::apart, in_units(on_a), in_units(on_b), {}, {}},
                                 square, {{"on_a", a.weights(on_a)}, {"on_b", b.weights(on_b)}, {"first", first}});
  truth.margin = Rational(distance(m) * m.unit);
  return truth;
}

}  // namespace

ConvexDistance<Surd> as_near(const Meshd& a, const Meshd& b, const ConvexDistance<Surd>& truth, const Point3d& on_a) {
  const ConvexMesh first("a", a), second("b", b);
  const Motion m = motion(first, second, {});
  const auto in_units = [&m](const auto& v) -> std::decay_t<decltype(v)> {
    return {Rational(v.x / m.unit), Rational(v.y / m.unit), Rational(v.z / m.unit)};
  };
  const Vector3<Rational> displacement = rational(*truth.on_a) - rational(*truth.on_b);
  const Point3<Rational> nearest = nearest_to(in_units(exact_in_space(on_a)), IntegerSolid(first, m.a),
                                              IntegerSolid(second, m.b), in_units(displacement));
  const Point3<Rational> point{Rational(nearest.x * m.unit), Rational(nearest.y * m.unit),
                               Rational(nearest.z * m.unit)};
  return {truth.relation, in_space(point), in_space(point + Rational(-1) * displacement), truth.squared_distance,
          truth.distance};
}

template <Exact Number>
Truth<ConvexDistance<Surd>> convex_distance(const Mesh<Number>& a, const Mesh<Number>& b) {
  validation::validate_numbers("a", a), validation::validate_numbers("b", b);
  const ConvexMesh first("a", a), second("b", b);
  const Motion m = motion(first, second, {});
  Meeting found(m);
  if (found.program().feasible()) return meeting(m, found);
  return apart(m, IntegerSolid(first, m.a), IntegerSolid(second, m.b));
}
template Truth<ConvexDistance<Surd>> convex_distance(const Meshd&, const Meshd&);
template Truth<ConvexDistance<Surd>> convex_distance(const Mesh<Rational>&, const Mesh<Rational>&);

}  // namespace touchstone::oracle
