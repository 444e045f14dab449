// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "catalogue/judge/verdict.h"
#include "catalogue/operation/operation.h"

/// Questions as an engine can take them.
namespace touchstone::catalogue {

/// Its numbers rounded to floats where the engine declares them; its oriented boxes at right angles, as near as doubles
/// allow, unless the engine takes skew ones.
Question fitted(const Operation& operation, const Question& question, const Declaration& declaration);

/// Whether the engine answers this alternative of the operation's questions.
bool takes_alternative(const Operation& operation, const Question& question, const Declaration& declaration);

/// The half axes of a box at right angles: the first as it is, the second without its part along the first, the third
/// across both, each as long as that leaves it. Those at right angles, to within a few units in the last place, and
/// those that are dependent stay what they are.
HalfAxes<double> at_right_angles(const HalfAxes<double>& half_axes);

}  // namespace touchstone::catalogue
