// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "geometry/polyhedra.h"
#include "reference/sweeps/swept_aabb_aabb.h"

namespace touchstone::reference {

/// The times at which two polyhedra overlap on every axis tested so far.
template <class Real>
class ProjectedTimes {
 public:
  ProjectedTimes(const Mesh<Real>& a, const Mesh<Real>& b, const Vector3<Real>& velocity)
      : a_(a), b_(b), velocity_(velocity) {}

  void cut(const Vector3<Real>& axis) {
    const auto [a_min, a_max] = interval(a_, axis);
    const auto [b_min, b_max] = interval(b_, axis);
    time_.cut(a_min, a_max, b_min, b_max, dot(axis, velocity_));
  }

  FirstContact<Real> contact() const { return time_.contact(); }

 private:
  static std::pair<Real, Real> interval(const Mesh<Real>& mesh, const Vector3<Real>& axis) {
    const auto at = [&axis](const Point3<Real>& p) { return dot(axis, Vector3<Real>{p.x, p.y, p.z}); };
    Real min = at(mesh.vertices[0]), max = min;
    for (const Point3<Real>& vertex : mesh.vertices) {
      const Real value = at(vertex);
      if (value < min) min = value;
      if (max < value) max = value;
    }
    return {min, max};
  }

  const Mesh<Real>&a_, &b_;
  const Vector3<Real>& velocity_;
  CommonTime<Real> time_;
};

/// Finds when a moving convex polyhedron first has a common point with one at rest, by the times at which it enters and
/// leaves the other on each axis that can separate them.
///
/// Deck p. 51, with p. 54's faces and edges: the volume that a sweeps over has a common point with b, or not; and when
/// first, tells every axis as for boxes (swept_aabb_aabb.h). An axis is the normal of a face of a or of b, or at a
/// right angle to an edge of a and one of b; on it, the polyhedra are their vertices' intervals, and a moves with the
/// axis' part of the velocity. `hit` with the latest of 0 and the entries, if that is not after 1 and all exits;
/// otherwise `never`. a, b: meshes, any unit of length, the same for both; velocity in that unit a step, of a, while b
/// rests; t counts in steps. Closed sets: touching is a hit, also where a only grazes b, at t = 0 or at t = 1. The
/// truth is `hit` with t = 0 if they have a common point at the start. A velocity of 0 is valid. Refused by robust and
/// oracle: NaN or infinity in a vertex or in the velocity (velocity[c], "finite number"); then what is not the surface
/// of a convex solid, by the rules and in the order of reference/polyhedra/point_in_convex_polyhedron.h, with "a" or
/// "b" for the mesh. That page also says which meshes are valid: faces in one plane, flat vertices, vertices of no
/// face, and a surface that is inside out.
///
/// In exact arithmetic the formula is always right. At one time t, the points p such that a, moved by p, meets b are a
/// polytope with an inside: b less a. A facet of it is where a face of b meets a vertex of a, or vice versa, or an edge
/// of each: its normal is one of the axes, and the polytope lies where all these intervals overlap, ends included. So a
/// meets b at t exactly if they overlap on every axis, and on each that is so during one closed interval of time,
/// always, or never. (Axes of edges that are parallel are zero, and nothing is apart on these; an axis too many does no
/// harm, because what meets, overlaps on every axis.)
///
/// Margin: the distance by which a has to be moved, in the maximum norm, until the relation changes. 0 for a step that
/// only grazes, or ends or starts with a touch and goes no deeper.
///
/// Rounding (binary64, to nearest, u = 2^-53): let D bound the magnitudes of all coordinates and of the velocity's, D
/// in [2^-200, 2^200]. An edge is at most 2 D (1 + u), so an axis has coordinates of at most 8 D^2, off by 32 (1 + 8u)
/// u D^2; a vertex on it, or the velocity, is at most 24 D^3, off by 3 * 32 and 3 * 24, together less than e = 176 u
/// D^3; a difference of two by another 48 u D^3, so by less than 400 u D^3. With S the velocity on the axis as
/// computed, a time T is off by at most
///     e(T) = (400 u D^3 + |T| e) / (|S| - e) + 2u |T|
/// where |S| > e. The relation is right, and t as good as that, if on each axis that is not zero, as computed, |S| > e,
/// and every entry T, and 0, is more than e(T) + e(Z) away from every exit Z of another axis, and from 1. ulps: 32
/// roundings behind t (six in the edges, nine in the axis; five in each vertex's value and in the velocity's; a
/// difference, a quotient).
template <class Real>
FirstContact<Real> swept_convex_polyhedra(const Mesh<Real>& a, const Mesh<Real>& b, const Vector3<Real>& velocity) {
  ProjectedTimes<Real> times(a, b, velocity);
  for (const Mesh<Real>* mesh : {&a, &b}) {
    for (const Face& face : mesh->faces) {
      const Point3<Real>& corner = mesh->vertices[face.a];
      times.cut(cross(mesh->vertices[face.b] - corner, mesh->vertices[face.c] - corner));
    }
  }
  // Takes each edge once: its reverse is in another face.
  const auto for_each_edge = [](const Mesh<Real>& mesh, const auto& visit) {
    for (const Face& face : mesh.faces)
      for (const auto& [i, j] : {std::pair{face.a, face.b}, std::pair{face.b, face.c}, std::pair{face.c, face.a}})
        if (i < j) visit(mesh.vertices[j] - mesh.vertices[i]);
  };
  for_each_edge(a, [&](const Vector3<Real>& of_a) {
    for_each_edge(b, [&](const Vector3<Real>& of_b) { times.cut(cross(of_a, of_b)); });
  });
  return times.contact();
}

}  // namespace touchstone::reference
