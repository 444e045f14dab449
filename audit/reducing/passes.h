// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "audit/reducing/search.h"

/// The passes of a reduction. Each makes the best question of a search shorter as long as it can in its own way, and
/// says whether it could.
namespace touchstone::audit::reducing {

/// Drops elements of lists other than those of meshes: halves of a list, quarters, ... single elements; and what is
/// optional. Where other lists refer to the elements by their places, also the elements that refer to what goes, the
/// other places counted anew.
bool drop_elements(Search& search);

/// Makes meshes smaller: drops connected parts, runs of faces, and vertices that no face names; makes vertices one,
/// which keeps a closed mesh closed; takes the convex hull of some of the vertices, where the hull of all of them will
/// do.
bool reduce_meshes(Search& search);

/// Moves places so that one of them is at the origin, scales by powers of two, and orders the elements of lists.
bool reduce_frame(Search& search);

/// Makes enumerators, flags and places in lists the first ones, and numbers short: all of them, equal ones together,
/// and one by one to 0, 1, small integers, other numbers of the question, fewer decimal digits and fewer bits.
bool shorten_numbers(Search& search);

}  // namespace touchstone::audit::reducing
