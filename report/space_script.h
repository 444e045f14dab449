// SPDX-License-Identifier: Apache-2.0
#pragma once

namespace touchstone::audit {

/// Lets the reader turn every figure of space_svg on a page: by dragging, by arrow keys; Home turns it back. The same
/// strokes as space_view.cpp, from the figure's data-space. Nothing moves by itself.
extern const char* const space_script;

}  // namespace touchstone::audit
