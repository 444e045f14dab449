// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>

#include "geometry/polyhedra.h"
#include "oracle/exact/shapes/whole_cloud.h"
#include "oracle/exact/solids/triangles.h"

/// Decides whether two faces of a mesh meet beyond the vertices that both share.
namespace touchstone::oracle {

/// Two faces with areas, over integers. A plane through an edge of one of them, upright on that face, may hold them
/// apart. Where none does, one exact linear program decides: either there is a plane with the
/// first face on one side, the second on the other, and of their corners on it the common ones alone; what they have in
/// common is in that plane, and so spanned by common corners. Or, by Farkas, positive multiples of corners that are not
/// common, and any of common ones, cancel; those of common ones go to the side where they are positive, and what is
/// left are weights of both faces that give one point, some weight of a corner that is not common being positive.
struct TwoFaces {
  TwoFaces(const IntegerCloud& cloud, const Face& first, const Face& second);

  bool meet = false;
  /// If they do not meet: normal . p is nowhere greater on the first face than on the second; on one of them, only
  /// common corners have the greatest value of the first.
  Vector3<Integer> normal{0, 0, 0};
  /// If they meet: weights of the corners of each. For faces with three common vertices: of the first corner.
  std::array<Rational, 3> on_first, on_second;
};

/// True if a plane perpendicular to an axis or that of one of the two separates the faces: then they do not meet, and a
/// checker needs no other. False for faces with three common vertices.
bool plainly_apart(const IntegerCloud& cloud, const Face& first, const Face& second);

}  // namespace touchstone::oracle
