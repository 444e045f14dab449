// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>

#include "geometry/complexity.h"
#include "geometry/polyhedra.h"
#include "robust/kernel/filters/strict_math.h"
#include "robust/structures/edge_sides.h"

/// The solids that valid meshes enclose. reference/polyhedra/polyhedron_complexity.h defines the terms.
namespace touchstone::robust::structures {

/// For a closed mesh with consistent orientation: the sign of the sum of a . (b x c), exactly: in GMP's integers where
/// rounded coordinates do not tell.
VolumeSign sign_of_volume(const Meshd& mesh);

/// For a closed embedded manifold with consistent orientation: true if no edge bends inwards as seen from one side,
/// which is the same for all. Each vertex then is a simple ring of sectors without an inward angle, so it is locally
/// the tip of a convex solid, and a closed connected surface that is locally convex everywhere bounds a convex solid
/// (Tietze, Nakajima; van Heijenoort). sides: those of its triangles. n steps.
bool locally_convex(const Meshd& mesh, const EdgeSides& sides);

/// The first face whose plane has vertices of faces on both sides. Takes faces times vertices steps if there is none;
/// tests of boxes save most of them if vertices that are neighbours in the list are near each other.
std::optional<SplittingFace> first_splitting_face(const Meshd& mesh);

}  // namespace touchstone::robust::structures
