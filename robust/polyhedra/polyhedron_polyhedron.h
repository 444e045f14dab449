// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "geometry/invalid_input.h"
#include "geometry/polyhedra.h"
#include "geometry/solids.h"
#include "robust/kernel/filters/staged.h"

namespace touchstone::robust {

/// Classifies the solids within two closed meshes as `disjoint`, `touching` or `overlapping`, and tells which step of
/// the test decides: `bounding_volumes`, `vertex_inside` or `edge_against_face`.
///
/// The meshes are closed: every edge, an unordered pair of vertices, is in an even number of faces. They may be
/// concave, have several parts, cross themselves, have duplicate faces or faces without area, and have either
/// orientation: a point is inside if a ray leaves it through an odd number of faces. The time is the number of faces of
/// one times that of the other, or from 1024 faces on, that of sorting both into trees and of the pairs whose boxes
/// meet; if the surfaces meet and no point near the contact is found inside of both, many times the former. Right for
/// all finite doubles in every floating-point environment. NaN and infinities throw InvalidInput, which names the field
/// and "finite number"; so does a mesh that is not closed (with the face and the edge). `threads` is the number of
/// threads that may be used, 0 for as many as the machine runs at once: answer and errors are the same. Contract:
/// reference/polyhedra/polyhedron_polyhedron.h.
PolyhedronPolyhedron polyhedron_polyhedron(const Meshd& a, const Meshd& b);
PolyhedronPolyhedron polyhedron_polyhedron(const Meshd& a, const Meshd& b, std::size_t threads);

class Solid;  // robust/prepared/solid.h
/// The same without its validation, by the trees of both.
PolyhedronPolyhedron polyhedron_polyhedron(const Solid& a, const Solid& b);
PolyhedronPolyhedron polyhedron_polyhedron(const Solid& a, const Solid& b, std::size_t threads);

namespace stages {

/// The latest stage that one of its decisions needed.
struct polyhedron_polyhedron {
  static Decided<PolyhedronPolyhedron> ask(const Meshd& a, const Meshd& b, std::size_t threads = 1);
};

}  // namespace stages

}  // namespace touchstone::robust
