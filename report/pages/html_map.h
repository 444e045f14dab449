// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "audit/counting/tally.h"
#include "report/maps/map_image.h"

/// Failure maps as HTML.
namespace touchstone::report {

/// Maps side by side with legends and explanations; the engine and robust use the same grid. Includes everything that
/// the page's script (map.js) needs. `repeat`: how to ask an engine again.
std::string map_section(const Operation& operation, const std::vector<FailureMap>& maps, const Repeat& repeat = {});

/// A single map, for light and dark screens, with `alt` for screen readers.
std::string map_picture(const FailureMap& map, const std::string& alt);

/// "Each pixel", or "Each square of 4 × 4 pixels" of a coarser map.
std::string squares_in_words(int side);

/// A class of answers in words: "right: left of the line", "wrong by rounding: on it".
std::string class_in_words(const Operation& operation, const MapClass& entry);

}  // namespace touchstone::report
