// SPDX-License-Identifier: Apache-2.0
#include "robust/polyhedra/point_in_polyhedron.h"

#include <algorithm>
#include <array>
#include <cstdint>

#include "geometry/validation.h"
#include "robust/kernel/filters/control_word.h"
#include "robust/kernel/filters/ordered_bits.h"
#include "robust/kernel/shapes/face_side.h"
#include "robust/kernel/solids/closed_mesh.h"
#include "robust/lines/orientation.h"
#include "robust/prepared/solid.h"

namespace touchstone::robust {
namespace {

/// Coordinates that can be compared whatever the control word.
using Place = std::array<std::int64_t, 3>;
Place place(const Point3d& p) {
  return {kernel::ordered_bits(p.x), kernel::ordered_bits(p.y), kernel::ordered_bits(p.z)};
}

using Coordinate = double Point3d::*;

/// The turns of each edge of a triangle and the point, in two coordinates: 1 left, 0 collinear, -1 right.
using Turns = std::array<int, 3>;
Turns turns_of(const std::array<const Point3d*, 3>& corners, const Point3d& p, Coordinate u, Coordinate v,
               Stage& latest) {
  const auto projected = [u, v](const Point3d& q) { return Point2d{q.*u, q.*v}; };
  const auto turn = [&](const Point3d& a, const Point3d& b) {
    return 1 - static_cast<int>(stages::orientation::ask(projected(a), projected(b), projected(p)).noting(latest));
  };
  return {turn(*corners[0], *corners[1]), turn(*corners[1], *corners[2]), turn(*corners[2], *corners[0])};
}

/// True if the point is outside the triangle, which may be a segment or a point; otherwise it may still be beyond its
/// end.
bool beside(const Turns& turns) {
  return std::max({turns[0], turns[1], turns[2]}) == 1 && std::min({turns[0], turns[1], turns[2]}) == -1;
}

/// A turn of a, b and the point in y and z after the point was moved by (0, e, e^2) for infinitesimal e > 0: if it is
/// 0, it gets the sign of its change by e, a.z - b.z times e, or if that is 0, by e^2. 0 only for an edge along the
/// ray.
int moved(int turn, const Place& a, const Place& b) {
  if (turn != 0) return turn;
  if (a[2] != b[2]) return a[2] > b[2] ? 1 : -1;
  return (b[1] > a[1]) - (b[1] < a[1]);
}

enum class Meeting { none, crossed, held };

/// Decides whether the ray to +x from the point, moved by (0, e, e^2), crosses a face, or whether the face contains the
/// unmoved point. Every line in y and z contains the moved point for at most two e, so for all small e the ray's line
/// meets no edge, and crosses a face at most once: if the three turns agree. If no face contains the point, none comes
/// between it and its moved position for small e, and they are inside or outside together.
Meeting meeting(const Meshd& mesh, const Face& face, const Point3d& p, const Place& at, Stage& latest) {
  const std::array corners{&mesh.vertices[face.a], &mesh.vertices[face.b], &mesh.vertices[face.c]};
  const Place a = place(*corners[0]), b = place(*corners[1]), c = place(*corners[2]);
  const auto below = [&](std::size_t axis) { return at[axis] < std::min({a[axis], b[axis], c[axis]}); };
  const auto above = [&](std::size_t axis) { return at[axis] > std::max({a[axis], b[axis], c[axis]}); };
  if (above(0) || below(1) || above(1) || below(2) || above(2)) return Meeting::none;
  const Turns turns = turns_of(corners, p, &Point3d::y, &Point3d::z, latest);
  if (beside(turns)) return Meeting::none;
  const int first = moved(turns[0], a, b);
  const bool met = first != 0 && moved(turns[1], b, c) == first && moved(turns[2], c, a) == first;
  if (below(0)) return met ? Meeting::crossed : Meeting::none;
  // The point is in the face's box. If it is also in its plane, the face contains it if it is outside of its projection
  // along no axis: a triangle with an area has one along some axis; if it is a segment or a point, the point is on the
  // line, and the box bounds it.
  const int side = kernel::FaceSide(mesh, face).of(p).noting(latest);
  if (side != 0) return met && side != first ? Meeting::crossed : Meeting::none;
  const bool held = !beside(turns_of(corners, p, &Point3d::z, &Point3d::x, latest)) &&
                    !beside(turns_of(corners, p, &Point3d::x, &Point3d::y, latest));
  return held ? Meeting::held : Meeting::none;
}

/// any(held): calls held with faces until it is true.
template <class Any>
Decided<Location> located(const Meshd& mesh, const Point3d& point, const Any& any) {
  Stage latest = Stage::filter;
  const Place at = place(point);
  bool odd = false;
  const bool held = any([&](const Face& face) {
    const Meeting found = meeting(mesh, face, point, at, latest);
    odd ^= found == Meeting::crossed;
    return found == Meeting::held;
  });
  return {held ? Location::boundary : odd ? Location::inside : Location::outside, latest};
}

}  // namespace

Decided<Location> stages::point_in_polyhedron::ask(const Meshd& mesh, const Point3d& point) {
  validation::validate_numbers("mesh", mesh), validation::validate("point", point),
      kernel::validate_closed("mesh", mesh);
  return of_valid(mesh, point);
}

Decided<Location> stages::point_in_polyhedron::of_valid(const Meshd& mesh, const Point3d& point) {
  return located(mesh, point, [&mesh](const auto& held) { return std::ranges::any_of(mesh.faces, held); });
}

Decided<Location> stages::point_in_polyhedron::of_faces(const Meshd& mesh, const std::vector<Index>& faces,
                                                        const Point3d& point) {
  return located(mesh, point, [&](const auto& held) {
    return std::ranges::any_of(faces, [&](Index i) { return held(mesh.faces[i]); });
  });
}

Decided<Location> stages::point_in_polyhedron::of_tree(const Meshd& mesh, const structures::FaceTree& tree,
                                                       const Point3d& point) {
  const kernel::ControlWord guard;
  using kernel::processor::at_run_time;  // rounded after the control word is set
  const Point3d from{at_run_time(point.x), at_run_time(point.y), at_run_time(point.z)};
  return located(mesh, point, [&](const auto& held) {
    return tree.any_along_x(from, [&](Index i) { return held(mesh.faces[i]); });
  });
}

Location point_in_polyhedron(const Solid& solid, const Point3d& point) {
  validation::validate_numbers("point", point);
  return stages::point_in_polyhedron::of_tree(solid.mesh(), solid.tree(), point).answer;
}

Location point_in_polyhedron(const Meshd& mesh, const Point3d& point) {
  return stages::point_in_polyhedron::ask(mesh, point).answer;
}

}  // namespace touchstone::robust
