// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "geometry/space.h"
#include "report/figures/space_scale.h"

namespace touchstone::report {

using SpaceVertex = Point3<mpq_class>;
using SpaceVector = Vector3<mpq_class>;

std::vector<SpaceVertex> vertices_of(const SpaceFigure& drawable);

/// The rings of vertices that bound a figure's surface; none if it has no surface, or is curved or unbounded.
std::vector<std::vector<SpaceVertex>> faces_of(const SpaceFigure& drawable);

/// |v|, to many digits.
mpq_class length_of(const SpaceVector& v);

/// Two parts of a question that are so near to each other that the figure cannot show the gap, and yet do not touch.
struct SpaceGap {
  SpaceVertex at;     ///< on one part, the point nearest to the other
  SpaceVector along;  ///< the direction to the other part, of any length
  std::string label;  ///< of the first part
  mpq_class gap;      ///< the distance, in the unit of the coordinates, to many digits
};

/// The narrowest gap between vertices, edges, triangles, balls and planes that is below a few pixels of the view, not
/// zero, and at least `least`. Figures without a name and arrows have none.
std::optional<SpaceGap> narrowest_gap(const std::vector<SpaceFigure>& drawable, const SpaceScale& scale,
                                      const mpq_class& least);

}  // namespace touchstone::report
