// SPDX-License-Identifier: Apache-2.0
#pragma once

namespace touchstone::audit {

/// The part of a page's script that lets the reader walk over failure maps: a click, a drag or the arrow keys choose a
/// pixel, and its question, what each implementation answers and the line that asks it again are shown. It computes
/// nothing about geometry: the answers are in the images, the numbers in the attribute data-map (html_map.cpp).
/// The page is complete without it.
extern const char* const map_script;

}  // namespace touchstone::audit
