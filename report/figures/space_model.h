// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <gmpxx.h>

#include <cstddef>
#include <optional>
#include <string>

#include "catalogue/codec/json.h"
#include "catalogue/draw/drawing.h"
#include "report/uses.h"

namespace touchstone::report {

/// The limit of corners of all figures of a scene together.
inline constexpr std::size_t most_corners_of_a_scene = 3000;

/// A scene's figures in space for report/scripts/viewer.js, with coordinates converted to its steps exactly
/// (space_scale.h). null if no figure has its numbers, all finite. With `least_gap` a lens (space_lens.h) magnifies the
/// narrowest gap of at least that size that is too narrow to be visible. Figures that would exceed the limit of corners
/// are left out.
Json space_model(const Drawing& scene, const std::string& title,
                 const std::optional<mpq_class>& least_gap = std::nullopt,
                 std::size_t most_corners = most_corners_of_a_scene);

/// The element of a page in which the script draws the model. Without scripts it describes the drawing in words. Empty
/// if there is nothing to draw.
std::string space_figure(const Drawing& scene, const std::string& title,
                         const std::optional<mpq_class>& least_gap = std::nullopt,
                         std::size_t most_corners = most_corners_of_a_scene);

/// True if a page has such an element, and so needs the script; true if one of them has a lens.
bool has_space_figure(const std::string& html);
bool has_space_lens(const std::string& html);

/// The style sheet of such figures, in addition to that of figures in the plane (svg.h).
std::string space_style();

}  // namespace touchstone::report
