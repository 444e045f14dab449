// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "catalogue/judge/verdict.h"
#include "catalogue/operation/operation.h"

/// Questions adapted to what an engine accepts.
namespace touchstone::catalogue {

/// Rounds the numbers to floats if the engine declares them, and makes oriented boxes as nearly rectangular as doubles
/// allow, unless the engine accepts skew ones.
Question fitted(const Operation& operation, const Question& question, const Declaration& declaration);

/// True if the engine answers this alternative of the operation's questions.
bool takes_alternative(const Operation& operation, const Question& question, const Declaration& declaration);

/// The half axes of a box made perpendicular: the first unchanged, the second without its part along the first, the
/// third perpendicular to both, each with the length that remains. Axes that are perpendicular to within a few units in
/// the last place, and those that are dependent, do not change.
HalfAxes<double> at_right_angles(const HalfAxes<double>& half_axes);

}  // namespace touchstone::catalogue
