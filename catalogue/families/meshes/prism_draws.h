// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "catalogue/families/draw_stream.h"
#include "geometry/polyhedra.h"

/// Prisms, named by polygons, drawn from a draw stream; the simplest is a cube.
namespace touchstone::catalogue {

/// Over a ring that does not touch itself: of points of a small lattice, so that corners lie on lines between others
/// and few corners are ears; a star; a comb; or one in tenths, of which corners are on one line but for rounding.
/// Upright, or sheared where its numbers are integers. Its polygons begin at any of their corners, and their cuts are
/// drawn.
Meshd drawn_prism(DrawStream& draws);

/// Two of them on one small lattice: they cross, touch, cover each other, or do not.
Meshd two_prisms(DrawStream& draws);

}  // namespace touchstone::catalogue
