// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "catalogue/codec/json.h"
#include "catalogue/draw/drawing.h"
#include "report/uses.h"

namespace touchstone::report {

/// A scene's figures in space as report/viewer.js takes them, coordinates brought to its steps exactly (space_scale.h).
/// null where no figure has its numbers, all finite.
Json space_model(const Drawing& scene, const std::string& title);

/// The element of a page in which the script draws the model. Without scripts it says in words what is drawn. Empty
/// where there is nothing to draw.
std::string space_figure(const Drawing& scene, const std::string& title);

/// Whether a page has such an element, and so is in need of the script.
bool has_space_figure(const std::string& html);

/// The style sheet of such figures, in addition to that of figures in the plane (svg.h).
std::string space_style();

}  // namespace touchstone::report
