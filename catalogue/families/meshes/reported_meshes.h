// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <utility>

#include "geometry/polyhedra.h"

/// Meshes that a library was reported to be wrong about, named after the thread: CGAL's issue 9486 is `cgal_9486`. The
/// numbers are those of the report. Where it has none, or none that can be read, "after" says that its words are
/// followed instead. Faces are counter-clockwise from outside.
namespace touchstone::catalogue::reported {

using SolidPair = std::pair<Meshd, Meshd>;

/// github.com/CGAL/cgal/issues/9486: two opposite faces over the same three vertices; does_self_intersect says no, then
/// does_bound_a_volume crashes. Twice, one above the other, because a mesh here has four faces at least.
Meshd cgal_9486();

/// After github.com/CGAL/cgal/issues/9192, "two tetrahedrons with one common point, but no common vertices", which
/// autorefine_triangle_soup makes a pinched surface of: a corner of the second is at a corner (0) of the first, on an
/// edge (1), on a face (2).
SolidPair cgal_9192(int on);

/// github.com/elalish/manifold/issues/1656: two tetrahedra on either side of a face. For one in twenty such pairs the
/// union keeps the face twice; for these two as well.
SolidPair manifold_1656();
/// Their union with that face, and as it should be.
Meshd manifold_1656_kept();
Meshd manifold_1656_united();

/// github.com/libigl/libigl/issues/2381: a triangle cut into four and these again, in which five pairs of faces were
/// said to cross.
Meshd libigl_2381();

/// github.com/ecto/vcad/issues/6: boxes one upon the other, whose union keeps the face between them twice.
SolidPair vcad_6();
/// Their union with that face.
Meshd vcad_6_kept();

/// github.com/mikedh/trimesh/issues/2534: a cube within a cube, taken away from it; the origin was said to be within
/// what is left. (0.2, 0, 0) is.
Meshd trimesh_2534();

/// After github.com/mikedh/trimesh/issues/242: cubes of a regular grid in [-1/2, 1/2]^3, of which points are inside
/// that are not. Rays along an axis through points of the grid run in faces, through edges and corners.
Meshd trimesh_242();

/// github.com/xissburg/edyn/issues/155: a cube which rays from (2, 0, 0) to (-2, 0, 0), and along the other axes, were
/// said to miss. They are parallel to four of its sides.
Meshd edyn_155();

/// After github.com/dimforge/parry/issues/171, which was ncollide's 335: a roof whose ridge a passing ray touches "from
/// inside".
Meshd parry_171();

/// github.com/elalish/manifold/issues/676: cubes side by side, of which the union is one part near the origin, and two
/// further away. In single precision, as they were: near, they touch; far, they are 2^-21 apart.
SolidPair manifold_676(bool far);

/// github.com/openscad/openscad/pull/3641: a cube and another that has in common with it a part of an edge (0), with
/// which CGAL's corefinement failed; a corner (1), a part of a face (2), with which it did not.
SolidPair openscad_3641(int common);

}  // namespace touchstone::catalogue::reported
