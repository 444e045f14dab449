// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "audit/reducing/search.h"

/// The passes of a reduction. Each makes the best question of a search shorter as long as its own method can, and
/// returns whether it could.
namespace touchstone::audit::reducing {

/// Drops elements of lists other than those of meshes: halves of a list, quarters, ... single elements; and optional
/// values. If other lists refer to the elements by index, also drops the elements that refer to dropped ones, and
/// renumbers the other indices.
bool drop_elements(Search& search);

/// Makes meshes smaller: drops connected parts, runs of faces, and vertices that no face uses; merges vertices, which
/// keeps a closed mesh closed; takes the convex hull of some of the vertices, if the hull of all of them also has the
/// property.
bool reduce_meshes(Search& search);

/// Translates so that a point is at the origin, scales by powers of two, and sorts the elements of lists.
bool reduce_frame(Search& search);

/// Sets enumerators, flags and indices to the first ones, and shortens numbers: all of them, equal ones together, and
/// one by one to 0, 1, small integers, other numbers of the question, fewer decimal digits and fewer bits.
bool shorten_numbers(Search& search);

}  // namespace touchstone::audit::reducing
