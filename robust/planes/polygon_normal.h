// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "geometry/answers.h"
#include "geometry/invalid_input.h"
#include "robust/kernel/filters/staged.h"

namespace touchstone::robust {

/// The normal of a polygon in space, twice the vector of its area (Newell's sum), and the same of length 1.
///
/// Seen from the normal's tip a simple planar polygon runs counter-clockwise; it may be concave, cross itself or not be
/// planar. `degenerate`, without numbers, if the sum is 0: all vertices are collinear, or a figure of eight cancels.
/// Right for all finite doubles in every floating-point environment, and every coordinate correctly rounded. NaN and
/// infinities throw InvalidInput, which names the field and "finite number"; so do fewer than three vertices ("at least
/// 3 vertices"). Contract: reference/planes/polygon_normal.h.
PolygonNormal<double> polygon_normal(const Polygon3d& polygon);

namespace stages {

/// There is no filter: numbers have to be computed.
struct polygon_normal : Signatures<decltype(robust::polygon_normal)> {
  static Partial enclosed, lattice;
  static Total exact;
  static Staged ask;
};

}  // namespace stages

}  // namespace touchstone::robust
