// SPDX-License-Identifier: Apache-2.0
#include "catalogue/rows/polyhedra/point_mesh_distance.h"

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>

#include "proptests/closest_laws.h"
#include "proptests/solids.h"
#include "proptests/space_laws.h"
#include "robust/mixed/closest_point_on_triangle.h"
#include "robust/polyhedra/point_in_polyhedron.h"

namespace touchstone::proptests::point_mesh_distance_tests {
namespace {

using Row = rows::point_mesh_distance;
using Exact = exact_answer_t<Row>;
using namespace solids;

constexpr Location inside = Location::inside, boundary = Location::boundary, outside = Location::outside;
constexpr FacePart within_face = FacePart::inside, edge = FacePart::edge, vertex = FacePart::vertex;

/// Side z = 0 is faces 0 (y >= x) and 1, z = 12 is 2 (y <= x) and 3, y = 0 is 4 (z <= x) and 5, y = 12 is 6 (z >= x)
/// and 7, x = 0 is 8 (z >= y) and 9, x = 12 is 10 (z <= y) and 11; and the same sides as six squares.
const Meshd box = mesh_of({{0, 0, 0}, {12, 12, 12}});
const Meshd squares{
    box.vertices, box.faces, {{0, 2, 3, 1}, {4, 5, 7, 6}, {0, 1, 5, 4}, {2, 6, 7, 3}, {0, 4, 6, 2}, {1, 3, 7, 5}}};

/// Vertices 6, 7 and 8 are on a line beside the octahedron, the last between the others.
const Meshd with_line = with_faces(
    with_vertex(with_vertex(with_vertex(octahedron, {20, 0, 0}), {30, 0, 0}), {24, 0, 0}), {{6, 7, 8}, {8, 7, 6}});

void worked(const Point3d& p, const Meshd& mesh, Location location, const Point3<Rational>& nearest,
            const Rational& distance, Index face, FacePart part, const std::string& by_reference = "agree") {
  const Rational with_sign = location == inside ? Rational(-distance) : distance;
  const Rational square(distance * distance);
  constexpr Worked<Row> check;
  check({p, mesh}, Exact{location, {{nearest.x, nearest.y, nearest.z}, face, part}, square, distance, with_sign},
        square, by_reference);
}

Meshd listed_backwards(const Meshd& mesh) {
  Meshd back = with_each_face(mesh, [](Face& f) { f = {f.b, f.a, f.c}; });
  std::reverse(back.faces.begin(), back.faces.end());
  return back;
}

template <class Answer>
bool same_place(const Answer& a, const Answer& b) {
  return a.location == b.location && equal(a.nearest.point, b.nearest.point) &&
         a.squared_distance == b.squared_distance && a.distance == b.distance && a.signed_distance == b.signed_distance;
}

}  // namespace

LAW("point_mesh_distance: it does not matter how faces are listed, turned or cut", p, mesh) {
  return same_place(ask(asked), ask(Row::Question{p, listed_backwards(mesh)}));
}

LAW("point_mesh_distance: the sign is that of the location, which is the boundary where the distance is 0", p, mesh) {
  const auto found = ask(asked);
  if (found.location == boundary) return is_zero(found.distance) && is_zero(found.squared_distance);
  return found.signed_distance == (found.location == inside ? -found.distance : found.distance);
}

LAW("point_mesh_distance: of a mesh that is listed twice nothing is inside, and the surface is the same", p, mesh) {
  if (!mesh.polygons.empty()) return true;
  const auto found = ask(asked);
  auto twice = ask(Row::Question{p, together(mesh, mesh)});
  if (twice.location != (found.location == boundary ? boundary : outside)) return false;
  if (twice.signed_distance != found.distance) return false;
  twice.location = found.location, twice.signed_distance = found.signed_distance;
  return equal(twice, found);
}

LAW("point_mesh_distance: exact motions keep location and distances", p, mesh) {
  const auto found = ask(asked);
  for (const AxisMap& map : axis_maps) {
    const auto moved = ask(map(asked));
    if (moved.location != found.location || moved.squared_distance != found.squared_distance ||
        moved.signed_distance != found.signed_distance)
      return false;
  }
  return true;
}

LAW("point_mesh_distance: vertices of faces are nearest to themselves", p, mesh) {
  for (std::size_t i = 0; i < mesh.faces.size(); i += 1 + mesh.faces.size() / 4) {
    const Point3d& v = mesh.vertices[mesh.faces[i].c];
    const auto at = ask(Row::Question{v, mesh});
    if (at.location != boundary || !is_zero(at.distance) || rounded(at.nearest.point.x) != v.x) return false;
  }
  return true;
}

ROBUST_LAW("point_mesh_distance: as near as the nearest face, where point_in_polyhedron has it, also by a tree", p,
           mesh) {
  const auto answer = ask(asked);
  if (answer.location != robust::point_in_polyhedron(mesh, p)) return false;
  double least = infinity, of_named = infinity, named = infinity;
  const std::vector<Index> names = named_face_of_each(mesh);
  for (std::size_t i = 0; i < mesh.faces.size(); ++i) {
    const auto& [a, b, c] = mesh.faces[i];
    const auto one = robust::closest_point_on_triangle(p, {mesh.vertices[a], mesh.vertices[b], mesh.vertices[c]});
    least = std::min(least, one.squared_distance);
    if (names[i] != answer.nearest.face || !equal(one.point, answer.nearest.point)) continue;
    of_named = std::min(of_named, one.squared_distance), named = std::min(named, one.distance);
  }
  const robust::Solid solid(mesh);
  robust::point_mesh_distance({p.y, p.z, p.x}, solid);
  return answer.squared_distance == least && of_named == least && named == answer.distance &&
         equal(robust::point_mesh_distance(p, solid), answer);
}

TEST_CASE("point_mesh_distance: all lengths times a power of two") {
  robust_law<Row>("points and distances too", distances_scale<Row>);
}

TEST_CASE("point_mesh_distance: faces, edges and vertices of a cube worked by hand") {
  worked({-2, 5, 7}, box, outside, {0, 5, 7}, 2, 8, within_face);
  worked({-2, 7, 5}, box, outside, {0, 7, 5}, 2, 9, within_face);
  worked({1, 5, 7}, box, inside, {0, 5, 7}, 1, 8, within_face);
  worked({0, 5, 7}, box, boundary, {0, 5, 7}, 0, 8, within_face);
  worked({-3, -4, 5}, box, outside, {0, 0, 5}, 5, 5, edge);
  worked({-2, -3, -6}, box, outside, {0, 0, 0}, 7, 0, vertex);
  worked({13, 14, 14}, box, outside, {12, 12, 12}, 3, 2, vertex);
  worked({-5, 4, 4}, box, outside, {0, 4, 4}, 5, 8, edge);  // the diagonal of a side
  worked({6, 6, 1}, box, inside, {6, 6, 0}, 1, 0, edge);
}

TEST_CASE("point_mesh_distance: of several nearest points the first counts, by x, then y, then z") {
  worked({6, 6, 6}, box, inside, {0, 6, 6}, 6, 8, edge, "algorithm");
  worked({3, 3, 7}, box, inside, {0, 3, 7}, 3, 8, within_face, "algorithm");
  worked({9, 9, 7}, box, inside, {9, 12, 7}, 3, 7, within_face);
  worked({3, 5, 9}, box, inside, {0, 5, 9}, 3, 8, within_face, "algorithm");
  worked({5, 3, 3}, box, inside, {5, 0, 3}, 3, 4, within_face, "algorithm");
}

TEST_CASE("point_mesh_distance: a diagonal of a face of four corners is no edge of it") {
  worked({-5, 4, 4}, squares, outside, {0, 4, 4}, 5, 4, within_face, "algorithm");
  worked({-3, -4, 5}, squares, outside, {0, 0, 5}, 5, 2, edge);
  worked({-2, -3, -6}, squares, outside, {0, 0, 0}, 7, 0, vertex);
  worked({9, 9, 7}, squares, inside, {9, 12, 7}, 3, 3, within_face);
}

TEST_CASE("point_mesh_distance: faces that separate nothing are surface; without area they have edges and vertices") {
  worked({22, 3, 0}, with_line, outside, {22, 0, 0}, 3, 8, edge);
  worked({24, 3, 0}, with_line, outside, {24, 0, 0}, 3, 8, vertex, "algorithm");
  worked({33, 4, 0}, with_line, outside, {30, 0, 0}, 5, 8, vertex);
  worked({23, 0, 0}, with_line, boundary, {23, 0, 0}, 0, 8, edge);
}

TEST_CASE("point_mesh_distance: through a hole and in a hollow the point is outside") {
  const auto finds = [](const Point3d& p, const Meshd& mesh, Location location, const Point3d& nearest,
                        double distance) {
    const auto found = catalogue::ask_robust<Row>(Row::Question{p, mesh});
    const auto truth = catalogue::ask_oracle<Row>(Row::Question{p, mesh}).answer;
    CHECK(found.location == location);
    CHECK(equal(found.nearest.point, nearest));
    CHECK(found.signed_distance == distance);
    CHECK(truth.location == location);
    CHECK(truth.signed_distance == oracle::Surd(exact(distance)));
  };
  finds({18, 18, 6}, ring, outside, {12, 18, 6}, 6);  // in the middle of the hole
  finds({23, 18, 6}, ring, outside, {24, 18, 6}, 1);
  finds({6, 18, 4}, ring, inside, {6, 18, 0}, -4);
  finds({18, 17, 14}, hollow, outside, {18, 17, 12}, 2);
  finds({18, 17, 8}, hollow, inside, {18, 17, 12}, -4);
  finds({18, 18, 18}, hollow, outside, {12, 18, 18}, 6);
}

TEST_CASE("point_mesh_distance: rounding, and the ends of the range") {
  const auto found = [](const Point3d& p, const Meshd& mesh) {
    return catalogue::ask_robust<Row>(Row::Question{p, mesh});
  };
  const double root = 0x1.bb67ae8584caap+0;  // of 3: from x + y + z = 12, of which (4, 4, 4) is a point
  CHECK(found({5, 5, 5}, octahedron).signed_distance == root);
  CHECK(found({3, 3, 3}, octahedron).signed_distance == -root);
  CHECK(found({3, 3, 3}, octahedron).squared_distance == 3);
  const auto small = found({5 * tiny, 5 * tiny, 5 * tiny}, mapped(octahedron, tiny));
  CHECK(small.nearest.point.x == 4 * tiny);
  CHECK(small.distance == 2 * tiny);
  CHECK(small.squared_distance == 0);
  const double big = 0x1p1019;
  const auto large = found({3 * big, 3 * big, 3 * big}, mapped(octahedron, big));
  CHECK(large.location == inside);
  CHECK(large.nearest.point.z == 4 * big);
  CHECK(large.squared_distance == infinity);
  CHECK(large.signed_distance == -root * big);
  // Inside, a quarter of the least number from x = least y / 2^600.
  const double far = 0x1p600;
  const Meshd sloping{{{0, 0, 0}, {tiny, far, 0}, {0, 0, far}, {far, 0, 0}},
                      {{0, 2, 1}, {0, 1, 3}, {0, 3, 2}, {1, 2, 3}}};
  const auto near = found({tiny, 0.75 * far, 0.125 * far}, sloping);
  CHECK(near.location == inside);
  CHECK(near.distance == 0);
  CHECK((near.signed_distance == 0 && !std::signbit(near.signed_distance)));
}

TEST_CASE("point_mesh_distance: what is refused, and by which rule first") {
  const Point3d p{1, 1, 1};
  const auto faces = [](const std::vector<Face>& list) { return Meshd{octahedron.vertices, list, {}}; };
  refused<Row>({{0, not_a_number, 0}, with_vertex(octahedron, {0, infinity, 0})}, "point[1]", "finite number");
  refused<Row>({p, with_vertex(faces({{9, 9, 9}}), {0, infinity, 0})}, "mesh.vertices[6][1]", "finite number");
  refused<Row>({p, faces({{0, 2, 2}, {0, 1, 6}})}, "mesh.faces[1][2]", "index of a vertex");
  refused<Row>({p, faces({{0, 2, 1}, {2, 0, 2}})}, "mesh.faces[1]", "three different vertices");
  refused<Row>({p, {}}, "mesh", "at least 4 faces");
  refused<Row>({p, faces({{0, 2, 1}, {0, 1, 3}, {0, 3, 2}, {0, 2, 1}})}, "mesh.faces[0]",
               "closed: the edge from vertex 0 to vertex 2 must be in an even number of faces");
}

CONTRACT("point_mesh_distance: on edges and at vertices the formula in double is not too short by more than e", p,
         mesh) {
  if (answer.nearest.part == within_face || !finite(answer.distance)) return true;
  const Rational u = unit();
  Rational most;  // over the triangles of the face that is named
  for (std::size_t i = 0; i < mesh.faces.size(); ++i) {
    if (named_face_of_each(mesh)[i] != answer.nearest.face) continue;
    const Face& f = mesh.faces[i];
    Rational e;
    for (double Point3d::*axis : {&Point3d::x, &Point3d::y, &Point3d::z}) {
      const auto at = [&](Index v) { return exact(mesh.vertices[v].*axis); };
      const auto [low, high] = std::minmax({at(f.a), at(f.b), at(f.c)});
      e += 4 * u * (high - low + std::max(abs(low), abs(high))) + power_of_two(-1073);
    }
    most = std::max(most, e);
  }
  // D + 2^-536 >= (D* - e) (1 - 4u), by squares: D* is a root.
  const Rational reach((exact(answer.distance) + power_of_two(-536)) / (1 - 4 * u) + most);
  return reach * reach >= truth.answer.squared_distance.rational_part();
}

}  // namespace touchstone::proptests::point_mesh_distance_tests
