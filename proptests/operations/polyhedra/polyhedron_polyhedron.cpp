// SPDX-License-Identifier: Apache-2.0
#include "catalogue/rows/polyhedra/polyhedron_polyhedron.h"

#include <algorithm>

#include "catalogue/families/meshes/reported_meshes.h"
#include "proptests/solids.h"
#include "proptests/space_laws.h"
#include "robust/polyhedra/point_in_polyhedron.h"
#include "robust/prepared/solid.h"
#include "robust/sweeps/swept_convex_polyhedra.h"

namespace touchstone::proptests::polyhedron_polyhedron_tests {
namespace {

using Row = rows::polyhedron_polyhedron;
using namespace solids;
namespace reported = catalogue::reported;

constexpr PolyhedronPolyhedron apart{Contact::disjoint, PolyhedraStep::bounding_volumes},
    clear{Contact::disjoint, PolyhedraStep::edge_against_face},
    touching{Contact::touching, PolyhedraStep::edge_against_face},
    touching_inside{Contact::touching, PolyhedraStep::vertex_inside},
    crossing{Contact::overlapping, PolyhedraStep::edge_against_face},
    inside{Contact::overlapping, PolyhedraStep::vertex_inside};

constexpr Worked<Row> worked;

Meshd turned_over(const Meshd& mesh) {
  return with_each_face(mesh, [](Face& f) { std::swap(f.b, f.c); });
}
/// So many cubes in each of as many rows: with 16, 1,152 faces.
Meshd layer_of_cubes(std::int64_t side = 16) {
  std::vector<catalogue::LatticePoint> cells;
  for (std::int64_t i = 0; i < side * side; ++i) cells.push_back({i % side, i / side, 0});
  return cube_surface(cells);
}
/// x to y, y to z, z to x.
Meshd turned(Meshd mesh) {
  for (Point3d& p : mesh.vertices) p = {p.z, p.x, p.y};
  return mesh;
}

}  // namespace

LAW("polyhedron_polyhedron: the order of faces and vertices is nothing, nor is which way faces turn", a, b) {
  Meshd other = turned_over(b);
  const auto last = static_cast<Index>(b.vertices.size() - 1);
  for (Face& f : other.faces) f = {last - f.b, last - f.c, last - f.a};
  std::reverse(other.vertices.begin(), other.vertices.end());
  std::reverse(other.faces.begin(), other.faces.end());
  return equal(ask(Row::Question{a, other}), ask(asked));
}

LAW("polyhedron_polyhedron: a face that comes twice more changes nothing", a, b) {
  return equal(ask(Row::Question{with_faces(a, {a.faces.back(), a.faces.back()}), b}), ask(asked));
}

LAW("polyhedron_polyhedron: a solid shares its faces with itself", a) {
  return ask(Row::Question{a, a}).relation != Contact::disjoint;
}

LAW("polyhedron_polyhedron: of a mesh that is listed twice there is no interior to overlap", a, b) {
  const PolyhedronPolyhedron before = ask(asked), twice = ask(Row::Question{together(a, a), b});
  return twice.relation != Contact::overlapping && (before.relation != Contact::disjoint || equal(twice, before));
}

LAW("polyhedron_polyhedron: what is disjoint from a solid overlaps all else within a shell around both", a, b) {
  if (!on_small_lattice(asked) || ask(asked).relation != Contact::disjoint) return true;
  if (ask(Row::Question{a, a}).relation != Contact::overlapping) return true;  // a has no interior
  const Meshd shell = mapped(cube, 0x1p40, -0x1p42);
  return ask(Row::Question{a, together(b, shell)}).relation == Contact::overlapping;
}

ROBUST_LAW("polyhedron_polyhedron: point_in_polyhedron finds a vertex inside where the second step decides", a, b) {
  const PolyhedraStep step = ask(asked).decided_by;
  if (step == PolyhedraStep::bounding_volumes) return true;
  const auto any_inside = [](const Meshd& mesh, const Meshd& solid) {
    return std::any_of(mesh.faces.begin(), mesh.faces.end(), [&](const Face& f) {
      const auto at = [&](Index i) { return robust::point_in_polyhedron(solid, mesh.vertices[i]) == Location::inside; };
      return at(f.a) || at(f.b) || at(f.c);
    });
  };
  return (any_inside(a, b) || any_inside(b, a)) == (step == PolyhedraStep::vertex_inside);
}

TEST_CASE("polyhedron_polyhedron: convex meshes meet where swept_convex_polyhedra finds a contact at once") {
  const auto complaint = [](const Question& question) -> std::string {
    const auto& [a, b, velocity] = catalogue::unpacked<std::tuple<Meshd, Meshd, Vector3d>>(question);
    static_cast<void>(velocity);
    try {
      const bool met = robust::swept_convex_polyhedra(a, b, {0, 0, 0}).relation == HitRelation::hit;
      return (robust::polyhedron_polyhedron(a, b).relation != Contact::disjoint) == met ? "" : "another answer";
    } catch (const InvalidInput&) {
      return "";
    }
  };
  never(*catalogue::find_operation("swept_convex_polyhedra"), "convex meshes at rest", complaint, 4);
}

TEST_CASE("polyhedron_polyhedron: cubes worked by hand") {
  worked({cube, shifted(cube, {13, 12, 0})}, apart, 1);
  worked({cube, shifted(cube, {14, 13, 0})}, apart, 4);  // the greatest gap
  worked({cube, shifted(cube, {12, 0, 0})}, touching, 0);
  worked({cube, shifted(cube, {12, 6, 3})}, touching, 0, "algorithm");   // an edge of one enters a face of the other
  worked({cube, shifted(cube, {12, 12, 0})}, touching, 0);               // a whole edge, a part of one, a corner
  worked({cube, shifted(cube, {12, 12, 5})}, touching, 0, "algorithm");  // and here, part of an edge
  worked({cube, shifted(cube, {-12, 12, -12})}, touching, 0);
  worked({cube, cube}, crossing, 0, "algorithm");
  worked({cube, turned_over(cube)}, crossing, 0, "algorithm");
  worked({cube, shifted(cube, {6, 0, 0})}, crossing, 0, "algorithm");  // the rays of vertices run in faces
  worked({cube, shifted(cube, {5, 4, 3})}, inside, 9);                 // (5, 4, 3) and (12, 12, 12), both 3 from a face
  // (10, 7, 7) is 2 from a face. Its ray meets the diagonal between two triangles of it.
  worked({cube, shifted(mapped(cube, 0.75), {1, 7, 7})}, inside, 4, "algorithm");
  worked({cube, shifted(mapped(cube, 0.5), {0, 3, 3})}, inside, 9);  // a face on a face, from within
  worked({cube, shifted(mapped(cube, 0.5), {2, 3, 1})}, inside, 9);  // (8, 9, 7): of eight the one farthest in
}

TEST_CASE("polyhedron_polyhedron: notches, holes and hollows worked by hand") {
  worked({angle, shifted(cube, {12, 12, 0})}, touching, 0);
  worked({angle, shifted(cube, {13, 14, 0})}, clear, 1);
  worked({angle, shifted(cube, {13, 14, 11.5})}, clear, Rational(1, 4));  // so much the boxes share in z
  worked({angle, shifted(cube, {11, 12, 0})}, crossing, 0, "algorithm");  // its edges end in faces, or lie in them
  worked({ring, shifted(cube, {12, 12, 0})}, touching, 0);                // fills the hole
  const Meshd pin = shifted(mapped(cube, 0.5), {15, 16, 2});
  worked({ring, pin}, clear, 4);  // from x = 15 to 12, from y = 22 to 24
  worked({hollow, shifted(cube, {12, 12, 12})}, touching, 0);
  worked({hollow, shifted(pin, {0, 0, 13})}, clear, 4);  // in the hollow
  worked({mapped(cube, 4, -18), cube}, inside, 324);     // from 12 to 30
  worked({mapped(cube, 2, 0), cube}, inside, 144);       // in a corner: (12, 12, 12) is 12 from three faces
  worked({mapped(cube, 2, 0), octahedron}, inside, 48, "algorithm");  // the origin; its ray meets a corner
}

TEST_CASE("polyhedron_polyhedron: no vertex is within the other") {
  Meshd stick = mapped(cube, 0.5);  // [0, 6]^2 by [0, 18]
  for (Point3d& p : stick.vertices) p.z *= 3;
  worked({ring, shifted(stick, {15, 16, -3})}, clear, 4);
  worked({ring, shifted(stick, {15, 18, -3})}, touching, 0, "algorithm");  // edges of the ring end faces of the stick
  worked({ring, shifted(stick, {15, 19, -3})}, crossing, 9);               // (15, 25, -3) and (12, 24, 0)
  // Two rings of sixteen cubes as in a chain, 12 from each other everywhere.
  std::vector<catalogue::LatticePoint> cells;
  for (std::int64_t i = 0; i < 25; ++i)
    if (i % 5 % 4 == 0 || i / 5 % 4 == 0) cells.push_back({i % 5, i / 5, 0});
  const Meshd chain = cube_surface(cells);
  worked({chain, shifted(turned(chain), {24, 24, -24})}, clear, 144);
  worked({chain, shifted(turned(chain), {24, 36, -24})}, touching, 0, "algorithm");
}

TEST_CASE("polyhedron_polyhedron: faces that separate nothing touch, and do not overlap") {
  const Meshd sail = with_faces(with_vertex(octahedron, {36, 0, 12}), {{0, 4, 6}, {6, 4, 0}});
  const Meshd around = shifted(cube, {30, -6, 6});
  worked({sail, around}, touching_inside, 0, "algorithm");
}

TEST_CASE("polyhedron_polyhedron: solids of public reports worked by hand") {
  const auto pair = [](const reported::SolidPair& solids, const PolyhedronPolyhedron& expected, const Rational& margin,
                       const std::string& by_reference = "agree") {
    worked({solids.first, solids.second}, expected, margin, by_reference);
  };
  // The tips are on either side of the common face, with determinants of 82,594 and -37,292.
  pair(reported::manifold_1656(), touching, 0, "rounding");
  pair(reported::vcad_6(), touching, 0);
  // One is in z >= 0, the other in z <= 0. Edges of the second end on an edge or a face, which the formula overlooks.
  pair(reported::cgal_9192(0), touching, 0);
  pair(reported::cgal_9192(1), touching, 0, "algorithm");
  pair(reported::cgal_9192(2), touching, 0, "algorithm");
  // As floats 0.0999 is 13,408,351 * 2^-27, and 4.995 and 5.0949 are 10,475,274 and 10,684,780 times 2^-21. So the
  // first of the far cubes ends at 10,684,779.48 of these, rounded to 10,684,779. Twice 0.0999 is exact.
  pair(reported::manifold_676(false), touching, 0);
  pair(reported::manifold_676(true), apart, power_of_two(-42));
  pair(reported::openscad_3641(0), touching, 0, "algorithm");
  pair(reported::openscad_3641(1), touching, 0);
  pair(reported::openscad_3641(2), touching, 0, "algorithm");
}

TEST_CASE("polyhedron_polyhedron: huge, subnormal, and an ulp apart") {
  worked({mapped(cube, tiny), shifted(mapped(cube, tiny), {12 * tiny, 0, 0})}, touching, 0, "rounding");
  worked({mapped(cube, tiny), shifted(mapped(cube, tiny), {13 * tiny, 0, 0})}, apart, power_of_two(-2148));
  const Row::Question far{mapped(octahedron, huge / 12), mapped(octahedron, huge / 24)};
  CHECK(equal(catalogue::ask_robust<Row>(far), inside));
  CHECK(equal(catalogue::ask_oracle<Row>(far).answer, inside));
}

TEST_CASE("polyhedron_polyhedron: meshes of many faces, in trees, on any number of threads") {
  const Meshd layer = layer_of_cubes();
  const auto answer = [](const Meshd& a, const Meshd& b) {
    const PolyhedronPolyhedron alone = robust::polyhedron_polyhedron(a, b);
    const robust::Solid one(a), other(b);
    for (const std::size_t threads : {0U, 2U, 3U, 8U}) {
      CHECK(equal(robust::polyhedron_polyhedron(a, b, threads), alone));
      CHECK(equal(robust::polyhedron_polyhedron(one, other, threads), alone));
    }
    return alone;
  };
  CHECK(equal(answer(layer, shifted(layer, {193, 0, 0})), apart));
  CHECK(equal(answer(layer, shifted(layer, {192, 0, 0})), touching));
  CHECK(equal(answer(layer, shifted(layer, {5, 7, 3})), inside));
  CHECK(equal(answer(layer, turned(shifted(layer, {0, -96, 96}))), crossing));
  CHECK(equal(answer(layer, shifted(mapped(cube, 0.5), {94, 95, 3})), inside));
  CHECK(equal(answer(mapped(layer, 4), shifted(cube, {100, 100, 13})), inside));
  const Meshd shell = together(mapped(layer, 3, -1), mapped(layer, 2, 5));  // the second is a hollow in the first
  CHECK(equal(answer(shell, shifted(cube, {40, 40, 12})), clear));
  CHECK(equal(answer(shell, together(shifted(cube, {40, 40, 12}), mapped(cube, 0x1p40, -0x1p42))), inside));
}

TEST_CASE("polyhedron_polyhedron: on any number of threads, where the boxes of many faces meet") {
  // A layer on a slope, 12 high, and the same half a unit above it; once one of its vertices reaches into the first.
  Meshd slope = layer_of_cubes(40);
  const auto rise = [](const Point3d& p) { return (p.x + p.y) / 4; };
  for (Point3d& p : slope.vertices) p.z += rise(p);
  const auto above = [&slope](double z) { return shifted(slope, {0, 0, z}); };
  std::vector<Meshd> reaching;
  for (std::size_t v = 0; v < slope.vertices.size(); v += 97) {
    const Point3d& p = slope.vertices[v];
    if (p.z != rise(p) || p.x < 12 || p.y < 12 || p.x > 460 || p.y > 460) continue;
    reaching.push_back(above(12.5));
    reaching.back().vertices[v].z -= 1;
  }
  REQUIRE(reaching.size() > 8);
  for (const std::size_t threads : {1U, 2U, 3U, 8U}) {
    CAPTURE(threads);
    CHECK(equal(robust::polyhedron_polyhedron(slope, above(12.5), threads), clear));
    for (const Meshd& mesh : reaching) CHECK(equal(robust::polyhedron_polyhedron(slope, mesh, threads), inside));
  }
}

TEST_CASE("polyhedron_polyhedron: meshes are refused by the first rule that they break") {
  const Meshd bad = with_vertex(cube, {0, infinity, 0});
  refused<Row>({cube, with_faces(cube, {{0, 1, 8}})}, "b.faces[12][2]", "index of a vertex");
  refused<Row>({with_faces(cube, {{0, 1, 1}}), with_faces(cube, {{0, 1, 8}})}, "a.faces[12]",
               "three different vertices");
  refused<Row>({cube, Meshd{}}, "b", "at least 4 faces");
  const Meshd four{{{0, 0, 0}, {4, 0, 0}, {0, 4, 0}, {0, 0, 4}}, {{0, 2, 1}, {0, 1, 3}, {0, 3, 2}, {0, 2, 1}}};
  refused<Row>({cube, four}, "b.faces[0]",
               "closed: the edge from vertex 0 to vertex 2 must be in an even number of faces");
  Meshd open = layer_of_cubes(), not_finite = open;
  open.faces.pop_back(), not_finite.vertices.back().x = infinity;
  for (const std::size_t threads : {1U, 2U}) {
    const auto complaint = [threads](const Meshd& a, const Meshd& b) {
      try {
        robust::polyhedron_polyhedron(a, b, threads);
      } catch (const InvalidInput& refused) {
        return refused.field().substr(0, 2);
      }
      return std::string("none");
    };
    CHECK(complaint(open, open) == "a.");
    CHECK(complaint(layer_of_cubes(), open) == "b.");
    CHECK(complaint(open, not_finite) == "b.");
  }
}

}  // namespace touchstone::proptests::polyhedron_polyhedron_tests
