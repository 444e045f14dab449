// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <gmpxx.h>

#include <optional>
#include <string>

#include "catalogue/codec/json.h"
#include "catalogue/draw/drawing.h"
#include "report/uses.h"

namespace touchstone::report {

/// A scene's figures in space as report/viewer.js takes them, coordinates brought to its steps exactly (space_scale.h).
/// null where no figure has its numbers, all finite. With `least_gap` a lens (space_lens.h) magnifies the narrowest gap
/// of at least that size that is too narrow to be seen.
Json space_model(const Drawing& scene, const std::string& title,
                 const std::optional<mpq_class>& least_gap = std::nullopt);

/// The element of a page in which the script draws the model. Without scripts it says in words what is drawn. Empty
/// where there is nothing to draw.
std::string space_figure(const Drawing& scene, const std::string& title,
                         const std::optional<mpq_class>& least_gap = std::nullopt);

/// Whether a page has such an element, and so is in need of the script; whether one of them has a lens.
bool has_space_figure(const std::string& html);
bool has_space_lens(const std::string& html);

/// The style sheet of such figures, in addition to that of figures in the plane (svg.h).
std::string space_style();

}  // namespace touchstone::report
