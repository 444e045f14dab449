// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cmath>
#include <map>
#include <optional>
#include <utility>
#include <vector>

#include "geometry/penetration.h"
#include "geometry/polyhedra.h"
#include "reference/mixed/convex_distance.h"

namespace touchstone::reference {

/// A direction of any length from b to a, how far b's core reaches along it beyond the vertex of a at which a's core
/// begins, times that length, and the parts of both of which the direction was made.
template <class Real>
struct Overlap {
  Vector3<Real> direction;
  Real height;
  std::optional<SolidPart> of_a{}, of_b{};
};

/// A point and the normal of a face; a point of an edge, its direction, and the normals of both its faces.
template <class Real>
struct OutwardFace {
  Point3<Real> point;
  Vector3<Real> normal;
};
template <class Real>
struct OutwardEdge {
  Point3<Real> point;
  Vector3<Real> along, left, right;
};

template <class Real>
Point3<Real> mean_of_vertices(const Mesh<Real>& mesh) {
  Vector3<Real> sum{Real(0), Real(0), Real(0)};
  for (const Point3<Real>& p : mesh.vertices) sum = sum + (p - mesh.vertices[0]);
  return mesh.vertices[0] + Real(Real(1) / Real(static_cast<int>(mesh.vertices.size()))) * sum;
}

/// Those of a solid, or both sides of a triangle.
template <class Real>
std::vector<OutwardFace<Real>> outward_faces(const Mesh<Real>& mesh) {
  const bool flat = is_simplex(mesh);
  const Point3<Real> inside = mean_of_vertices(mesh);
  std::vector<OutwardFace<Real>> faces;
  for (const Face& f : flat ? sides_of_simplex(mesh) : mesh.faces) {
    const Point3<Real>& p = mesh.vertices[f.a];
    const Vector3<Real> normal = cross(mesh.vertices[f.b] - p, mesh.vertices[f.c] - p);
    if (flat && dot(normal, normal) == Real(0)) continue;
    faces.push_back({p, !flat && dot(normal, inside - p) > Real(0) ? Real(-1) * normal : normal});
  }
  return faces;
}

/// Those of a solid; or those of a triangle or a segment, without normals.
template <class Real>
std::vector<OutwardEdge<Real>> outward_edges(const Mesh<Real>& mesh, const std::vector<OutwardFace<Real>>& faces) {
  if (is_simplex(mesh)) {
    const Vector3<Real> none{Real(0), Real(0), Real(0)};
    std::vector<OutwardEdge<Real>> edges;
    for (std::size_t to = 1; to < mesh.vertices.size(); ++to)
      for (std::size_t from = 0; from < to; ++from)
        edges.push_back({mesh.vertices[from], mesh.vertices[to] - mesh.vertices[from], none, none});
    return edges;
  }
  std::map<std::pair<Index, Index>, std::size_t> face_at;
  for (std::size_t i = 0; i < faces.size(); ++i) {
    const Face& f = mesh.faces[i];
    face_at[{f.a, f.b}] = i, face_at[{f.b, f.c}] = i, face_at[{f.c, f.a}] = i;
  }
  std::vector<OutwardEdge<Real>> edges;
  for (const auto& [ends, face] : face_at) {
    const auto [from, to] = ends;
    if (from > to) continue;
    const Point3<Real>& p = mesh.vertices[from];
    edges.push_back({p, mesh.vertices[to] - p, faces[face].normal, faces[face_at.at({to, from})].normal});
  }
  return edges;
}

/// True if the arc between the normals of a's edge crosses the arc between those of b's, reversed, on the sphere of
/// directions: then both edges together are an edge of the Minkowski difference's face.
template <class Real>
bool makes_face(const OutwardEdge<Real>& of_a, const OutwardEdge<Real>& of_b) {
  const Vector3<Real>&a = of_a.left, &b = of_a.right, c = Real(-1) * of_b.left, d = Real(-1) * of_b.right;
  const Vector3<Real> b_a = cross(b, a), d_c = cross(d, c);
  const Real cba = dot(c, b_a), dba = dot(d, b_a), adc = dot(a, d_c), bdc = dot(b, d_c);
  return cba * dba < Real(0) && adc * bdc < Real(0) && cba * bdc > Real(0);
}

/// The direction of length 1 at a right angle to these edges, all along one line, that comes last in the order of x, y,
/// z, times any length; that of x where there is none.
template <class Real>
Vector3<Real> last_across(const std::vector<OutwardEdge<Real>>& edges) {
  Vector3<Real> found{Real(1), Real(0), Real(0)};
  for (const auto& [point, along, left, right] : edges) {
    if (dot(along, along) == Real(0)) continue;
    found = cross(along, cross({Real(1), Real(0), Real(0)}, along));
    if (dot(found, found) == Real(0)) found = {Real(0), Real(1), Real(0)};
  }
  return found;
}

/// The least overlap over all faces of both and all pairs of edges; any of those that are below 0, if there are such.
/// Where one of both is no solid, edges have no normals that tell which pairs matter: then all count, in both
/// directions, and if there are none at all, both lie along one line.
template <class Real>
Overlap<Real> least_overlap(const Mesh<Real>& a, const Mesh<Real>& b) {
  const auto faces_of_a = outward_faces(a), faces_of_b = outward_faces(b);
  Overlap<Real> least{{Real(0), Real(0), Real(0)}, Real(0)};
  Real least_square(0);
  bool first = true;
  const auto consider = [&](const Overlap<Real>& found) {
    const Real square = Real(found.height * found.height / dot(found.direction, found.direction));
    const bool apart = found.height < Real(0);
    if (first || apart || square < least_square) least = found, least_square = square;
    first = false;
    return apart;
  };
  const auto farthest = [](const Mesh<Real>& mesh, const Point3<Real>& p, const Vector3<Real>& direction) {
    Real height = dot(direction, mesh.vertices[0] - p);
    for (const Point3<Real>& q : mesh.vertices)
      if (dot(direction, q - p) > height) height = dot(direction, q - p);
    return height;
  };
  for (const auto& [point, normal] : faces_of_a) {
    const Vector3<Real> inward = Real(-1) * normal;
    if (consider({inward, farthest(b, point, inward), SolidPart::face})) return least;
  }
  for (const auto& [point, normal] : faces_of_b)
    if (consider({normal, farthest(a, point, Real(-1) * normal), std::nullopt, SolidPart::face})) return least;
  const Point3<Real> inside_b = mean_of_vertices(b);
  auto edges_of_a = outward_edges(a, faces_of_a), edges_of_b = outward_edges(b, faces_of_b);
  if (is_simplex(a) || is_simplex(b)) {
    for (const OutwardEdge<Real>& of_a : edges_of_a) {
      for (const OutwardEdge<Real>& of_b : edges_of_b) {
        const Vector3<Real> across = cross(of_a.along, of_b.along), back = Real(-1) * across;
        if (dot(across, across) == Real(0)) continue;
        for (const auto& [direction, against] : {std::pair{across, back}, {back, across}}) {
          const Real height = farthest(b, of_a.point, direction) + farthest(a, of_a.point, against);
          if (consider({direction, height, SolidPart::edge, SolidPart::edge})) return least;
        }
      }
    }
    edges_of_a.insert(edges_of_a.end(), edges_of_b.begin(), edges_of_b.end());
    if (first) least.direction = last_across(edges_of_a);
    return least;
  }
  for (const OutwardEdge<Real>& of_a : edges_of_a) {
    for (const OutwardEdge<Real>& of_b : edges_of_b) {
      if (!makes_face(of_a, of_b)) continue;
      const Vector3<Real> across = cross(of_a.along, of_b.along);
      const Vector3<Real> outward = dot(across, of_b.point - inside_b) < Real(0) ? Real(-1) * across : across;
      if (consider({outward, dot(outward, of_b.point - of_a.point), SolidPart::edge, SolidPart::edge})) return least;
    }
  }
  return least;
}

/// The part of the solid on the level of the vertices that are farthest along the direction, unless it is known.
template <class Real>
SolidPart farthest_part(const std::optional<SolidPart>& known, const Mesh<Real>& mesh, const Vector3<Real>& direction) {
  if (known) return *known;
  const auto height = [&](const Point3<Real>& p) { return dot(direction, p - mesh.vertices[0]); };
  Real most(0);
  for (const Point3<Real>& p : mesh.vertices)
    if (height(p) > most) most = height(p);
  std::vector<Vector3<Real>> spans;  // from the first vertex of the level
  const Point3<Real>* first = nullptr;
  for (const Point3<Real>& p : mesh.vertices) {
    if (height(p) != most) continue;
    if (first == nullptr) first = &p;
    else if (!(p == *first)) spans.push_back(p - *first);
  }
  for (const Vector3<Real>& span : spans) {
    const Vector3<Real> normal = cross(spans[0], span);
    if (dot(normal, normal) > Real(0)) return SolidPart::face;
  }
  return spans.empty() ? SolidPart::vertex : SolidPart::edge;
}

/// The least overlap, or that along the shortest displacement where it shows that the cores are apart: of two that are
/// no solids this is asked first, because the difference may have no face between it and the origin.
template <class Real>
Overlap<Real> overlap_of_cores(const Mesh<Real>& a, const Mesh<Real>& b) {
  const bool flat = is_simplex(a) && is_simplex(b);
  const auto apart = [&]() -> Overlap<Real> {
    const auto nearest = nearest_simplex(a, b);
    const Vector3<Real> displacement = nearest.displacement();
    const bool meeting = flat && nearest.pairs.size() == 4;
    return {displacement, meeting ? Real(0) : Real(-dot(displacement, displacement))};
  };
  if (flat) {
    const Overlap<Real> found = apart();
    if (found.height < Real(0)) return found;
  }
  const Overlap<Real> overlap = least_overlap(a, b);
  return overlap.height < Real(0) && !flat ? apart() : overlap;
}

/// How far two round convex solids overlap, and the least translation of the first that leaves them only touching. Each
/// is a convex polyhedron, a point, a segment or a triangle, its core, with all points that are no farther from it than
/// a radius: so a ball, a capsule, or a triangle that is thick.
///
/// No page of the deck asks this. The formula is that of separating axes (Gregorius, The separating axis test between
/// convex polyhedra, 2013; Ericson, Real-Time Collision Detection, 5.2.1), put together from p. 53-54's faces and
/// edges: along the normal of a face of either, or across an edge of each, that bounds the Minkowski difference, the
/// cores overlap by a height over the length of the normal, and the least of these is how deep they overlap. Where one
/// is below 0 they are apart, and the formula of convex_distance (p. 48-50) gives their distance, which counts as a
/// negative depth. The radii add to the depth. a, b: meshes, with radius_a and radius_b, any unit of length, the same
/// for all. Closed sets: `contact` is `touching` where the depth is 0, `overlapping` where it is positive. Where it is
/// negative, `disjoint`, it is minus the distance: the translation is then the least that makes them touch. So depth,
/// direction and translation are always there. The direction points from b to a; the translation is depth times it, so
/// it points from a to b where the depth is negative. A number beyond the range of doubles is infinite.
///
/// A core is a mesh: a convex polyhedron; or one without faces, of one, two or three vertices, which stands for their
/// hull. So three vertices on a line are a segment, and vertices that coincide are one point. Both sides of a triangle
/// are faces.
///
/// Where the cores meet, the direction is that of a face of the Minkowski difference: of a face of a, of one of b, or
/// across an edge of each. Where several of these are as deep, the contract names one: of each, the vertices of a that
/// are farthest against it, listed in ascending order, count; the least list in lexicographic order, where a list comes
/// before one that it begins, has it, and if two have the same, the least list of the vertices of b that are farthest
/// along it. No two such directions share both. Vertices of no face count too. Where neither core has an inside the
/// difference may have none: a point, a segment, or a polygon in a plane. Then the depth of the cores is 0, every
/// direction at a right angle to the difference is as deep, and the contract names the one whose unit vector comes last
/// in lexicographic order of x, y, z: (1, 0, 0) for a point, for a polygon one of two opposite normals. Cores that only
/// touch at a vertex or an edge part in many other directions as well. Engines promise no such choice: they may name
/// another direction that is as deep, unless they declare that they name this one (`nearest`, docs/engines.md). Where
/// the cores are apart there is one direction only, that of the shortest displacement from b to a. feature: whether the
/// vertices of a that are farthest against the direction, and those of b that are farthest along it, span a point, an
/// edge or a face.
///
/// Refused by robust and oracle: NaN or infinity; then what is not the surface of a convex solid, by the rules and in
/// the order of reference/polyhedra/point_in_convex_polyhedron.h, with "a" or "b" for the mesh, unless it has one to
/// three vertices and no face; then a negative radius ("radius_a" or "radius_b", "radius >= 0"). That page also says
/// which meshes are valid; faces of more than three corners are cut first, and refused by the rules of docs/meshes.md
/// before everything else. A mesh with faces is a solid: one whose vertices lie in a plane is refused as a mesh without
/// an inside, or for its faces without area.
///
/// In exact arithmetic contact and depth are always right: the difference's faces have these normals, and no other
/// direction overlaps less. Among several directions that are as deep the formula returns any (cause: algorithm).
///
/// Margin: |(radius_a + radius_b)^2 + s|, s being the square of the depth of the cores, negative where they are apart.
///
/// Rounding (binary64, to nearest, u = 2^-53): where the coordinates are integers below 2^20, every two of at most 2^10
/// vertices at most 2^7 apart on each axis, the radii do not overflow, the cores meet, and one of them is a solid,
/// normals, heights and the signs that choose them are exact, the squares of two depths are mistaken for each other
/// only if they differ by less than 3 u of themselves, and the contact is right; root, quotient and two sums of numbers
/// that are not negative follow: the depth is off by at most 8 u of itself. There is no bound elsewhere: a short
/// normal, of a sliver or of edges that are nearly parallel, is off by any part of itself, and its height counts as any
/// depth; and segments that cross are apart by what rounding leaves of their displacement, in any direction. ulps: 72
/// roundings behind each number (those of convex_distance, or nine in the normal, eight in the height, then five in a
/// square, root and quotient; the sums of radii and depth, and the product).
template <class Real>
Penetration<Real> penetration(const Mesh<Real>& a, const Mesh<Real>& b, const Real& radius_a, const Real& radius_b) {
  using std::sqrt;
  const Overlap<Real> overlap = overlap_of_cores(a, b);
  const Vector3<Real>& n = overlap.direction;
  const Real length = Real(sqrt(dot(n, n))), depth = Real(radius_a + radius_b + overlap.height / length);
  const Vector3<Real> unit{Real(n.x / length), Real(n.y / length), Real(n.z / length)};
  const Contact contact = depth > Real(0)    ? Contact::overlapping
                          : depth == Real(0) ? Contact::touching
                                             : Contact::disjoint;
  return {contact,
          depth,
          unit,
          depth * unit,
          {farthest_part(overlap.of_a, a, Real(-1) * n), farthest_part(overlap.of_b, b, n)}};
}

}  // namespace touchstone::reference
