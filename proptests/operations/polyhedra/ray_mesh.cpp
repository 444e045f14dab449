// SPDX-License-Identifier: Apache-2.0
#include "catalogue/rows/polyhedra/ray_mesh.h"

#include <algorithm>
#include <array>
#include <utility>

#include "proptests/ray_laws.h"
#include "proptests/solids.h"
#include "robust/mixed/ray_triangle.h"
#include "robust/polyhedra/point_in_polyhedron.h"

namespace touchstone::proptests::ray_mesh_tests {
namespace {

using Row = rows::ray_mesh;
using Exact = exact_answer_t<Row>;
using Hit = PassageRelation;
using namespace solids;

constexpr FacePart inside = FacePart::inside, edge = FacePart::edge, vertex = FacePart::vertex;
constexpr Worked<Row> worked;

Exact hit(const Rational& t, const Point3<Rational>& point, Index face, FacePart part, Index met) {
  return {Hit::hit, FaceHit<Rational>{t, point, face, part}, met};
}
const Exact none{Hit::none, {}, 0};

Meshd only(const Meshd& mesh, std::vector<Face> faces) { return {mesh.vertices, std::move(faces), {}}; }
Triangle3d triangle(const Meshd& mesh, std::size_t i) {
  const Face& f = mesh.faces[i];
  return {mesh.vertices[f.a], mesh.vertices[f.b], mesh.vertices[f.c]};
}

/// 12 wide from the origin: face 8 is x = 0, y <= z, face 9 the rest of that side, 11 is x = 12, y <= z.
const Meshd box = mesh_of({{0, 0, 0}, {12, 12, 12}});
const Meshd flat{{{0, 0, 0}, {4, 0, 0}, {0, 4, 0}, {0, 0, -1}, {4, 0, 3}, {0, 4, -1}}, {{0, 1, 2}}};

/// The values of the formula for a face, and whether the bounds of the contract make it certain.
struct FaceBound {
  bool certain = false, met = false;
  Rational error;  ///< of the quotient

  FaceBound(const Ray3d& ray, const Triangle3d& t) {
    const Point3d& o = ray.origin;
    const Vector3d& v = ray.direction;
    const Vector3d e = t.b - t.a, f = t.c - t.a, s = o - t.a, p = cross(v, f), q = cross(s, e);
    const double rise = dot(e, p), ca = dot(s, p), ab = dot(v, q), bc = rise - ca - ab, height = dot(f, q);
    if (!finite(rise, ca, ab, bc, height)) return;
    const auto extent = [&](double Point3d::*axis) {
      const auto gap = [](double x, double y) { return Rational(abs(exact(x) - exact(y))); };
      return Rational(gap(t.b.*axis, t.a.*axis) + gap(t.c.*axis, t.a.*axis) + gap(o.*axis, t.a.*axis));
    };
    const Rational u = unit(), x = extent(&Point3d::x), y = extent(&Point3d::y), z = extent(&Point3d::z);
    const Rational vx = size(v.x), vy = size(v.y), vz = size(v.z), relative = 9 * (1 + 5 * u) * u;
    const Rational least = power_of_two(-1073) * (vx + vy + vz + x + y + z + 3);
    const Rational of_rise = relative * (vx * y * z + vy * z * x + vz * x * y) + least,
                   of_height = relative * x * y * z + least;
    const auto sign = [](double value, const Rational& bound) { return size(value) > bound ? sgn(exact(value)) : 0; };
    const int way = sign(rise, of_rise);
    const std::array others{sign(ca, of_rise), sign(ab, of_rise), sign(bc, of_rise), sign(height, of_height)};
    met = std::all_of(others.begin(), others.end(), [way](int other) { return other == way; });
    certain = way != 0 && (met || std::find(others.begin(), others.end(), -way) != others.end());
    if (certain && met) error = error_of_quotient(height / rise, of_height, rise, of_rise);
  }
};

}  // namespace

LAW("ray_mesh: the order of the faces changes the index alone", ray, mesh) {
  if (!mesh.polygons.empty()) return true;
  const auto answer = ask(asked);
  const auto last = static_cast<Index>(mesh.faces.size() - 1);
  auto back = only(mesh, {mesh.faces.rbegin(), mesh.faces.rend()});
  for (Face& f : back.faces) f = {f.b, f.a, f.c};
  const auto found = ask(Row::Question{ray, back});
  if (answer.relation == Hit::none) return found.relation == Hit::none && found.faces_met == 0;
  if (found.faces_met != answer.faces_met) return false;
  const auto& [t, point, face, part] = *answer.first;
  const Index other = last - found.first->face;  // of those with the same t the last
  const auto alone = ask(Row::Question{ray, only(mesh, {mesh.faces[other]})});
  return found.first->t == t && alone.first->t == t && equal(found.first->point, point) && other >= face &&
         (other != face || found.first->part == part);
}

LAW("ray_mesh: the named face alone is met at the same point, and no other before it", ray, mesh) {
  if (!mesh.polygons.empty()) return true;
  const auto answer = ask(asked);
  if (answer.relation == Hit::none) return answer.faces_met == 0 && !answer.first;
  auto expected = answer;
  expected.first->face = 0, expected.faces_met = 1;
  return equal(ask(Row::Question{ray, only(mesh, {mesh.faces[answer.first->face]})}), expected);
}

LAW("ray_mesh: of two meshes together as many faces are met as of both, and the first of the two is first", ray, mesh) {
  if (!mesh.polygons.empty()) return true;
  const auto answer = ask(asked);
  const auto half = mesh.faces.begin() + static_cast<std::ptrdiff_t>(mesh.faces.size() / 2);
  const auto a = ask(Row::Question{ray, only(mesh, {mesh.faces.begin(), half})});
  const auto b = ask(Row::Question{ray, only(mesh, {half, mesh.faces.end()})});
  if (answer.faces_met != a.faces_met + b.faces_met) return false;
  if (!answer.first) return !a.first && !b.first;
  const bool in_a = answer.first->face < mesh.faces.size() / 2;
  const auto &same = in_a ? a.first : b.first, &other = in_a ? b.first : a.first;
  return same->t == answer.first->t && same->part == answer.first->part && (!other || other->t >= same->t);
}

LAW("ray_mesh: faces behind the origin change nothing; one at the origin is first, and counts", ray, mesh) {
  if (!on_small_lattice(asked) || !mesh.polygons.empty()) return true;
  const auto answer = ask(asked);
  const auto& [o, v] = ray;
  const auto count = static_cast<Index>(mesh.vertices.size());
  Meshd more = with_vertex(with_vertex(with_vertex(mesh, o + (-1.0) * v), o + (-2.0) * v), o + (-3.0) * v);
  more = with_faces(with_vertex(more, o), {{count, count + 1, count + 2}});
  if (!equal(ask(Row::Question{ray, more}), answer)) return false;
  const auto found = ask(Row::Question{ray, with_faces(more, {{count + 3, count + 3, count + 3}})});
  return found.first->t == 0 && found.faces_met == answer.faces_met + 1 &&
         (found.first->face == more.faces.size() || answer.first->t == 0);
}

ROBUST_LAW("ray_mesh: each face is met where ray_triangle meets it, also by a tree that has been asked before", ray,
           mesh) {
  const auto answer = ask(asked);
  const auto& first = answer.first;
  const robust::Surface surface(mesh);
  robust::ray_mesh({ray.origin, -1.0 * ray.direction}, surface);
  if (!equal(robust::ray_mesh(ray, surface), answer)) return false;
  if (!mesh.polygons.empty()) return true;
  Index met = 0;
  for (std::size_t i = 0; i < mesh.faces.size(); ++i) {
    const auto one = robust::ray_triangle(ray, triangle(mesh, i));
    if (one.relation != SegmentTriangleRelation::none) {
      ++met;
      if (!first || *one.t < first->t) return false;
    }
    if (!first || first->face != i) continue;
    if (one.t != first->t || !equal(*one.point, first->point)) return false;
    if (one.location && (one.location == Location::inside) != (first->part == inside)) return false;
  }
  return met == answer.faces_met;
}

LAW("ray_mesh: a face of more corners is met where the triangles of its cut are", ray, mesh) {
  const auto answer = ask(asked), of_cut = ask(Row::Question{ray, only(mesh, mesh.faces)});
  if (!answer.first) return !of_cut.first;
  return of_cut.first->t == answer.first->t && equal(of_cut.first->point, answer.first->point) &&
         answer.first->face == named_face_of_each(mesh)[of_cut.first->face] && answer.faces_met <= of_cut.faces_met &&
         (answer.first->part == vertex) == (of_cut.first->part == vertex);
}

ROBUST_LAW("ray_mesh: from inside a closed mesh a ray in general position meets an odd number of faces", ray, mesh) {
  const auto answer = ask(asked);
  for (std::size_t i = 0; i < mesh.faces.size(); ++i) {
    const auto one = robust::ray_triangle(ray, triangle(mesh, i));
    if (one.relation == SegmentTriangleRelation::none) continue;
    if (one.location != Location::inside || *one.t == 0) return true;
  }
  try {
    return (answer.faces_met % 2 == 1) == (robust::point_in_polyhedron(mesh, ray.origin) == Location::inside);
  } catch (const InvalidInput&) {
    return true;  // not closed
  }
}

TEST_CASE("ray_mesh: first faces worked by hand; margin: the nearest edge, face or next point") {
  worked({{{-6, 3, 5}, {6, 0, 0}}, box}, hit(1, {0, 3, 5}, 8, inside, 2), 2);  // from the diagonal y = z
  worked({{{-6, 5, 3}, {6, 0, 0}}, box}, hit(1, {0, 5, 3}, 9, inside, 2), 2);
  worked({{{6, 3, 5}, {4, 0, 0}}, box}, hit(Rational(3, 2), {12, 3, 5}, 11, inside, 1), 2);
  worked({{{13, 3, 5}, {4, 0, 0}}, box}, none, 1);
  worked({{{-1, 13, 5}, {1, 0, 0}}, box}, none, 1);
  worked({{{0, 0, 0}, {1, 1, 1}}, octahedron}, hit(4, {4, 4, 4}, 0, inside, 1), 24);
  worked({{{4, 4, 4}, {1, 1, 1}}, octahedron}, hit(0, {4, 4, 4}, 0, inside, 1), 0);
  worked({{{5, 5, 5}, {1, 1, 1}}, octahedron}, none, 3);
}

TEST_CASE("ray_mesh: edges and vertices belong to all of their faces") {
  worked({{{-6, 4, 4}, {12, 0, 0}}, box}, hit(Rational(1, 2), {0, 4, 4}, 8, edge, 4), 0);  // both diagonals
  worked({{{-24, 0, 0}, {12, 0, 0}}, octahedron}, hit(1, {-12, 0, 0}, 1, vertex, 8), 0);
  worked({{{12, 0, 0}, {1, 0, 0}}, octahedron}, hit(0, {12, 0, 0}, 0, vertex, 4), 0);
  worked({{{-6, 6, -6}, {0, 0, 1}}, octahedron}, hit(6, {-6, 6, 0}, 1, edge, 2), 0);  // touches the edge from outside
}

TEST_CASE("ray_mesh: the formula has no face along the ray") {
  // Along the edge from (0, 0, 0): six faces have that vertex, and the other two the edge's end.
  worked({{{-1, 0, 0}, {1, 0, 0}}, box}, hit(1, {0, 0, 0}, 0, vertex, 8), 0, "algorithm");
  worked({{{1, 1, 0}, {1, 0, 0}}, flat}, hit(0, {1, 1, 0}, 0, inside, 1), 0, "algorithm");
  worked({{{-1, 1, 0}, {2, 0, 0}}, flat}, hit(Rational(1, 2), {0, 1, 0}, 0, edge, 1), 0, "algorithm");
  worked({{{-1, 1, 0}, {2, -2, 0}}, flat}, hit(Rational(1, 2), {0, 0, 0}, 0, vertex, 1), 0, "algorithm");
}

TEST_CASE("ray_mesh: faces without area have edges and vertices alone; an empty mesh has nothing") {
  const Meshd line = only(flat, {{0, 1, 1}}), point = only(flat, {{1, 1, 1}});
  worked({{{2, -2, 0}, {0, 1, 0}}, line}, hit(2, {2, 0, 0}, 0, edge, 1), 0, "algorithm");
  worked({{{4, -2, 0}, {0, 1, 0}}, line}, hit(2, {4, 0, 0}, 0, vertex, 1), 0, "algorithm");
  worked({{{-2, 0, 0}, {1, 0, 0}}, line}, hit(2, {0, 0, 0}, 0, vertex, 1), 0, "algorithm");
  worked({{{2, -2, 1}, {0, 1, 0}}, line}, none, 1);
  worked({{{4, -2, 0}, {0, 1, 0}}, point}, hit(2, {4, 0, 0}, 0, vertex, 1), 0, "algorithm");
  worked({{{3, -2, 0}, {0, 1, 0}}, point}, none, 1);
  for (const Meshd& mesh : {Meshd{}, only(flat, {})}) {
    example<Row>({{{1, 1, -1}, {0, 0, 1}}, mesh}, none);
    CHECK(!catalogue::ask_oracle<Row>(Row::Question{{{1, 1, -1}, {0, 0, 1}}, mesh}).margin);
  }
}

TEST_CASE("ray_mesh: of faces at the same t the least index counts; others may differ by less than rounding") {
  // z = 0 and z = x - 1 cross where the ray meets both.
  const Ray3d up{{1, 1, -3}, {0, 0, 1}};
  worked({up, only(flat, {{0, 1, 2}, {3, 4, 5}})}, hit(3, {1, 1, 0}, 0, inside, 2), 0);
  worked({up, only(flat, {{3, 4, 5}, {0, 1, 2}})}, hit(3, {1, 1, 0}, 0, inside, 2), 0);
  worked({up, only(flat, {{0, 1, 2}, {0, 1, 2}})}, hit(3, {1, 1, 0}, 0, inside, 2), 0);
  // At x = 1.75, t is 7/6, which is 1/3 of 2^-52 below a double; an ulp of x behind it is 2/3 of 2^-52 later.
  const double x = 1.75, later = x + 0x1p-52;
  const Meshd two{{{later, -2, -2}, {later, 2, -2}, {later, 0, 2}, {x, -2, -2}, {x, 2, -2}, {x, 0, 2}},
                  {{0, 1, 2}, {3, 4, 5}}};
  worked({{{0, 0, 0}, {1.5, 0, 0}}, two}, hit(Rational(7, 6), {Rational(7, 4), 0, 0}, 1, inside, 2), power_of_two(-104),
         "rounding");
}

TEST_CASE("ray_mesh: faces of more than three corners worked by hand; margin: to the edges of the cut") {
  // An L of three squares of side 2, and a wall on one of its edges; then one with a slit from (2, 2) to (1, 1).
  const std::vector<Index> corners{0, 1, 2, 3, 4, 5}, slit{0, 1, 2, 3, 6, 3, 4, 5};
  const Meshd plain{{{0, 0, 0}, {4, 0, 0}, {4, 2, 0}, {2, 2, 0}, {2, 4, 0}, {0, 4, 0}, {0, 0, 9}},
                    {{3, 5, 0}, {3, 4, 5}, {0, 1, 3}, {1, 2, 3}, {0, 1, 6}},
                    {corners, {0, 1, 6}}};
  const auto down = [](double x, double y) { return Ray3d{{x, y, 2}, {0, 0, -1}}; };
  const auto first = [](double x, double y, FacePart part) {
    return hit(2, {Rational(x), Rational(y), 0}, 0, part, 1);
  };
  worked({down(1, 2), plain}, first(1, 2, inside), Rational(1, 2));
  worked({down(1, 1), plain}, first(1, 1, inside), 0, "algorithm");  // on a diagonal
  worked({down(3, 1), plain}, first(3, 1, inside), 0, "algorithm");
  worked({down(4, 1), plain}, first(4, 1, edge), 0);
  worked({down(2, 3), plain}, first(2, 3, edge), 0);
  worked({down(2, 2), plain}, first(2, 2, vertex), 0);
  worked({down(3, 3), plain}, none, 1);
  // Along it, from one arm across the notch, and from within it.
  worked({{{3, 5, 0}, {0, -1, 0}}, plain}, hit(3, {3, 2, 0}, 0, edge, 2), 0, "algorithm");
  worked({{{1, 1, 0}, {1, 1, 0}}, plain}, hit(0, {1, 1, 0}, 0, inside, 1), 0, "algorithm");
  Meshd cut_in = plain;
  cut_in.vertices[6] = {1, 1, 0};
  cut_in.faces = {{0, 1, 6}, {1, 3, 6}, {1, 2, 3}, {3, 4, 5}, {3, 5, 6}, {5, 0, 6}};
  cut_in.polygons = {slit};
  worked({down(1, 1), cut_in}, first(1, 1, vertex), 0);
  worked({down(1.5, 1.5), cut_in}, first(1.5, 1.5, edge), 0);
  worked({down(0.5, 0.5), cut_in}, first(0.5, 0.5, inside), 0, "algorithm");
}

TEST_CASE("ray_mesh: the ends of the range") {
  // As in the middle of the range: t = 1 through vertex 1 of all eight faces.
  const Rational far(exact(12 * (huge / 16)));
  example<Row>({{{-24 * (huge / 32), 0, 0}, {12 * (huge / 32), 0, 0}}, mapped(octahedron, huge / 32)},
               hit(1, {Rational(-far / 2), 0, 0}, 1, vertex, 8), "rounding");
  example<Row>({{{tiny, tiny, tiny}, {tiny, tiny, tiny}}, mapped(octahedron, tiny)},
               hit(3, {4 * exact(tiny), 4 * exact(tiny), 4 * exact(tiny)}, 0, inside, 1), "rounding");
}

TEST_CASE("ray_mesh: what is refused, and by which rule first") {
  const Ray3d ray{{0, 0, 1}, {0, 0, 1}}, still{{0, 0, 1}, {0, 0, 0}};
  refused<Row>({{{0, not_a_number, 1}, {0, 0, 0}}, with_vertex(flat, {0, infinity, 0})}, "ray.origin[1]",
               "finite number");
  refused<Row>({still, with_vertex(flat, {0, infinity, 0})}, "mesh.vertices[6][1]", "finite number");
  refused<Row>({still, only(flat, {{0, 1, 6}})}, "ray.direction", "nonzero direction");
  refused<Row>({ray, only(flat, {{0, 1, 2}, {0, 6, 1}})}, "mesh.faces[1][1]", "index of a vertex");
  Meshd square{{{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}}, {{0, 1, 2}, {0, 1, 3}}, {{0, 1, 2, 3}}};
  refused<Row>({still, square}, "ray.direction", "nonzero direction");
  refused<Row>({ray, square}, "mesh.cut", "a cut of the faces into triangles");
  square.vertices[3].z = 1;
  refused<Row>({ray, square}, "mesh.faces[0]", "planar");
}

CONTRACT("ray_mesh: the formula in double keeps its contract", ray, mesh) {
  Rational error;
  for (std::size_t i = 0; i < mesh.faces.size(); ++i) {
    const FaceBound face(ray, triangle(mesh, i));
    if (!face.certain) return true;
    if (face.met) error = std::max(error, face.error);
  }
  if (answer.relation != truth.answer.relation || answer.faces_met != truth.answer.faces_met) return false;
  if (!answer.first || !finite(answer.first->t)) return true;
  return answer.first->part == inside && within(answer.first->t, truth.answer.first->t, error);
}

}  // namespace touchstone::proptests::ray_mesh_tests
