// SPDX-License-Identifier: Apache-2.0
#include "catalogue/rows/polyhedra/point_in_convex_polyhedron.h"

#include <set>

#include "geometry/validation.h"
#include "proptests/solids.h"
#include "proptests/space_laws.h"
#include "proptests/triangle_laws.h"
#include "robust/polygons/point_in_convex_polygon.h"

namespace touchstone::proptests::point_in_convex_polyhedron_tests {
namespace {

using Row = rows::point_in_convex_polyhedron;
using solids::together, solids::with_each_face;

constexpr Location inside = Location::inside, boundary = Location::boundary, outside = Location::outside;

const Meshd tetrahedron{{{0, 0, 0}, {4, 0, 0}, {0, 4, 0}, {0, 0, 4}}, {{0, 2, 1}, {0, 1, 3}, {0, 3, 2}, {1, 2, 3}}};
const Meshd cube = solids::mesh_of({{0, 0, 0}, {4, 4, 4}});

template <class Change>
Row::Question with_each_point(Row::Question question, const Change& change) {
  auto& [mesh, point] = question;
  std::for_each(mesh.vertices.begin(), mesh.vertices.end(), change);
  change(point);
  return question;
}

/// Negative zeros too.
Meshd times(double factor, Meshd mesh) {
  for (Point3d& p : mesh.vertices) p = {factor * p.x, factor * p.y, factor * p.z};
  return mesh;
}

Meshd turned_inside_out(const Meshd& mesh) {
  return with_each_face(mesh, [](Face& face) { std::swap(face.b, face.c); });
}

Meshd with_faces(Meshd mesh, const std::vector<Face>& faces) {
  mesh.faces = faces;
  return mesh;
}
Meshd with_vertex(Meshd mesh, std::size_t place, const Point3d& p) {
  mesh.vertices.resize(std::max(mesh.vertices.size(), place + 1));
  mesh.vertices[place] = p;
  return mesh;
}

/// Of the vertices of large meshes, whose every question takes vertices times faces steps, only some are asked about.
std::size_t step(const Meshd& mesh) { return 1 + mesh.vertices.size() / 16; }

constexpr Worked<Row> worked;

/// Whether every E of the slide is certain by the bound of the contract. What overflows stays infinite or NaN up to E.
bool certain(const Meshd& mesh, const Point3d& p) {
  return std::all_of(mesh.faces.begin(), mesh.faces.end(), [&](const Face& face) {
    return certainly_beside({mesh.vertices[face.a], mesh.vertices[face.b], mesh.vertices[face.c]}, p);
  });
}

/// Twice the pyramid over a ring, to both sides of its plane: it cuts the plane in the ring, n times as large. The tips
/// are over the mean of the ring's n vertices.
Meshd double_pyramid(const Polygon2d& ring) {
  const double n = static_cast<double>(ring.size());
  Meshd mesh{{{0, 0, n}, {0, 0, -n}}, {}};
  for (std::size_t i = 0; i < ring.size(); ++i) {
    const auto here = static_cast<Index>(i + 2), next = static_cast<Index>((i + 1) % ring.size() + 2);
    for (Point3d* tip : {&mesh.vertices[0], &mesh.vertices[1]}) tip->x += ring[i].x, tip->y += ring[i].y;
    mesh.faces.push_back({0, here, next});
    mesh.faces.push_back({1, next, here});
    mesh.vertices.push_back({n * ring[i].x, n * ring[i].y, 0});
  }
  return mesh;
}

}  // namespace

LAW("point_in_convex_polyhedron: powers of two of each axis, where they are exact, keep the answer") {
  const auto stretched = [](const Row::Question& question, int x, int y, int z) {
    return with_each_point(question, [=](Point3d& p) {
      p = {std::ldexp(p.x, x), std::ldexp(p.y, y), std::ldexp(p.z, z)};
    });
  };
  const Location location = ask(asked);
  for (const auto& [x, y, z] :
       {std::array{1, 1, 1}, {-29, 30, 0}, {0, -300, 300}, {700, 0, -500}, {-900, -900, -900}}) {
    const auto image = stretched(asked, x, y, z);
    const bool exact = numbers_of(stretched(image, -x, -y, -z)) == numbers_of(asked);
    if (exact && ask(image) != location) return false;
  }
  return true;
}

LAW("point_in_convex_polyhedron: it does not matter in which order faces and vertices are listed", mesh, p) {
  return solids::in_any_order(mesh, [&, location = ask(asked)](const Meshd& other) {
    return ask(Row::Question{other, p}) == location;
  });
}

LAW("point_in_convex_polyhedron: a mesh turned inside out, or listed twice, is the same solid", mesh, p) {
  const Location location = ask(asked);
  return ask(Row::Question{turned_inside_out(mesh), p}) == location &&
         ask(Row::Question{together(mesh, mesh), p}) == location;
}

LAW("point_in_convex_polyhedron: the vertices of faces are on the boundary, and none is outside", mesh) {
  std::set<Index> used;
  for (const Face& f : mesh.faces) used.insert({f.a, f.b, f.c});
  for (std::size_t v = 0; v < mesh.vertices.size(); v += step(mesh)) {
    const Location location = ask(Row::Question{mesh, mesh.vertices[v]});
    if (location == outside || (used.count(static_cast<Index>(v)) == 1 && location != boundary)) return false;
  }
  return true;
}

LAW("point_in_convex_polyhedron: the middle of two points of the solid is not outside, on the lattice", mesh, p) {
  if (!on_small_lattice(asked)) return true;
  const Meshd twice = times(2, mesh);
  const auto middle_is_outside = [&](const Point3d& a, const Point3d& b) {
    return ask(Row::Question{twice, {a.x + b.x, a.y + b.y, a.z + b.z}}) == outside;
  };
  const bool holds_point = ask(asked) != outside;
  for (std::size_t v = 0; v < mesh.vertices.size(); v += step(mesh)) {
    if (middle_is_outside(mesh.vertices[0], mesh.vertices[v])) return false;
    if (holds_point && middle_is_outside(p, mesh.vertices[v])) return false;
  }
  return true;
}

TEST_CASE("point_in_convex_polyhedron: a double pyramid cuts the plane of its base in the base") {
  const auto complaint = [](const Question& question) -> std::string {
    const auto [given, p] = catalogue::unpacked<std::tuple<Polygon2d, Point2d>>(question);
    const touchstone::validation::OpenRing opened(given);
    const Polygon2d& ring = *opened;
    if (!on_lattice(std::tuple(ring, p))) return "";
    const double n = static_cast<double>(ring.size());
    try {
      const Location location = robust::point_in_convex_polygon(given, p);
      const Row::Question above{double_pyramid(ring), {n * p.x, n * p.y, 0}};
      if (catalogue::ask_robust<Row>(above) != location) return "robust finds another cut";
      return catalogue::ask_oracle<Row>(above).answer == location ? "" : "the oracle finds another cut";
    } catch (const InvalidInput& refused) {
      return refused.field().starts_with("mesh") ? refused.what() : "";
    }
  };
  never(*catalogue::find_operation("point_in_convex_polygon"), "the base of a double pyramid", complaint, 4);
}

TEST_CASE("point_in_convex_polyhedron: p. 53's side tests worked by hand") {
  // The faces' planes are x = 0, y = 0, z = 0 and x + y + z = 4; |x + y + z - 4| / sqrt(3) from the last.
  worked({tetrahedron, {1, 1, 1}}, inside, Rational(1, 3));
  worked({tetrahedron, {0.5, 1, 1}}, inside, Rational(1, 4));
  worked({tetrahedron, {1, 1, 2}}, boundary, 0);
  worked({tetrahedron, {2, 2, 0}}, boundary, 0);
  worked({tetrahedron, {4, 0, 0}}, boundary, 0);
  worked({tetrahedron, {2, 2, 1}}, outside, Rational(1, 3));
  worked({tetrahedron, {-1, 0, 0}}, outside, 1);  // on two planes, beyond the edge that they share
  worked({tetrahedron, {-1, -3, 0}}, outside, 9);
  worked({cube, {2, 2, 2}}, inside, 4);
  worked({cube, {1, 2, 3}}, inside, 1);
  worked({cube, {2, 2, 4}}, boundary, 0);  // on the edge that the two triangles of a side share
  worked({cube, {3, 4, 4}}, boundary, 0);
  worked({cube, {3, 4, 5}}, outside, 1);
  worked({turned_inside_out(cube), {1, 2, 3}}, inside, 1);
  worked({turned_inside_out(cube), {5, 2, 7}}, outside, 9);
}

TEST_CASE("point_in_convex_polyhedron: flat vertices, unused ones, and a surface twice round its solid") {
  const Meshd unused = with_vertex(tetrahedron, 4, {1, 1, 1});
  worked({unused, {1, 1, 1}}, inside, Rational(1, 3));
  // A face in three parts about its middle; two faces in two parts about the middle of their edge.
  worked({with_faces(with_vertex(times(3, tetrahedron), 4, {4, 4, 4}),
                     {{0, 2, 1}, {0, 1, 3}, {0, 3, 2}, {1, 2, 4}, {2, 3, 4}, {3, 1, 4}}),
          {4, 4, 4}},
         boundary, 0);
  worked({with_faces(with_vertex(tetrahedron, 4, {2, 0, 0}),
                     {{0, 2, 4}, {4, 2, 1}, {0, 4, 3}, {4, 1, 3}, {0, 3, 2}, {1, 2, 3}}),
          {1, 1, 1}},
         inside, Rational(1, 3));
  worked({together(tetrahedron, tetrahedron), {1, 1, 1}}, inside, Rational(1, 3));
  worked({together(tetrahedron, tetrahedron), {2, 2, 1}}, outside, Rational(1, 3));
}

TEST_CASE("point_in_convex_polyhedron: rounding, huge, subnormal and negative zero") {
  // As doubles, 0.1 + 0.2 + 0.7 = 1 - 2^-55.
  worked({times(0.25, tetrahedron), {0.1, 0.2, 0.7}}, inside, power_of_two(-110) / 3, "rounding");
  example<Row>({times(huge / 4, tetrahedron), {huge / 2, huge / 4, huge / 8}}, inside,
               "rounding");                                                          // infinity - infinity
  example<Row>({times(tiny, tetrahedron), {tiny, tiny, tiny}}, inside, "rounding");  // every product is 0
  example<Row>({times(tiny, tetrahedron), {2 * tiny, 2 * tiny, tiny}}, outside, "rounding");
  worked({times(-0.25, tetrahedron), {-0.0, -0.5, -0.25}}, boundary, 0);
  // Beyond x = 0 by the least number, squared.
  worked({tetrahedron, {-tiny, 1, 1}}, outside, power_of_two(-2148));
}

TEST_CASE("point_in_convex_polyhedron: meshes are refused by the first rule that they break") {
  const std::string index = "index of a vertex", three = "three different vertices", area = "nonzero area",
                    flat = "convex: vertices on one plane have no inside";
  const auto edge = [](const std::string& a, const std::string& b) {
    return "closed: edge " + a + " -> " + b + " must occur once, and " + b + " -> " + a + " once";
  };
  const auto beyond = [](const std::string& vertex) {
    return "convex: vertex " + vertex + " must not lie beyond its plane";
  };
  const auto refuses = [](const Meshd& mesh, const std::string& field, const std::string& rule) {
    refused<Row>({mesh, {1, 1, 1}}, field, rule);
    // The numbers of both fields before the mesh's rules, of these the mesh's first.
    const bool number = rule == "finite number";
    refused<Row>({mesh, {not_a_number, 1, 1}}, number ? field : "point[0]", "finite number");
  };
  refuses(with_vertex(tetrahedron, 1, {4, 0, infinity}), "mesh.vertices[1][2]", "finite number");
  refuses(with_vertex(tetrahedron, 7, {not_a_number, 0, infinity}), "mesh.vertices[7][0]", "finite number");
  refuses(with_faces(with_vertex(tetrahedron, 3, {0, -infinity, 0}), {{9, 9, 9}}), "mesh.vertices[3][1]",
          "finite number");
  refuses(with_faces(tetrahedron, {{0, 2, 2}, {0, 1, 4}}), "mesh.faces[1][2]", index);
  refuses(with_faces(tetrahedron, {{0, 2, 1}, {5, 4, 3}}), "mesh.faces[1][0]", index);
  refuses({}, "mesh", "at least 4 faces");
  refuses(with_faces(tetrahedron, {{0, 2, 1}, {0, 1, 3}, {2, 0, 2}}), "mesh.faces[2]", three);
  refuses(with_faces(tetrahedron, {{0, 2, 1}, {0, 1, 3}, {0, 3, 2}}), "mesh", "at least 4 faces");
  // The last face turned over has 2 -> 1 as the first one has; a second copy of the first has all its edges.
  refuses(with_faces(tetrahedron, {{0, 2, 1}, {0, 1, 3}, {0, 3, 2}, {1, 3, 2}}), "mesh.faces[0]", edge("2", "1"));
  refuses(with_faces(tetrahedron, {{0, 1, 3}, {0, 2, 1}, {0, 3, 2}, {1, 2, 3}, {0, 2, 1}}), "mesh.faces[0]",
          edge("0", "1"));
  // Without its last face the cube is open along 1 -> 7 -> 5 -> 1.
  Meshd open = cube;
  open.faces.pop_back();
  refuses(open, "mesh.faces[2]", edge("5", "7"));
  // A sliver along an edge, and the same with a vertex beyond a plane besides.
  const std::vector<Face> sliver{{0, 2, 1}, {0, 4, 3}, {4, 1, 3}, {0, 3, 2}, {1, 2, 3}, {0, 1, 4}};
  refuses(with_faces(with_vertex(tetrahedron, 4, {2, 0, 0}), sliver), "mesh.faces[5]", area);
  refuses(with_faces(with_vertex(with_vertex(tetrahedron, 4, {2, 0, 0}), 5, {9, 9, 9}), sliver), "mesh.faces[5]", area);
  refuses(with_vertex(tetrahedron, 3, {1, 1, 0}), "mesh", flat);
  refuses(with_vertex(tetrahedron, 3, {2, 0, 0}), "mesh.faces[1]", area);  // flat besides
  refuses(with_vertex(tetrahedron, 4, {9, 9, 9}), "mesh.faces[3]", beyond("4"));
  refuses(with_vertex(with_vertex(tetrahedron, 4, {1, 1, 1}), 5, {1, 1, -tiny}), "mesh.faces[0]", beyond("5"));
  refuses(with_vertex(cube, 7, {3, 3, 3}), "mesh.faces[2]", beyond("6"));  // a dent: 4 y + 12 (z - 4) <= 0
  // Two solids side by side; one inside another that is turned over.
  Meshd beside = tetrahedron;
  for (Point3d& p : beside.vertices) p.x += 10;
  refuses(together(tetrahedron, beside), "mesh.faces[3]", beyond("4"));
  refuses(together(tetrahedron, turned_inside_out(tetrahedron)), "mesh.faces[4]", beyond("3"));
}

CONTRACT("point_in_convex_polyhedron: the formula in double is right where the bound of its contract says so", mesh,
         p) {
  return !certain(mesh, p) || answer == truth.answer;
}

TEST_CASE("point_in_convex_polyhedron: the formula is right in exact arithmetic") { right_in_exact_arithmetic<Row>(); }

}  // namespace touchstone::proptests::point_in_convex_polyhedron_tests
