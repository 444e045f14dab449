// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "simulate/scene.h"

namespace touchstone::simulate {

/// One step by option 1 of deck p. 23: a particle whose step would end in a wall (p. 22) that it approaches (p. 74) is
/// reflected (p. 68), wall by wall in their order; then it moves (p. 9).
///
/// By the textbook formulas in float or double.
template <class Real>
State<Real> step_by_formulas(const Scene& scene, const State<Real>& state);

/// The same with each decision exact, and the result of each operation rounded once.
State<double> step_by_robust(const Scene& scene, const State<double>& state);

}  // namespace touchstone::simulate
