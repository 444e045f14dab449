// SPDX-License-Identifier: Apache-2.0
#include "catalogue/rows/sweeps/swept_sphere_mesh.h"

#include <utility>

#include "proptests/motion_laws.h"
#include "proptests/solids.h"
#include "robust/sweeps/swept_sphere_triangle.h"

namespace touchstone::proptests::swept_sphere_mesh_tests {
namespace {

using Row = rows::swept_sphere_mesh;
using Answer = exact_answer_t<Row>;
using oracle::Surd;
using namespace solids;

const Answer misses{HitRelation::never, {}, {}};
Answer at(const Surd& t, Index face) { return {HitRelation::hit, t, face}; }

constexpr Worked<Row> worked;

Meshd only(const Meshd& mesh, std::vector<Face> faces) { return {mesh.vertices, std::move(faces), {}}; }

/// 12 wide from the origin: face 8 is x = 0, y <= z, face 9 the rest of that side, 11 is x = 12, y <= z.
const Meshd box = mesh_of({{0, 0, 0}, {12, 12, 12}});
const Meshd right_angle{{{0, 0, 0}, {4, 0, 0}, {0, 4, 0}}, {{0, 1, 2}}, {}};

/// Two edges x = 8 along z beside the x axis, at these distances on either side of it, each of a triangle.
Meshd gate(double left, double right) {
  return {{{8, left, -4}, {8, left, 4}, {12, 2, 0}, {8, -right, -4}, {8, -right, 4}, {12, -2, 0}},
          {{0, 1, 2}, {3, 4, 5}},
          {}};
}

}  // namespace

VELOCITIES_LAW("swept_sphere_mesh", 1)

LAW("swept_sphere_mesh: the order of the faces changes the index alone", sphere, velocity, mesh) {
  if (!mesh.polygons.empty()) return true;
  const auto answer = ask(asked);
  auto back = only(mesh, {mesh.faces.rbegin(), mesh.faces.rend()});
  for (Face& f : back.faces) f = {f.b, f.a, f.c};
  const auto found = ask(Row::Question{sphere, velocity, back});
  if (!answer.t) return !found.t && !answer.face && !found.face;
  const auto other = static_cast<Index>(mesh.faces.size() - 1 - *found.face);  // of those at the same t the last
  const auto alone = ask(Row::Question{sphere, velocity, only(mesh, {mesh.faces[other]})});
  return found.t == answer.t && alone.t == answer.t && other >= *answer.face;
}

LAW("swept_sphere_mesh: the named face alone is met at the same time, and no face without it earlier", sphere, velocity,
    mesh) {
  if (!mesh.polygons.empty()) return true;
  const auto answer = ask(asked);
  if (!answer.t) return true;
  const auto alone = ask(Row::Question{sphere, velocity, only(mesh, {mesh.faces[*answer.face]})});
  Meshd others = mesh;
  others.faces.erase(others.faces.begin() + static_cast<std::ptrdiff_t>(*answer.face));
  const auto next = ask(Row::Question{sphere, velocity, others});
  return alone.t == answer.t && alone.face == Index{0} && (!next.t || *next.t >= *answer.t);
}

LAW("swept_sphere_mesh: of two meshes together the first is met, and of both at once the one listed first", sphere,
    velocity, mesh) {
  if (!mesh.polygons.empty()) return true;
  const auto answer = ask(asked);
  const auto half = static_cast<Index>(mesh.faces.size() / 2);
  const auto middle = mesh.faces.begin() + static_cast<std::ptrdiff_t>(half);
  const auto a = ask(Row::Question{sphere, velocity, only(mesh, {mesh.faces.begin(), middle})});
  const auto b = ask(Row::Question{sphere, velocity, only(mesh, {middle, mesh.faces.end()})});
  if (!answer.t) return !a.t && !b.t;
  const bool in_a = *answer.face < half;
  const auto &same = in_a ? a : b, &other = in_a ? b : a;
  return same.t == answer.t && *same.face + (in_a ? 0 : half) == *answer.face && (!other.t || *other.t >= *answer.t);
}

LAW("swept_sphere_mesh: a face of more corners is met when the triangles of its cut are", sphere, velocity, mesh) {
  const auto answer = ask(asked), of_cut = ask(Row::Question{sphere, velocity, only(mesh, mesh.faces)});
  if (!answer.t) return !of_cut.t;
  return of_cut.t == answer.t && *answer.face == named_face_of_each(mesh)[*of_cut.face];
}

ROBUST_LAW("swept_sphere_mesh: each face is met when swept_sphere_triangle meets it, also by a tree asked before",
           sphere, velocity, mesh) {
  const auto answer = ask(asked);
  const robust::Surface surface(mesh);
  robust::swept_sphere_mesh(sphere, -1.0 * velocity, surface);
  if (!equal(robust::swept_sphere_mesh(sphere, velocity, surface), answer)) return false;
  for (std::size_t i = 0; i < mesh.faces.size(); ++i) {
    const auto one = robust::swept_sphere_triangle(sphere, velocity, triangle_of_face(mesh, i));
    if (one.t && (!answer.t || *one.t < *answer.t)) return false;
    if (mesh.polygons.empty() && answer.face == i && one.t != answer.t) return false;
  }
  return true;
}

TEST_CASE("swept_sphere_mesh: first faces worked by hand; margin: the least of those of the faces") {
  // To x = -2. Face 9, from the diagonal y = z on, is as near as the root of 2 in the end: 4 - 2.
  worked({{{-6, 3, 5}, 2}, {8, 0, 0}, box}, at(Rational(1, 2), 8), 2);
  worked({{{-6, 5, 3}, 2}, {8, 0, 0}, box}, at(Rational(1, 2), 9), 2);
  worked({{{-6, 3, 5}, 2}, {3, 0, 0}, box}, misses, 5);                      // short of it: 3^2 - 2^2
  worked({{{-6, 3, 5}, 2}, {-3, 0, 0}, box}, misses, 32);                    // away from it: 6^2 - 2^2
  worked({{{6, 5, 6}, 2}, {8, 0, 0}, box}, at(Rational(1, 2), 11), {7, 2});  // from inside: 4 - 1/2
  worked({{{6, 6, 6}, 2}, {0, 0, 0}, box}, misses, 32);                      // in the middle: 6^2 - 2^2
  worked({{{2, -3, 3}, 4}, {0, 3, 0}, right_angle}, at(Surd(Rational(1), Rational(-1, 3), 7), 0), 7);
}

TEST_CASE("swept_sphere_mesh: edges and corners belong to all of their faces: the least index counts, margin 0") {
  // Beyond the corner at the origin, of faces 0, 1, 4, 5, 8 and 9, by (2, 4, 4) (1 - t), which is 6 (1 - t) long
  worked({{{-2, -4, -4}, 3}, {2, 4, 4}, box}, at(Rational(1, 2), 0), 0);
  worked({{{-2, -4, -4}, 3}, {2, 4, 4}, only(box, {box_faces[10], box_faces[9], box_faces[1]})}, at(Rational(1, 2), 1),
         0);
  worked({{{-6, 4, 4}, 2}, {8, 0, 0}, box}, at(Rational(1, 2), 8), 0);
  worked({{{6, 6, 6}, 2}, {8, 0, 0}, box}, at(Rational(1, 2), 10), 0);
}

TEST_CASE("swept_sphere_mesh: faces of more than three corners; margin: of triangles, 0 where another face is met") {
  // The box by its six squares, of which number 4 is x = 0. The triangles of one are no other faces.
  Meshd squares = box;
  squares.polygons.clear();
  for (Index i = 0; i < 12; i += 2) {
    const auto& [a, b, c] = box_faces[i];
    const Face& other = box_faces[i + 1];
    squares.polygons.push_back({a, b, c, other.c});
    REQUIRE((other.a == a && other.b == c));
  }
  worked({{{-6, 4, 4}, 2}, {8, 0, 0}, squares}, at(Rational(1, 2), 4), 4);  // over the diagonal y = z
  worked({{{-2, -4, -4}, 3}, {2, 4, 4}, squares}, at(Rational(1, 2), 0), 0);
  worked({{{-1, 3, 5}, 2}, {5, 0, 0}, squares}, at(Rational(0), 4), 3);
}

TEST_CASE("swept_sphere_mesh: at the start the least face in contact; margin: of it and those before it") {
  // Face 8 is at the distance 1, face 9 at the root of 3, face 5 at that of 10.
  worked({{{-1, 3, 5}, 2}, {5, 0, 0}, box}, at(Rational(0), 8), 3);
  worked({{{-1, 5, 3}, 2}, {5, 0, 0}, box}, at(Rational(0), 8), 1);  // 2^2 - 3
  worked({{{-2, 5, 3}, 2}, {5, 0, 0}, box}, at(Rational(0), 9), 0);  // touches
  worked({{{0, 0, 0}, 0}, {0, 0, 0}, box}, at(Rational(0), 0), 0);
}

TEST_CASE("swept_sphere_mesh: irrational times are compared exactly") {
  // 8 - 16 t = sqrt(4 - d^2), with the distance d from the way; margin 4 - 1.
  const double nearer = 1 - 0x1p-53;
  const Surd t(Rational(1, 2), Rational(-1, 16), Rational(4 - exact(nearer) * exact(nearer)));
  worked({{{0, 0, 0}, 2}, {16, 0, 0}, gate(1, 1)}, at(Surd(Rational(1, 2), Rational(-1, 16), 3), 0), 0);
  example<Row>({{{0, 0, 0}, 2}, {16, 0, 0}, gate(nearer, 1)}, at(t, 0));
  example<Row>({{{0, 0, 0}, 2}, {16, 0, 0}, gate(1, nearer)}, at(t, 1), "rounding");
}

TEST_CASE("swept_sphere_mesh: grazing faces, faces without area, and no faces at all") {
  worked({{{1, -3, 2}, 2}, {0, 6, 0}, right_angle}, at(Rational(1, 2), 0), 0);  // slides over it
  const Meshd line = only(right_angle, {{0, 1, 1}}), point = only(right_angle, {{1, 1, 1}});
  worked({{{2, -6, 0}, 1}, {0, 10, 0}, line}, at(Rational(1, 2), 0), 1);
  worked({{{4, -6, 0}, 1}, {0, 10, 0}, point}, at(Rational(1, 2), 0), 1);
  for (const Meshd& mesh : {Meshd{}, only(right_angle, {})}) {
    example<Row>({{{1, 1, -1}, 4}, {0, 0, 1}, mesh}, misses);
    CHECK(!catalogue::ask_oracle<Row>(Row::Question{{{1, 1, -1}, 4}, {0, 0, 1}, mesh}).margin);
  }
}

TEST_CASE("swept_sphere_mesh: the ends of the range") {
  // As in the middle of the range: from x = -24 with radius 2 to the corner at x = -12.
  const Sphere3d far{{-24 * (huge / 32), 0, 0}, 2 * (huge / 32)};
  example<Row>({far, {20 * (huge / 32), 0, 0}, mapped(octahedron, huge / 32)}, at(Rational(1, 2), 1), "rounding");
  example<Row>({{{-24 * tiny, 0, 0}, 2 * tiny}, {20 * tiny, 0, 0}, mapped(octahedron, tiny)}, at(Rational(1, 2), 1),
               "rounding");
}

TEST_CASE("swept_sphere_mesh: what is refused, and by which rule first") {
  const Sphere3d ball{{0, 0, 3}, 1}, negative{{0, 0, 3}, -1};
  refused<Row>({negative, {0, infinity, 0}, with_vertex(right_angle, {0, not_a_number, 0})}, "velocity[1]",
               "finite number");
  refused<Row>({negative, {0, 0, 0}, with_vertex(right_angle, {0, not_a_number, 0})}, "mesh.vertices[3][1]",
               "finite number");
  refused<Row>({negative, {0, 0, 0}, only(right_angle, {{0, 1, 6}})}, "sphere.radius", "radius >= 0");
  refused<Row>({ball, {0, 0, 0}, only(right_angle, {{0, 1, 2}, {0, 6, 1}})}, "mesh.faces[1][1]", "index of a vertex");
  const Meshd square{{{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}}, {{0, 1, 2}, {0, 1, 3}}, {{0, 1, 2, 3}}};
  refused<Row>({negative, {0, 0, 1}, square}, "sphere.radius", "radius >= 0");
  refused<Row>({ball, {0, 0, 1}, square}, "mesh.cut", "a cut of the faces into triangles");
}

}  // namespace touchstone::proptests::swept_sphere_mesh_tests
