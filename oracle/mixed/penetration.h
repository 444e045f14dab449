// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "geometry/penetration.h"
#include "geometry/polyhedra.h"
#include "oracle/exact/numbers/surd.h"
#include "oracle/truth.h"

namespace touchstone::oracle {

/// Truth: the convex hull of all differences of an extreme vertex of b and one of a, from face to face, in integers: a
/// translation of a by one of its points is one that leaves a common point of the cores. If the origin is in it, the
/// nearest of its faces; if it is flat, and a linear program finds a common point, the part of an axis at a right angle
/// to it; otherwise the shortest displacement, as in convex_distance. The radii are added.
///
/// Margin: |(radius_a + radius_b)^2 + s|, s being the square of the depth of the cores, negative where they are apart:
/// 0 where the solids touch.
///
/// Certificate: "difference_hull" where the cores meet: `of_a`, `of_b`, indices of the vertices whose differences, b's
/// less a's, are the corners of a convex polyhedron, `faces`, three of these corners each, whose planes bound all
/// differences; and `face`, the index of one that is as near to the origin as any. "common_point" where all differences
/// lie in a plane: `on_a`, `on_b`, weights of all vertices that give the same point. "nearest_points": `on_a`, `on_b`,
/// weights of all vertices for two points between which the displacement is as long as the gap that it leaves.
template <Exact Number = double>
Truth<Penetration<Surd>> penetration(const Mesh<Number>& a, const Mesh<Number>& b, const Number& radius_a,
                                     const Number& radius_b);

/// Among all directions that are as deep as that of the truth, the one at the least angle to `direction`, or that
/// itself where the cores only touch and it keeps them so; the truth itself where they are apart. No other truth rests
/// on it.
Penetration<Surd> as_deep(const Meshd& a, const Meshd& b, double radius_a, double radius_b, const Vector3d& direction);

}  // namespace touchstone::oracle
