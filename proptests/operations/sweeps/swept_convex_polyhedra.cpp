// SPDX-License-Identifier: Apache-2.0
#include "catalogue/rows/sweeps/swept_convex_polyhedra.h"

#include "proptests/motion_laws.h"
#include "proptests/solids.h"
#include "proptests/space_laws.h"
#include "robust/sweeps/swept_aabb_aabb.h"
#include "robust/sweeps/swept_convex_polyhedra.h"

namespace touchstone::proptests::swept_convex_polyhedra_tests {
namespace {

using Row = rows::swept_convex_polyhedra;
using Answer = exact_answer_t<Row>;

const Answer misses{HitRelation::never, std::nullopt};
Answer at(const Rational& t) { return {HitRelation::hit, t}; }

using solids::mesh_of, solids::tetrahedron;
const Meshd cube = mesh_of({{0, 0, 0}, {4, 4, 4}});
Meshd cube_at(double x, double y, double z) { return mesh_of({{x, y, z}, {x + 4, y + 4, z + 4}}); }

template <class Change>
Meshd with_each_vertex(Meshd mesh, const Change& change) {
  std::for_each(mesh.vertices.begin(), mesh.vertices.end(), change);
  return mesh;
}

/// Moved by v, where that is exact.
std::optional<Meshd> moved(const Meshd& mesh, const Vector3d& v) {
  bool kept = true;
  const auto sum = [&kept](double x, double by) {
    const double s = x + by;
    kept = kept && finite(s) && exact(s) == Rational(exact(x) + exact(by));
    return s;
  };
  const Meshd image = with_each_vertex(mesh, [&](Point3d& p) { p = {sum(p.x, v.x), sum(p.y, v.y), sum(p.z, v.z)}; });
  return kept ? std::optional(image) : std::nullopt;
}

constexpr Worked<Row> worked;

/// A time as computed, and e(T) of the contract.
struct Bounded {
  Rational value, error;
};

/// As the formula computes them.
std::vector<Vector3d> axes_of(const Meshd& a, const Meshd& b) {
  std::vector<Vector3d> axes, edges_of_a, edges_of_b;
  const auto note = [&axes](const Meshd& mesh, std::vector<Vector3d>& edges) {
    const auto edge = [&mesh](Index from, Index to) { return mesh.vertices[to] - mesh.vertices[from]; };
    for (const Face& f : mesh.faces) {
      axes.push_back(cross(edge(f.a, f.b), edge(f.a, f.c)));
      for (const auto& [i, j] : {std::pair{f.a, f.b}, std::pair{f.b, f.c}, std::pair{f.c, f.a}})
        if (i < j) edges.push_back(edge(i, j));
    }
  };
  note(a, edges_of_a), note(b, edges_of_b);
  for (const Vector3d& of_a : edges_of_a)
    for (const Vector3d& of_b : edges_of_b) axes.push_back(cross(of_a, of_b));
  return axes;
}

std::pair<double, double> interval(const Meshd& mesh, const Vector3d& n) {
  double min = infinity, max = -infinity;
  for (const Point3d& p : mesh.vertices) {
    const double value = dot(n, Vector3d{p.x, p.y, p.z});
    min = std::min(min, value), max = std::max(max, value);
  }
  return {min, max};
}

}  // namespace

LAW("swept_convex_polyhedra: either may be the one that moves, the other way", a, b, v) {
  return equal(ask(asked), ask(Row::Question{b, a, -1.0 * v}));
}

LAW("swept_convex_polyhedra: a motion and the same backwards both meet, or neither does", a, b, v) {
  const auto end = moved(a, v);
  return !end || ask(Row::Question{*end, b, -1.0 * v}).relation == ask(asked).relation;
}

VELOCITIES_LAW("swept_convex_polyhedra", 2)

LAW("swept_convex_polyhedra: order of the faces, their turning, and vertices of no face play no part") {
  auto [a, b, v] = asked;
  const auto answer = ask(asked);
  a.polygons.clear(), b.polygons.clear();
  std::reverse(a.faces.begin(), a.faces.end());
  for (Face& f : b.faces) f = {f.c, f.b, f.a};
  b.vertices.push_back(b.vertices[b.faces[0].a]);
  return equal(ask(Row::Question{a, b, v}), answer);
}

TEST_CASE(
    "swept_convex_polyhedra: at the exact t a point is in both, and a normal has them apart before: the checkers") {
  // What they want of t is proved by certificates of random questions; here of boxes, by another operation.
  law<Row>("boxes around them", [](const auto& ask, const auto& asked) {
    const auto& [a, b, v] = asked;
    const auto box_of = [](const Meshd& mesh) {
      Aabb3d box{mesh.vertices[0], mesh.vertices[0]};
      for (const Point3d& p : mesh.vertices) {
        box.min = {std::min(box.min.x, p.x), std::min(box.min.y, p.y), std::min(box.min.z, p.z)};
        box.max = {std::max(box.max.x, p.x), std::max(box.max.y, p.y), std::max(box.max.z, p.z)};
      }
      return box;
    };
    const auto of_boxes = robust::swept_aabb_aabb(box_of(a), box_of(b), v);
    const auto of_meshes = catalogue::ask_robust<Row>(Row::Question{mesh_of(box_of(a)), mesh_of(box_of(b)), v});
    const auto answer = ask(asked);
    return equal(of_boxes, of_meshes) && (!answer.t || (of_boxes.t && *of_boxes.t <= *answer.t));
  });
}

TEST_CASE("swept_convex_polyhedra: p. 51's sweep of cubes worked by hand, and how far a has to be moved") {
  worked({cube, cube_at(6, 1, 1), {4, 0, 0}}, at(Rational(1, 2)), 2);    // 6 - 4; by 2 it only just gets there
  worked({cube, cube_at(6, 1, 1), {1, 0, 0}}, misses, 1);                // short by 1
  worked({cube, cube_at(6, 1, 1), {-3, 0, 0}}, misses, 2);               // away
  worked({cube, cube_at(6, 1, 1), {0, 0, 0}}, misses, 2);                // at rest
  worked({cube, cube_at(6, 1, 1), {2, 0, 0}}, at(Rational(1)), 0);       // at the end
  worked({cube, cube_at(6, 4, 1), {4, 0, 0}}, at(Rational(1, 2)), 0);    // along a face
  worked({cube, cube_at(4, 4, 4), {1, -1, 0}}, at(Rational(0)), 0);      // corner to corner, then along it
  worked({cube, cube_at(2, 2, 2), {9, 9, 9}}, at(Rational(0)), 4);       // by 4 aside: x after y
  worked({cube, cube_at(6, -6, 0), {4, -4, 0}}, at(Rational(1, 2)), 2);  // x and y from 1/2, to 2 deep
  worked({cube, cube_at(6, -2, 0), {8, 16, 0}}, misses,
         Rational(2, 3));  // x from 2 / 8, y until 2 / 16; by 2 / 3 both at 1 / 6
}

TEST_CASE("swept_convex_polyhedra: corner, edge and face of tetrahedra worked by hand") {
  const Vector3d x{4, 0, 0}, y{0, 4, 0}, z{0, 0, 4};
  const Meshd corner = tetrahedron({0, 0, 0}, x, y, z);
  // The corner (0, 0, 0) of b comes to x + y + z = 4 where it goes along (1, 1, 1): b = (4, 4, 4), 12 - 12 t = 4.
  const Meshd beyond = tetrahedron({4, 4, 4}, x, y, z);
  worked({beyond, corner, {-4, -4, -4}}, at(Rational(2, 3)), Rational(4, 3));  // past the face by 4, |(1, 1, 1)| is 3
  worked({corner, beyond, {4, 4, 4}}, at(Rational(2, 3)), Rational(4, 3));
  worked({beyond, corner, {-2, -2, -2}}, misses, Rational(2, 3));  // 6 - 4
  // Two edges that cross: that of a along x at height 0, that of b along y at height 3; one mounts 4 a step.
  const Meshd below = tetrahedron({-2, 0, 0}, x, {2, 2, -4}, {2, -2, -4}),
              above = tetrahedron({0, -2, 3}, y, {2, 2, 4}, {-2, 2, 4});
  worked({below, above, {0, 0, 4}}, at(Rational(3, 4)), 1);
  worked({below, above, {0, 0, 3}}, at(Rational(1)), 0);
  worked({below, above, {0, 0, 2}}, misses, 1);
}

CONTRACT("swept_convex_polyhedra: the formula in double keeps its contract", a, b, v) {
  Rational d = std::max({size(v.x), size(v.y), size(v.z)});
  for (const Meshd* mesh : {&a, &b})
    for (const Point3d& p : mesh->vertices) d = std::max({d, size(p.x), size(p.y), size(p.z)});
  if (d < power_of_two(-200) || d > power_of_two(200)) return true;
  const Rational u = unit(), cube = d * d * d, e = 176 * u * cube;
  std::vector<Bounded> entries, exits;
  for (const Vector3d& n : axes_of(a, b)) {
    if (n.x == 0 && n.y == 0 && n.z == 0) continue;
    const double speed = dot(n, v);
    if (size(speed) <= e || entries.size() > 100) return true;
    const auto [a_min, a_max] = interval(a, n);
    const auto [b_min, b_max] = interval(b, n);
    const auto time = [&](double displacement) {
      const Rational t(exact(displacement) / exact(speed)), s = size(speed);
      return Bounded{t, Rational((400 * u * cube + abs(t) * e) / (s - e) + 2 * u * abs(t))};
    };
    const Bounded to_near = time(b_min - a_max), to_far = time(b_max - a_min);
    entries.push_back(speed > 0 ? to_near : to_far), exits.push_back(speed > 0 ? to_far : to_near);
  }
  entries.push_back({0, 0}), exits.push_back({1, 0});
  Rational low, high;
  for (std::size_t i = 0; i < entries.size(); ++i) {
    const auto& [t, error] = entries[i];
    for (std::size_t j = 0; j < exits.size(); ++j)
      if (i != j && abs(Rational(t - exits[j].value)) <= error + exits[j].error) return true;
    low = std::max(low, Rational(t - error)), high = std::max(high, Rational(t + error));
  }
  if (answer.relation != truth.answer.relation) return false;
  return !answer.t ||
         (low <= *truth.answer.t && *truth.answer.t <= high && low <= exact(*answer.t) && exact(*answer.t) <= high);
}

TEST_CASE("swept_convex_polyhedra: the formula is right in exact arithmetic") { right_in_exact_arithmetic<Row>(); }

}  // namespace touchstone::proptests::swept_convex_polyhedra_tests
