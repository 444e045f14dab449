// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "audit/uses.h"
#include "catalogue/operation/operation.h"

namespace touchstone::audit {

/// True if no three of a question's points are collinear, exactly; two equal points are collinear with any third. Only
/// the first eight points are tested, both in the plane and in space.
bool in_general_position(const Operation& operation, const Question& question);

/// True if a direction, or the displacement between the ends of a segment, has a component of 0.
bool has_direction_on_axis(const Operation& operation, const Question& question);

/// Counts the features that the example of a bug should not have, because a reader takes them for the cause: a margin
/// of 0, and points that are not in general position, count one each; so does every empty list, every length of 0 (a
/// radius), every vector of length 0, every axis on which a box is flat, and every two equal shapes or points that are
/// parts of one, or among the first eight of a list. An example without any shows a bug that needs no degenerate input,
/// as far as can be determined without knowing the operation.
std::size_t degenerate_features(const Operation& operation, const Question& question, bool margin_is_0);

}  // namespace touchstone::audit
