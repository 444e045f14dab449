// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "audit/uses.h"
#include "catalogue/operation/operation.h"

namespace touchstone::audit {

/// Whether no three of a question's points lie on one line, exactly; two equal points lie on a line with any third.
/// Only the first eight points are looked at, in the plane and in space alike.
bool in_general_position(const Operation& operation, const Question& question);

/// Whether a direction, or the way from one end of a segment to the other, has a component of 0.
bool has_direction_on_axis(const Operation& operation, const Question& question);

/// What a question has that an example of a bug had better not have, as a reader takes it for the cause: a margin of 0,
/// and points that are not in general position, count one each; so does every empty list, every length of 0 (a radius),
/// every vector of length 0, every axis on which a box is flat, and every two equal shapes or points that are parts of
/// one, or among the first eight of a list. An example without any shows a bug that needs no degenerate input, as far
/// as one can tell without knowing the operation.
std::size_t degenerate_features(const Operation& operation, const Question& question, bool margin_is_0);

}  // namespace touchstone::audit
