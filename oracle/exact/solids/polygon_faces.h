// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "geometry/polyhedra.h"
#include "geometry/ray_mesh.h"
#include "oracle/truth.h"

namespace touchstone::oracle {

/// Refuses a mesh with polygons that are not planar or triangles that do not triangulate them, by the definition in
/// geometry/polyhedra.h: triangles and polygon have one boundary, every two triangles are clipped against each other
/// and leave no area, and no corner has weights in a triangle that does not contain it as a corner. Its numbers are
/// finite and its indices valid.
void validate_polygons(const std::string& field, const Mesh<Rational>& mesh);
void validate_polygons(const std::string& field, const Meshd& mesh);

/// The place of a point of a face in it, by its corners, any number of them.
FacePart face_part(const std::vector<Point3<Rational>>& corners, const Point3<Rational>& x);

}  // namespace touchstone::oracle
