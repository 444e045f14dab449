// SPDX-License-Identifier: Apache-2.0
#include "catalogue/rows/mixed/convex_distance.h"

#include <algorithm>

#include "proptests/closest_laws.h"
#include "proptests/solids.h"
#include "robust/sweeps/swept_convex_polyhedra.h"

namespace touchstone::proptests::convex_distance_tests {
namespace {

using Row = rows::convex_distance;
using Answer = exact_answer_t<Row>;
using Point = Point3<Rational>;

const Answer meets{ConvexRelation::meeting, {}, {}, {}, {}};
Answer apart(const Point& on_a, const Point& on_b, const Rational& distance) {
  const auto with_roots = [](const Point& p) { return Point3<oracle::Surd>{p.x, p.y, p.z}; };
  return {ConvexRelation::apart, with_roots(on_a), with_roots(on_b), Rational(distance * distance), distance};
}

using solids::box_around, solids::mesh_of, solids::tetrahedron;
const Meshd cube = mesh_of({{0, 0, 0}, {4, 4, 4}});
Meshd cube_at(double x, double y, double z) { return mesh_of({{x, y, z}, {x + 4, y + 4, z + 4}}); }

const Vector3d x{4, 0, 0}, y{0, 4, 0}, z{0, 0, 4};
const Meshd corner = tetrahedron({0, 0, 0}, x, y, z);

Meshd times(double factor, Meshd mesh) {
  for (Point3d& p : mesh.vertices) p = {factor * p.x, factor * p.y, factor * p.z};
  return mesh;
}

/// The squared distance of two boxes, axis by axis.
Rational square_between(const Aabb3d& a, const Aabb3d& b) {
  const auto gap = [](double a_min, double a_max, double b_min, double b_max) {
    return std::max({Rational(0), Rational(exact(b_min) - exact(a_max)), Rational(exact(a_min) - exact(b_max))});
  };
  const Rational along_x = gap(a.min.x, a.max.x, b.min.x, b.max.x), along_y = gap(a.min.y, a.max.y, b.min.y, b.max.y),
                 along_z = gap(a.min.z, a.max.z, b.min.z, b.max.z);
  return Rational(along_x * along_x + along_y * along_y + along_z * along_z);
}

Mesh<Rational> exactly(const Meshd& mesh) {
  Mesh<Rational> found{{}, mesh.faces};
  for (const Point3d& p : mesh.vertices) found.vertices.push_back(exact_point(p));
  return found;
}

constexpr Worked<Row> worked;

constexpr RoundsTo<Row> rounds_to;

}  // namespace

LAW("convex_distance: the distance does not depend on the order of both", a, b) {
  const auto found = ask(asked), swapped = ask(Row::Question{b, a});
  return found.relation == swapped.relation && found.squared_distance == swapped.squared_distance &&
         found.distance == swapped.distance;
}

LAW("convex_distance: order of the faces, their turning, and more vertices of no face play no part") {
  auto [a, b] = asked;
  const auto answer = ask(asked);
  a.polygons.clear(), b.polygons.clear();
  std::reverse(a.faces.begin(), a.faces.end());
  for (Face& f : b.faces) f = {f.c, f.b, f.a};
  for (Meshd* mesh : {&a, &b}) mesh->vertices.push_back(mesh->vertices[mesh->faces[0].a]);
  return equal(ask(Row::Question{a, b}), answer);
}

LAW("convex_distance: it is 0 exactly where the polyhedra meet, and there are points where they do not") {
  const auto answer = ask(asked);
  const bool apart = answer.relation == ConvexRelation::apart;
  if (!apart && (!is_zero(answer.squared_distance) || !is_zero(answer.distance))) return false;
  return (!apart || !is_zero(answer.distance)) && answer.on_a.has_value() == apart && answer.on_b.has_value() == apart;
}

ROBUST_LAW("convex_distance: they meet where a sweep of velocity 0 hits", a, b) {
  const bool hits = robust::swept_convex_polyhedra(a, b, {0, 0, 0}).relation == HitRelation::hit;
  return hits == (ask(asked).relation == ConvexRelation::meeting);
}

ROBUST_LAW("convex_distance: boxes around them are as far apart as their intervals, and not farther than they", a, b) {
  const Aabb3d around_a = box_around(a), around_b = box_around(b);
  const auto of_boxes = ask(Row::Question{mesh_of(around_a), mesh_of(around_b)});
  const double square = catalogue::nearest(square_between(around_a, around_b));
  return of_boxes.squared_distance == square && ask(asked).squared_distance >= square;
}

LENGTHS_LAW("convex_distance")

ROBUST_LAW("convex_distance: the formula has the right distance in exact arithmetic", a, b) {
  if (a.vertices.size() + b.vertices.size() > 40) return true;
  const auto answer = ask(asked);
  const auto found = reference::nearest_simplex(exactly(a), exactly(b));
  const Vector3<Rational> displacement = found.displacement();
  const Rational square = found.pairs.size() == 4 ? Rational(0) : dot(displacement, displacement);
  return (sgn(square) == 0) == (answer.relation == ConvexRelation::meeting) &&
         catalogue::nearest(square) == answer.squared_distance;
}

TEST_CASE("convex_distance: cubes worked by hand, corner to corner, and apart by a whole number") {
  worked({cube, cube_at(6, 7, 10)}, apart({4, 4, 4}, {6, 7, 10}, 7), 6);
  worked({cube, cube_at(-6, -7, -10)}, apart({0, 0, 0}, {-2, -3, -6}, 7), 6);
  worked({cube, cube_at(4, 4, 4)}, meets, 0);
  worked({cube, cube_at(4, 1, 1)}, meets, 0);
  worked({cube, cube_at(3, 3, 3)}, meets, 1);
  worked({cube, mesh_of({{1, 1, 1}, {2, 2, 2}})}, meets, 2);
}

TEST_CASE("convex_distance: vertex to face, edge to edge, vertex to edge, worked by hand") {
  const Meshd above = tetrahedron({1, 1, -3}, {1, 0, -9}, {0, 1, -9}, {-1, -1, -9});
  worked({corner, above}, apart({1, 1, 0}, {1, 1, -3}, 3), 3);
  worked({above, corner}, apart({1, 1, -3}, {1, 1, 0}, 3), 3);
  // Two edges that cross: that of one along x at height 0, that of the other along y at height 3.
  const Meshd below = tetrahedron({-2, 0, 0}, x, {2, 2, -4}, {2, -2, -4}),
              over = tetrahedron({0, -2, 3}, y, {2, 2, 4}, {-2, 2, 4});
  worked({below, over}, apart({0, 0, 0}, {0, 0, 3}, 3), 3);
  const Meshd beside = tetrahedron({0, 3, 4}, {1, 9, 9}, {-1, 9, 9}, {0, 9, 12});
  worked({below, beside}, apart({0, 0, 0}, {0, 3, 4}, 5), 4);
}

TEST_CASE("convex_distance: of many nearest pairs the one whose point on a is nearest to the first vertex of a") {
  const auto first = [](const Meshd& a, const Meshd& b, const Point& on_a, const Point& on_b,
                        const Rational& distance) {
    const Answer answer = apart(on_a, on_b, distance);
    CHECK(equal(catalogue::ask_oracle<Row>(Row::Question{a, b}).answer, answer));
    std::vector<double> numbers;
    for (const Rational& number :
         {on_a.x, on_a.y, on_a.z, on_b.x, on_b.y, on_b.z, Rational(distance * distance), distance})
      numbers.push_back(catalogue::nearest(number));
    rounds_to({a, b}, numbers);
  };
  first(cube, cube_at(6, 1, 1), {4, 1, 1}, {6, 1, 1}, 2);    // a face over a face, of which (0, 0, 0) is a vertex
  first(cube, cube_at(6, -1, -1), {4, 0, 0}, {6, 0, 0}, 2);  // over its vertex too
  first(cube_at(6, 1, 1), cube, {6, 1, 1}, {4, 1, 1}, 2);    // the other way round
  first(cube, cube_at(7, 8, 1), {4, 4, 1}, {7, 8, 1}, 5);    // an edge over an edge
  const Meshd roof = tetrahedron({1, 3, 7}, {2, 0, 0}, {1, 2, 9}, {1, -2, 9});
  first(cube, roof, {1, 3, 4}, {1, 3, 7}, 3);  // an edge over a face
  Meshd from_inside = cube;
  from_inside.vertices.insert(from_inside.vertices.begin(), Point3d{3, 2, 3});
  for (Face& f : from_inside.faces) f = {f.a + 1, f.b + 1, f.c + 1};
  first(from_inside, cube_at(6, -1, -1), {4, 2, 3}, {6, 2, 3}, 2);  // the foot of an inner vertex
  first(from_inside, roof, {3, 3, 4}, {3, 3, 7}, 3);                // and on an edge, which ends there
}

TEST_CASE("convex_distance: rounding, huge and subnormal") {
  const double big = 0x1p1000;
  worked({times(tiny, cube), times(tiny, cube_at(6, 7, 10))},
         apart({4 * exact(tiny), 4 * exact(tiny), 4 * exact(tiny)},
               {6 * exact(tiny), 7 * exact(tiny), 10 * exact(tiny)}, 7 * exact(tiny)),
         6 * exact(tiny), "rounding");
  rounds_to({times(big, cube), times(big, cube_at(6, 7, 10))},
            {4 * big, 4 * big, 4 * big, 6 * big, 7 * big, 10 * big, infinity, 7 * big});
  // The corner (1, 1, 1) over x + y + z = 2: the foot is 2 / 3 in each coordinate, 1 / sqrt(3) away.
  const Meshd half = times(0.5, corner), single = tetrahedron({1, 1, 1}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1});
  rounds_to({cube, cube_at(6, 7, 1)}, {4, 4, 1, 6, 7, 1, 13, 0x1.cd82b446159f3p+1});
  rounds_to({half, single}, {2.0 / 3, 2.0 / 3, 2.0 / 3, 1, 1, 1, 1.0 / 3, 0x1.279a74590331cp-1});
}

CONTRACT("convex_distance: the formula in double is never too short by more than its contract", a, b) {
  if (answer.relation == ConvexRelation::meeting || !answer.on_a) return true;
  bool defined = finite(answer.squared_distance, answer.distance);
  catalogue::for_each_number(answer, [&](const double& number) { defined = defined && finite(number); });
  if (!defined || !below_2_to_200(a) || !below_2_to_200(b)) return true;
  const Rational e(off_by(a) + off_by(b));
  // D* <= (D + 2^-536) / (1 - 4u) + e, by squares.
  const Rational most((exact(answer.distance) + power_of_two(-536)) / (1 - 4 * unit()) + e);
  return truth.answer.squared_distance.rational_part() <= most * most;
}

}  // namespace touchstone::proptests::convex_distance_tests
