// SPDX-License-Identifier: Apache-2.0
#include "catalogue/rows/mixed/penetration.h"

#include <algorithm>
#include <cmath>

#include "proptests/closest_laws.h"
#include "proptests/solids.h"
#include "robust/mixed/convex_distance.h"

namespace touchstone::proptests::penetration_tests {
namespace {

using Row = rows::penetration;
using Answer = exact_answer_t<Row>;
using Surd = oracle::Surd;
using Vector = Vector3<Rational>;

constexpr SolidPart vertex = SolidPart::vertex, edge = SolidPart::edge, face = SolidPart::face;

Vector3<Surd> surds(const Vector& v) { return {v.x, v.y, v.z}; }

/// Of a rational depth along a direction of length 1.
Answer deep(Contact contact, const Rational& depth, const Vector& direction, SolidPart a, SolidPart b) {
  return {contact, depth, surds(direction), surds(depth * direction), {a, b}};
}

using solids::box_around, solids::mesh_of, solids::tetrahedron;
Meshd cube_at(double x, double y, double z, double size = 4) {
  return mesh_of({{x, y, z}, {x + size, y + size, z + size}});
}
const Meshd cube = cube_at(0, 0, 0);

/// Two tetrahedra, the upper edge of one along x at height 0, the lower edge of the other along y at that height.
const Meshd below = tetrahedron({-2, 0, 0}, {4, 0, 0}, {2, 2, -4}, {2, -2, -4});
Meshd over(double height) { return tetrahedron({0, -2, height}, {0, 4, 0}, {2, 2, 4}, {-2, 2, 4}); }

const Meshd corner = tetrahedron({0, 0, 0}, {4, 0, 0}, {0, 4, 0}, {0, 0, 4});

constexpr Worked<Row> worked;

Vector3d minus(const Vector3d& v) { return -1.0 * v; }
Vector3<catalogue::TrueNumber> minus(const Vector3<catalogue::TrueNumber>& v) { return {-v.x, -v.y, -v.z}; }

/// How deep the intervals of two boxes overlap, on the axis on which it is least; below 0 if they are apart there.
Rational least_overlap_of(const Aabb3d& a, const Aabb3d& b) {
  const auto overlap = [](double a_min, double a_max, double b_min, double b_max) {
    return std::min(Rational(exact(a_max) - exact(b_min)), Rational(exact(b_max) - exact(a_min)));
  };
  return std::min({overlap(a.min.x, a.max.x, b.min.x, b.max.x), overlap(a.min.y, a.max.y, b.min.y, b.max.y),
                   overlap(a.min.z, a.max.z, b.min.z, b.max.z)});
}

Mesh<Rational> exactly(const Meshd& mesh) {
  Mesh<Rational> found{{}, mesh.faces};
  for (const Point3d& p : mesh.vertices) found.vertices.push_back(exact_point(p));
  return found;
}

/// Both without faces.
bool simplices(const Meshd& a, const Meshd& b) { return is_simplex(a) && is_simplex(b); }

template <class Part>
Part turned(const Part& p, bool exchanged) {
  return exchanged ? Part{p.y, p.x, p.z} : Part{p.y, p.z, -p.x};
}
Meshd turned_mesh(Meshd mesh, bool exchanged) {
  for (Point3d& p : mesh.vertices) p = turned(p, exchanged);
  return mesh;
}

bool few(const Meshd& a, const Meshd& b, std::size_t most) { return a.vertices.size() + b.vertices.size() <= most; }

}  // namespace

LAW("penetration: depth and contact do not depend on the order of both", a, b, radius_a, radius_b) {
  const auto found = ask(asked), swapped = ask(Row::Question{b, a, radius_b, radius_a});
  return found.contact == swapped.contact && found.depth == swapped.depth;
}

LAW("penetration: the other way round the direction is the opposite one, where no other is as deep", a, b, radius_a,
    radius_b) {
  const auto found = ask(asked), swapped = ask(Row::Question{b, a, radius_b, radius_a});
  const auto as_deep =
      oracle::as_deep(b, a, radius_b, radius_a,
                      {-rounded(found.direction.x), -rounded(found.direction.y), -rounded(found.direction.z)});
  if (rounded(as_deep.direction.x) != rounded(swapped.direction.x) ||
      rounded(as_deep.direction.y) != rounded(swapped.direction.y) ||
      rounded(as_deep.direction.z) != rounded(swapped.direction.z))
    return true;  // another is
  return equal(minus(swapped.direction), found.direction) && equal(minus(swapped.translation), found.translation) &&
         swapped.feature.a == found.feature.b && swapped.feature.b == found.feature.a;
}

LAW("penetration: a symmetry of the axes maps the direction, unless it is the last of many in lexicographic order", a,
    b, radius_a, radius_b) {
  const auto answer = ask(asked);
  const bool touching = oracle::penetration(a, b, 0.0, 0.0).answer.contact == Contact::touching;
  for (const bool exchanged : {false, true}) {
    const auto found = ask(Row::Question{turned_mesh(a, exchanged), turned_mesh(b, exchanged), radius_a, radius_b});
    if (found.contact != answer.contact || found.depth != answer.depth) return false;
    if (simplices(a, b) && touching) continue;
    if (!equal(found.direction, turned(answer.direction, exchanged)) ||
        !equal(found.translation, turned(answer.translation, exchanged)) || found.feature.a != answer.feature.a ||
        found.feature.b != answer.feature.b)
      return false;
  }
  return true;
}

LAW("penetration: order of the faces and their turning play no part", a, b, radius_a, radius_b) {
  auto [turned_a, turned_b] = std::pair{a, b};
  turned_a.polygons.clear(), turned_b.polygons.clear();
  std::reverse(turned_a.faces.begin(), turned_a.faces.end());
  for (Face& f : turned_b.faces) f = {f.c, f.b, f.a};
  return equal(ask(Row::Question{turned_a, turned_b, radius_a, radius_b}), ask(asked));
}

LAW("penetration: only the sum of the radii counts", a, b, radius_a, radius_b) {
  const double sum = radius_a + radius_b;
  if (std::isinf(sum) || exact(sum) != exact(radius_a) + exact(radius_b)) return true;
  return equal(ask(Row::Question{a, b, 0, sum}), ask(asked));
}

TEST_CASE("penetration: growing radii add to the depth, along the same direction") {
  law_of<Row>(
      "oracle: as much as they grow", [](const auto& asked) { return catalogue::ask_oracle<Row>(asked).answer; },
      [](const auto& ask, const auto& asked) {
        const auto& [a, b, radius_a, radius_b] = asked;
        const auto without = ask(Row::Question{a, b, 0, 0}), with = ask(asked);
        const Surd radii(Rational(exact(radius_a) + exact(radius_b)));
        return with.depth == without.depth + radii && equal(with.direction, without.direction);
      },
      3);
}

ROBUST_LAW("penetration: without radii it is minus the distance of solids that are apart, and else at least 0", a, b) {
  if (is_simplex(a) || is_simplex(b)) return true;
  const auto found = ask(Row::Question{a, b, 0, 0});
  const ConvexDistance<double> distance = robust::convex_distance(a, b);
  if (distance.relation == ConvexRelation::meeting) return found.contact != Contact::disjoint && found.depth >= 0;
  return found.contact == Contact::disjoint && found.depth == -distance.distance;
}

ROBUST_LAW("penetration: boxes around them overlap as their intervals do, and no less than they", a, b) {
  if (is_simplex(a) || is_simplex(b)) return true;
  const Aabb3d around_a = box_around(a), around_b = box_around(b);
  const Rational depth = least_overlap_of(around_a, around_b);
  if (sgn(depth) < 0) return ask(Row::Question{a, b, 0, 0}).contact == Contact::disjoint;
  const auto of_boxes = ask(Row::Question{mesh_of(around_a), mesh_of(around_b), 0, 0});
  return of_boxes.depth == catalogue::nearest(depth) && ask(Row::Question{a, b, 0, 0}).depth <= of_boxes.depth;
}

TEST_CASE("penetration: all lengths times a power of two") {
  robust_law<Row>("depth and translation too, and the direction stays", [](const auto& ask, const auto& asked) {
    const auto answer = ask(asked);
    for (const int k : {1, -29, 300, -300}) {
      const auto times = [](auto question, int places) {
        catalogue::for_each_number(question, [places](double& number) { number = std::ldexp(number, places); });
        return question;
      };
      const auto larger = times(asked, k);
      if (numbers_of(times(larger, -k)) != numbers_of(asked)) continue;
      const auto found = ask(larger);
      if (!equal(found.direction, answer.direction) || !scaled_number(answer.depth, found.depth, k) ||
          !scaled_number(answer.translation.x, found.translation.x, k) ||
          !scaled_number(answer.translation.y, found.translation.y, k) ||
          !scaled_number(answer.translation.z, found.translation.z, k))
        return false;
    }
    return true;
  });
}

/// No translation is off by more than half an ulp on each axis, so what is left is no more than their sum.
ROBUST_LAW("penetration: moved by the translation they touch, but for its rounding", a, b, radius_a, radius_b) {
  const Vector3d by = ask(asked).translation;
  if (!few(a, b, 20) || !std::isfinite(by.x) || !std::isfinite(by.y) || !std::isfinite(by.z)) return true;
  Mesh<Rational> moved = exactly(a);
  for (auto& p : moved.vertices) p = p + Vector{exact(by.x), exact(by.y), exact(by.z)};
  const Surd left = oracle::penetration(moved, exactly(b), exact(radius_a), exact(radius_b)).answer.depth;
  const Rational most = unit() * (size(by.x) + size(by.y) + size(by.z)) + 3 * power_of_two(-1075);
  return sgn(left + Surd(most)) >= 0 && sgn(left - Surd(most)) <= 0;
}

ROBUST_LAW("penetration: the formula finds the right depth of the cores in exact arithmetic", a, b) {
  if (!few(a, b, 20)) return true;
  const auto found = reference::overlap_of_cores(exactly(a), exactly(b));
  const auto truth = ask(Row::Question{a, b, 0, 0});
  if (sgn(found.height) < 0) return truth.contact == Contact::disjoint;
  const Rational square(found.height * found.height / dot(found.direction, found.direction));
  return catalogue::nearest(Surd(0, 1, square)) == truth.depth;
}

TEST_CASE("penetration: cubes worked by hand, side by side, and as deep in several directions") {
  worked({cube, cube_at(3, 0, 0), 0, 0}, deep(Contact::overlapping, 1, {-1, 0, 0}, face, face), 1);
  worked({cube, cube_at(3, 0, 0), 1, 2}, deep(Contact::overlapping, 4, {-1, 0, 0}, face, face), 10);
  worked({cube_at(3, 0, 0), cube, 0, 0}, deep(Contact::overlapping, 1, {1, 0, 0}, face, face), 1);
  // Vertices 0 to 3 of a are those of its lower face: upwards.
  worked({cube, cube, 0, 0}, deep(Contact::overlapping, 4, {0, 0, 1}, face, face), 16);
  // A small cube in the middle: 3 along each axis, again upwards.
  worked({cube, cube_at(1, 1, 1, 2), 0, 0}, deep(Contact::overlapping, 3, {0, 0, 1}, face, face), 9);
  // Two opposite corners touch: of three faces of a at that corner the one with vertices 1, 3, 5, 7.
  worked({cube, cube_at(4, 4, 4), 0, 0}, deep(Contact::touching, 0, {-1, 0, 0}, face, face), 0, "algorithm");
  worked({cube, cube_at(4, 1, 1), 0, 0}, deep(Contact::touching, 0, {-1, 0, 0}, face, face), 0);
}

TEST_CASE("penetration: cubes whose corners are 7 apart, and radii that reach, do not reach, or reach too far") {
  const Vector direction{Rational(-2, 7), Rational(-3, 7), Rational(-6, 7)};
  worked({cube, cube_at(6, 7, 10), 0, 0}, deep(Contact::disjoint, -7, direction, vertex, vertex), 49);
  worked({cube, cube_at(6, 7, 10), 1, 2}, deep(Contact::disjoint, -4, direction, vertex, vertex), 40);
  worked({cube, cube_at(6, 7, 10), 3, 4}, deep(Contact::touching, 0, direction, vertex, vertex), 0, "agree");
  worked({cube, cube_at(6, 7, 10), 3, 5}, deep(Contact::overlapping, 1, direction, vertex, vertex), 15);
}

TEST_CASE("penetration: across two edges, and a vertex in a face, worked by hand") {
  worked({below, over(-1), 0, 0}, deep(Contact::overlapping, 1, {0, 0, -1}, edge, edge), 1);
  worked({below, over(0), 0, 0}, deep(Contact::touching, 0, {0, 0, -1}, edge, edge), 0);
  worked({below, over(3), 1, 0}, deep(Contact::disjoint, -2, {0, 0, -1}, edge, edge), 8);
  const Meshd above = tetrahedron({1, 1, -1}, {1, 0, -9}, {0, 1, -9}, {-1, -1, -9});
  worked({above, cube_at(-2, -2, -3, 8), 0, 0}, deep(Contact::overlapping, 2, {0, 0, -1}, vertex, face), 4);
}

/// Without faces.
Meshd core(std::vector<Point3d> vertices) { return {std::move(vertices), {}, {}}; }

const Meshd triangle = core({{0, 0, 0}, {12, 0, 0}, {0, 12, 0}}), along_x = core({{-1, 0, 0}, {1, 0, 0}});

TEST_CASE("penetration: balls, apart and around one center") {
  const Vector direction{Rational(-3, 5), Rational(-4, 5), 0};
  worked({core({{0, 0, 0}}), core({{3, 4, 0}}), 2, 1}, deep(Contact::disjoint, -2, direction, vertex, vertex), 16);
  worked({core({{0, 0, 0}}), core({{3, 4, 0}}), 2, 3}, deep(Contact::touching, 0, direction, vertex, vertex), 0);
  worked({core({{0, 0, 0}}), core({{3, 4, 0}}), 2, 4}, deep(Contact::overlapping, 1, direction, vertex, vertex), 11);
  worked({core({{5, 5, 5}}), core({{5, 5, 5}}), 2, 1}, deep(Contact::overlapping, 3, {1, 0, 0}, vertex, vertex), 9);
  worked({core({{5, 5, 5}}), core({{5, 5, 5}}), 0, 0}, deep(Contact::touching, 0, {1, 0, 0}, vertex, vertex), 0);
}

TEST_CASE("penetration: capsules that cross are pushed apart along the later one of two normals") {
  const auto crossing = [](const Point3d& end) { return core({{-end.x, -end.y, -end.z}, end}); };
  const auto later = [](const Vector& direction) { return deep(Contact::overlapping, 2, direction, edge, edge); };
  worked({along_x, crossing({0, 1, 0}), 1, 1}, later({0, 0, 1}), 4);
  // The formula finds both, and returns the first one.
  worked({crossing({0, 1, 0}), along_x, 1, 1}, later({0, 0, 1}), 4, "algorithm");
  worked({along_x, crossing({0, 4, 3}), 1, 1}, later({0, Rational(3, 5), Rational(-4, 5)}), 4, "algorithm");
  worked({crossing({0, 0, 1}), crossing({4, 3, 0}), 1, 1}, later({Rational(3, 5), Rational(-4, 5), 0}), 4, "algorithm");
  worked({crossing({0, 0, 1}), crossing({4, -3, 0}), 1, 1}, later({Rational(3, 5), Rational(4, 5), 0}), 4);
  // An end of one in the middle of the other.
  worked({along_x, core({{0, 0, 0}, {0, 4, 0}}), 1, 1}, later({0, 0, 1}), 4);
}

TEST_CASE("penetration: capsules on one line and side by side") {
  const auto across = [](const Vector& direction) { return deep(Contact::overlapping, 3, direction, edge, edge); };
  worked({core({{0, 0, 0}, {2, 0, 0}}), core({{1, 0, 0}, {5, 0, 0}}), 1, 2}, across({0, 1, 0}), 9);
  worked({core({{0, 0, 0}, {0, 2, 0}}), core({{0, 2, 0}, {0, 5, 0}}), 1, 2}, across({1, 0, 0}), 9);
  worked({core({{0, 0, 0}, {6, 8, 0}}), core({{3, 4, 0}, {9, 12, 0}}), 1, 2},
         across({Rational(4, 5), Rational(-3, 5), 0}), 9);
  worked({core({{0, 0, 0}, {2, 0, 0}}), core({{1, 0, 0}}), 1, 2},
         deep(Contact::overlapping, 3, {0, 1, 0}, edge, vertex), 9);
  worked({core({{0, 0, 0}, {2, 0, 0}}), core({{5, 0, 0}, {8, 0, 0}}), 1, 1},
         deep(Contact::disjoint, -1, {-1, 0, 0}, vertex, vertex), 5);
  worked({core({{0, 0, 0}, {4, 0, 0}}), core({{1, 2, 0}, {5, 2, 0}}), 1, 2},
         deep(Contact::overlapping, 1, {0, -1, 0}, edge, edge), 5);
}

TEST_CASE("penetration: vertices that coincide or lie on a line are a point or a segment") {
  const Meshd twice = core({{1, 1, 1}, {1, 1, 1}}), thrice = core({{1, 1, 1}, {1, 1, 1}, {1, 1, 1}});
  worked({twice, thrice, 1, 0}, deep(Contact::overlapping, 1, {1, 0, 0}, vertex, vertex), 1);
  const Meshd on_line = core({{1, 0, 0}, {-1, 0, 0}, {0, 0, 0}});
  worked({on_line, core({{0, -1, 0}, {0, 1, 0}}), 1, 0}, deep(Contact::overlapping, 1, {0, 0, 1}, edge, edge), 1,
         "algorithm");
  worked({on_line, cube_at(-2, -1, -2), 0, 0}, deep(Contact::overlapping, 1, {0, -1, 0}, edge, face), 1);
}

TEST_CASE("penetration: a ball, a capsule and triangles with a triangle") {
  worked({core({{3, 3, 0}}), triangle, 1, 2}, deep(Contact::overlapping, 3, {0, 0, 1}, vertex, face), 9);
  worked({core({{3, 3, 1}}), triangle, 1, 2}, deep(Contact::overlapping, 2, {0, 0, 1}, vertex, face), 8);
  worked({core({{-3, 4, 0}}), triangle, 1, 0}, deep(Contact::disjoint, -2, {-1, 0, 0}, vertex, edge), 8);
  // From 1 below to 2 above it, and no nearer to its edges than 3.
  worked({core({{3, 3, -1}, {3, 3, 2}}), triangle, 0, 0}, deep(Contact::overlapping, 1, {0, 0, 1}, vertex, face), 1);
  worked({core({{3, 2, -1}, {3, 4, -1}, {3, 3, 5}}), triangle, 0, 0},
         deep(Contact::overlapping, 1, {0, 0, 1}, edge, face), 1);
  worked({triangle, core({{3, 2, -1}, {3, 4, -1}, {3, 3, 5}}), 0, 0},
         deep(Contact::overlapping, 1, {0, 0, -1}, face, edge), 1);
  worked({triangle, core({{2, 2, 0}, {14, 2, 0}, {2, 14, 0}}), 1, 0},
         deep(Contact::overlapping, 1, {0, 0, 1}, face, face), 1, "algorithm");
  worked({triangle, core({{15, 0, 0}, {15, 12, 0}, {27, 0, 0}}), 1, 0},
         deep(Contact::disjoint, -2, {-1, 0, 0}, vertex, edge), 8);
}

TEST_CASE("penetration: balls and capsules with a cube") {
  worked({core({{1, 2, 2}}), cube, 1, 0}, deep(Contact::overlapping, 2, {-1, 0, 0}, vertex, face), 2);
  worked({cube, core({{1, 2, 2}}), 0, 1}, deep(Contact::overlapping, 2, {1, 0, 0}, face, vertex), 2);
  worked({core({{4, 2, 2}}), cube, 0, 0}, deep(Contact::touching, 0, {1, 0, 0}, vertex, face), 0);
  worked({core({{6, 2, 2}}), cube, 1, 0}, deep(Contact::disjoint, -1, {1, 0, 0}, vertex, face), 3);
  // 2 upwards, downwards and to both sides: of these faces of the cube the lower has the vertices 0 to 3.
  worked({core({{1, 2, 2}, {3, 2, 2}}), cube, 0, 0}, deep(Contact::overlapping, 2, {0, 0, -1}, edge, face), 4);
  worked({core({{-1, 2, 3}, {5, 2, 3}}), cube, 0, 0}, deep(Contact::overlapping, 1, {0, 0, 1}, edge, face), 1);
}

TEST_CASE("penetration: rounding, huge and subnormal") {
  // The corner (1, 1, 1) in x + y + z <= 4: 1 / sqrt(3) deep, a third on each axis.
  const Meshd single = tetrahedron({1, 1, 1}, {4, 0, 0}, {0, 4, 0}, {0, 0, 4});
  const double root = 0x1.279a74590331cp-1;
  CHECK(numbers_of(catalogue::ask_robust<Row>(Row::Question{corner, single, 0, 0})) ==
        std::vector<double>{root, -root, -root, -root, -1.0 / 3, -1.0 / 3, -1.0 / 3});
  const auto times = [](double factor, const Meshd& mesh) { return solids::mapped(mesh, factor); };
  worked({times(tiny, cube), times(tiny, cube_at(3, 0, 0)), 0, tiny},
         deep(Contact::overlapping, 2 * exact(tiny), {-1, 0, 0}, face, face), 2 * exact(tiny) * exact(tiny),
         "rounding");
  const double big = 0x1p1000;
  CHECK(numbers_of(
            catalogue::ask_robust<Row>(Row::Question{times(big, cube), times(big, cube_at(3, 0, 0)), huge, huge})) ==
        std::vector<double>{infinity, -1, 0, 0, -infinity, 0, 0});
}

TEST_CASE("penetration: what is refused, the meshes before the radii") {
  Meshd open = cube;
  open.faces.pop_back();
  refused<Row>({cube, cube, -1, -1}, "radius_a", "radius >= 0");
  refused<Row>({cube, cube, 0, -tiny}, "radius_b", "radius >= 0");
  refused<Row>({cube, cube, -1, infinity}, "radius_b", "finite number");
  refused<Row>({core({}), cube, -1, 0}, "a", "at least 4 faces");
  refused<Row>({cube, core({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}}), 0, 0}, "b", "at least 4 faces");
  refused<Row>({Meshd{triangle.vertices, {{0, 1, 2}, {0, 2, 1}}, {}}, cube, 0, 0}, "a", "at least 4 faces");
  refused<Row>({core({{0, 0, 0}}), core({{0, 0, 0}}), 0, -1}, "radius_b", "radius >= 0");
  refused<Row>({core({{0, 0, infinity}}), open, 0, 0}, "a.vertices[0][2]", "finite number");
  refused<Row>({cube, open, -1, 0}, "b.faces[2]", "closed: edge 5 -> 7 must occur once, and 7 -> 5 once");
}

CONTRACT("penetration: the depth of small integer solids that meet is off by 8 u", a, b, radius_a, radius_b) {
  const bool apart = truth.answer.depth < Surd(Rational(exact(radius_a) + exact(radius_b)));
  if (apart || simplices(a, b) || !few(a, b, 1024)) return true;
  Point3d low = a.vertices[0], high = low;
  for (const Meshd* mesh : {&a, &b}) {
    for (const Point3d& p : mesh->vertices) {
      for (const double x : {p.x, p.y, p.z})
        if (!(std::fabs(x) < 0x1p20) || x != std::trunc(x)) return true;
      low = {std::min(low.x, p.x), std::min(low.y, p.y), std::min(low.z, p.z)};
      high = {std::max(high.x, p.x), std::max(high.y, p.y), std::max(high.z, p.z)};
    }
  }
  if (std::max({high.x - low.x, high.y - low.y, high.z - low.z}) > 0x1p7) return true;
  for (const double radius : {radius_a, radius_b})
    if (!(radius == 0 || (radius >= 0x1p-900 && radius <= 0x1p900))) return true;
  const Surd depth = truth.answer.depth, most = Surd(Rational(8 * unit())) * depth,
             off = depth - Surd(exact(answer.depth));
  return answer.contact == truth.answer.contact && sgn(most - off) >= 0 && sgn(most + off) >= 0;
}

}  // namespace touchstone::proptests::penetration_tests
