// SPDX-License-Identifier: Apache-2.0
#include "catalogue/rows/polyhedra/point_in_polyhedron.h"

#include <algorithm>

#include "catalogue/families/meshes/reported_meshes.h"
#include "proptests/solids.h"
#include "proptests/space_laws.h"
#include "proptests/triangle_laws.h"
#include "robust/polyhedra/point_in_convex_polyhedron.h"

namespace touchstone::proptests::point_in_polyhedron_tests {
namespace {

using Row = rows::point_in_polyhedron;
using namespace solids;
namespace reported = catalogue::reported;

constexpr Location inside = Location::inside, boundary = Location::boundary, outside = Location::outside;

constexpr Worked<Row> worked;

/// Whether every S and E of the formula is certain by the bounds of the contract.
bool certain(const Meshd& mesh, const Point3d& p) {
  const Rational u = unit();
  const auto certain_side = [&](const Point3d& a, const Point3d& b) {
    if (!finite((b.y - a.y) * (p.z - a.z) - (b.z - a.z) * (p.y - a.y))) return false;
    const Vector3<Rational> v = exact_point(b) - exact_point(a), d = exact_point(p) - exact_point(a);
    const Rational products = abs(v.y * d.z) + abs(v.z * d.y);
    return abs(v.y * d.z - v.z * d.y) > 4 * (1 + 2 * u) * u * products + power_of_two(-1073);
  };
  for (const Face& face : mesh.faces) {
    const Point3d &a = mesh.vertices[face.a], &b = mesh.vertices[face.b], &c = mesh.vertices[face.c];
    if (!certain_side(a, b) || !certain_side(b, c) || !certain_side(c, a)) return false;
    if (!certainly_beside({a, b, c}, p)) return false;
  }
  return true;
}

Mesh<Rational> exactly(const Meshd& mesh) {
  Mesh<Rational> result{{}, mesh.faces};
  for (const Point3d& p : mesh.vertices) result.vertices.push_back(exact_point(p));
  return result;
}

/// Whether some S is 0: whether the ray's line passes through the line of an edge.
bool passes_through_an_edge(const Mesh<Rational>& mesh, const Point3<Rational>& p) {
  const auto passes = [&p](const Point3<Rational>& a, const Point3<Rational>& b) {
    return (b.y - a.y) * (p.z - a.z) == (b.z - a.z) * (p.y - a.y);
  };
  return std::any_of(mesh.faces.begin(), mesh.faces.end(), [&](const Face& f) {
    const auto &a = mesh.vertices[f.a], &b = mesh.vertices[f.b], &c = mesh.vertices[f.c];
    return passes(a, b) || passes(b, c) || passes(c, a);
  });
}

}  // namespace

LAW("point_in_polyhedron: it does not matter in which order faces and vertices are listed", mesh, p) {
  return in_any_order(mesh, [&, location = ask(asked)](const Meshd& other) {
    return ask(Row::Question{other, p}) == location;
  });
}

LAW("point_in_polyhedron: which way faces turn is nothing, nor is a face that comes twice more", mesh, p) {
  const Location location = ask(asked);
  const Meshd all = with_each_face(mesh, [](Face& f) { std::swap(f.b, f.c); });
  Meshd one{mesh.vertices, mesh.faces, {}};
  std::swap(one.faces.front().a, one.faces.front().b);
  const Meshd again = with_faces(mesh, {mesh.faces.back(), mesh.faces.back()});
  return ask(Row::Question{all, p}) == location && ask(Row::Question{one, p}) == location &&
         ask(Row::Question{again, p}) == location;
}

LAW("point_in_polyhedron: of a mesh that is listed twice nothing is inside, and its faces are the boundary", mesh, p) {
  const Location location = ask(asked);
  return ask(Row::Question{together(mesh, mesh), p}) == (location == inside ? outside : location);
}

LAW("point_in_polyhedron: within a shell around everything, outside and inside change places", mesh, p) {
  if (!on_small_lattice(asked)) return true;
  const Location location = ask(asked);
  const Meshd shell = mapped(cube, 0x1p40, -0x1p42);  // [-4, 8] times 2^40
  const Location within = ask(Row::Question{together(mesh, shell), p});
  return within == (location == inside ? outside : location == outside ? inside : boundary);
}

LAW("point_in_polyhedron: the corners of faces are on the boundary", mesh) {
  for (std::size_t i = 0; i < mesh.faces.size(); i += 1 + mesh.faces.size() / 8) {
    const Face& f = mesh.faces[i];
    for (const Index corner : {f.a, f.b, f.c}) {
      if (ask(Row::Question{mesh, mesh.vertices[corner]}) != boundary) return false;
    }
  }
  return true;
}

TEST_CASE("point_in_polyhedron: of convex meshes it says what point_in_convex_polyhedron says") {
  const auto complaint = [](const Question& question) -> std::string {
    const auto asked = catalogue::unpacked<Row::Question>(question);
    try {
      const auto& [mesh, p] = asked;
      const Location location = robust::point_in_convex_polyhedron(mesh, p);
      if (catalogue::ask_robust<Row>(asked) != location) return "robust finds it elsewhere";
      return catalogue::ask_oracle<Row>(asked).answer == location ? "" : "the oracle finds it elsewhere";
    } catch (const InvalidInput& refused) {
      return refused.rule().ends_with("an even number of faces") ? refused.what() : "";
    }
  };
  never(*catalogue::find_operation("point_in_convex_polyhedron"), "convex meshes", complaint, 4);
}

TEST_CASE("point_in_polyhedron: notches, holes and hollows worked by hand") {
  worked({angle, {6, 5, 7}}, inside, 25);
  worked({angle, {18, 19, 7}}, outside, 36);  // in the notch; 6 from x = 12, 7 from y = 12
  worked({angle, {14, 19, 7}}, outside, 4);
  worked({angle, {12, 5, 7}}, inside, 25);  // where two cubes touch
  worked({ring, {18, 17, 7}}, outside, 25);
  worked({ring, {18, 17, -1}}, outside, 26);  // below the hole
  worked({ring, {6, 17, 7}}, inside, 25);
  worked({hollow, {18, 17, 19}}, outside, 25);
  worked({hollow, {6, 17, 19}}, inside, 36);
  worked({hollow, {-1, 17, 19}}, outside, 1);
  worked({edge_to_edge, {6, 5, 7}}, inside, 25);
  worked({edge_to_edge, {18, 5, 7}}, outside, 36);
  worked({corner_to_corner, {18, 17, 19}}, inside, 25);
  worked({corner_to_corner, {18, 17, 7}}, outside, 25);
}

TEST_CASE("point_in_polyhedron: the ray counts edges and vertices as often as faces have them") {
  // Through the corner of four faces, each at squared distance 12^2 / 3; through the diagonal of a side; through the
  // edge of two sides, which is seen on its way in.
  worked({octahedron, {0, 0, 0}}, inside, 48, "algorithm");
  worked({cube, {6, 6, 6}}, inside, 36, "algorithm");
  worked({cube, {-1, 6, 6}}, outside, 1);  // twice two
  worked({octahedron, {-14, 0, 0}}, outside, 4);
  worked({octahedron, {-12, 6, 0}}, outside, 18);  // from the edge y = x + 12
  // Along two sides, and in them; the sides have the ray in their planes.
  worked({cube, {-1, 0, 5}}, outside, 1);
  worked({cube, {1, 0, 5}}, boundary, 0, "algorithm");
  worked({cube, {13, 12, 12}}, outside, 1);
}

TEST_CASE("point_in_polyhedron: parts, one within another, in whichever direction their faces turn") {
  const Meshd shells = together(mapped(cube, 8, -42), together(mapped(cube, 4, -18), cube));  // to 54, 30, 12
  worked({shells, {6, 5, 7}}, inside, 25);
  worked({shells, {13, 5, 7}}, outside, 1);
  worked({shells, {33, 5, 7}}, inside, 9);
  worked({together(cube, cube), {6, 5, 7}}, outside, 25);
  worked({together(cube, mapped(cube, 1, 6)), {11, 9, 7}}, outside, 1);  // in both
  worked({together(cube, mapped(cube, 1, 6)), {11, 9, 5}}, inside, 1);   // in one
}

TEST_CASE("point_in_polyhedron: faces that separate nothing are boundary") {
  // A sail in the ray's plane, a face without area from corner to corner and beyond, one that is a point.
  const Meshd sail = with_faces(with_vertex(octahedron, {24, 0, 12}), {{0, 4, 6}, {6, 4, 0}});
  worked({sail, {12, 0, 8}}, boundary, 0, "algorithm");
  worked({sail, {24, 0, 12}}, boundary, 0, "algorithm");
  worked({sail, {12, 1, 8}}, outside, 1);
  const Meshd line = with_faces(with_vertex(octahedron, {36, 0, 0}), {{0, 1, 6}, {1, 6, 0}});
  worked({line, {20, 0, 0}}, boundary, 0, "algorithm");
  worked({line, {3, 0, 0}}, boundary, 0, "algorithm");  // within the solid
  worked({line, {20, 0, 1}}, outside, 1);
  worked({line, {37, 0, 0}}, outside, 1);
  const Meshd point = with_faces(with_vertex(with_vertex(with_vertex(octahedron, {1, 1, 1}), {1, 1, 1}), {1, 1, 1}),
                                 {{6, 7, 8}, {8, 7, 6}});
  worked({point, {1, 1, 1}}, boundary, 0, "algorithm");
  worked({point, {1, 2, 1}}, inside, 1);
}

TEST_CASE("point_in_polyhedron: meshes of public reports worked by hand") {
  const Rational half_a_hollow = exact(0.05);
  worked({reported::trimesh_2534(), {0, 0, 0}}, outside, half_a_hollow * half_a_hollow);
  const Rational away = exact(0.2) - half_a_hollow;
  worked({reported::trimesh_2534(), {0.2, 0, 0}}, inside, away * away, "algorithm");
  // Cells of a quarter, from -1/4 on in y and z; the last from 0 on in x and z.
  worked({reported::trimesh_242(), {-0.375, -0.125, -0.125}}, inside, Rational(1, 64), "algorithm");
  worked({reported::trimesh_242(), {0.125, -0.125, 0.125}}, inside, Rational(1, 64), "algorithm");
  worked({reported::trimesh_242(), {0.125, -0.125, -0.125}}, outside, Rational(1, 64));  // under that, beside those
  worked({reported::trimesh_242(), {0, -0.125, 0}}, boundary, 0);                        // where they share an edge
  worked({reported::edyn_155(), {0, 0, 0}}, inside, 1, "algorithm");
  for (const double at : {-2.0, 2.0}) {
    worked({reported::edyn_155(), {at, 0, 0}}, outside, 1);
    worked({reported::edyn_155(), {0, at, 0}}, outside, 1);
    worked({reported::edyn_155(), {0, 0, at}}, outside, 1);
  }
  // Level with the ridge: 3 from an eave and 2 above it; beyond an end of the ridge.
  worked({reported::parry_171(), {-3, 3, 2}}, outside, 13);
  worked({reported::parry_171(), {7, 3, 2}}, outside, 13);
  worked({reported::parry_171(), {2, -2, 2}}, outside, 4);
  worked({reported::parry_171(), {2, 3, 2}}, boundary, 0);
  worked({reported::parry_171(), {2, 3, 1}}, inside, Rational(1, 2), "algorithm");  // the ray meets a slope's diagonal
}

TEST_CASE("point_in_polyhedron: rounding, huge, subnormal and negative zero") {
  // As doubles, 0.1 + 0.2 + 0.7 = 1 - 2^-55: inside, by so little over sqrt(3), of the face whose E rounds to 0.
  const Meshd unit_tetrahedron{{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}},
                               {{0, 2, 1}, {0, 1, 3}, {0, 3, 2}, {1, 2, 3}}};
  worked({unit_tetrahedron, {0.1, 0.2, 0.7}}, inside, power_of_two(-110) / 3, "rounding");
  // What the formula makes of infinities is its own affair.
  const Row::Question far{mapped(octahedron, huge / 12), {huge / 2, huge / 4, huge / 8}};
  CHECK(catalogue::ask_robust<Row>(far) == inside);
  CHECK(catalogue::ask_oracle<Row>(far).answer == inside);
  // Every product is 0.
  example<Row>({mapped(octahedron, tiny), {tiny, 2 * tiny, 3 * tiny}}, inside, "rounding");
  worked({octahedron, {12, -0.0, 0}}, boundary, 0);
  worked({cube, {-tiny, 5, 7}}, outside, power_of_two(-2148));
}

TEST_CASE("point_in_polyhedron: meshes are refused by the first rule that they break") {
  const std::string index = "index of a vertex", three = "three different vertices";
  const auto edge = [](int a, int b) {
    return "closed: the edge from vertex " + std::to_string(a) + " to vertex " + std::to_string(b) +
           " must be in an even number of faces";
  };
  const auto refuses = [](const Meshd& mesh, const std::string& field, const std::string& rule) {
    refused<Row>({mesh, {1, 1, 1}}, field, rule);
    const bool number = rule == "finite number";
    refused<Row>({mesh, {not_a_number, 1, 1}}, number ? field : "point[0]", "finite number");
  };
  const Meshd four{{{0, 0, 0}, {4, 0, 0}, {0, 4, 0}, {0, 0, 4}}, {{0, 2, 1}, {0, 1, 3}, {0, 3, 2}, {1, 2, 3}}};
  const auto faces = [&four](const std::vector<Face>& list) { return Meshd{four.vertices, list}; };
  refuses(with_vertex(four, {4, 0, infinity}), "mesh.vertices[4][2]", "finite number");
  refuses(with_vertex(faces({{9, 9, 9}}), {0, not_a_number, 0}), "mesh.vertices[4][1]", "finite number");
  refuses(faces({{0, 2, 2}, {0, 1, 4}}), "mesh.faces[1][2]", index);
  refuses(faces({{0, 2, 1}, {0, 1, 3}, {2, 0, 2}}), "mesh.faces[2]", three);
  refuses({}, "mesh", "at least 4 faces");
  refuses(faces({{0, 2, 1}, {0, 2, 1}}), "mesh", "at least 4 faces");
  refuses(faces({{0, 2, 1}, {0, 1, 3}, {0, 3, 2}, {0, 2, 1}}), "mesh.faces[0]", edge(0, 2));
  refuses(with_faces(four, {{3, 2, 1}}), "mesh.faces[0]", edge(2, 1));
  // Vertices in one position are not one vertex.
  Meshd cut = with_vertex(four, {0, 0, 0});
  cut.faces[2].a = 4;
  refuses(cut, "mesh.faces[0]", edge(0, 2));
  worked({with_faces(four, {{3, 2, 1}, {3, 2, 1}}), {1, 1, 1}}, inside, Rational(1, 3));
}

CONTRACT("point_in_polyhedron: the formula in double is right where the bounds of its contract say so", mesh, p) {
  return !certain(mesh, p) || answer == truth.answer;
}

CONTRACT("point_in_polyhedron: the formula in exact arithmetic is right where no S is 0", mesh, p) {
  static_cast<void>(answer);
  const auto whole = exactly(mesh);
  const auto at = exact_point(p);
  return passes_through_an_edge(whole, at) || reference::point_in_polyhedron(whole, at) == truth.answer;
}

}  // namespace touchstone::proptests::point_in_polyhedron_tests
