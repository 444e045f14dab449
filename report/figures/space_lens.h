// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "catalogue/codec/json.h"
#include "report/figures/space_gap.h"

namespace touchstone::report {

/// Adds to the model of a figure that is a node: `node`, its depth, and whether it was `entered`.
void add_node(Json& model, const SpaceFigure& figure);

/// The figures around a gap as a second model for viewer.js, clipped where they leave its view. A ball that is large
/// compared with the gap is drawn as its tangent plane there. `mark` is the position of the gap in the steps of the
/// full view, `turn` a view that shows the gap in its true length.
Json space_lens(const std::vector<SpaceFigure>& figures, const SpaceScale& whole, const SpaceGap& gap);

}  // namespace touchstone::report
