// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "robust/kernel/staged.h"
#include "robust/sweeps/swept_convex_polyhedra.h"

namespace touchstone::robust::stages {

/// The latest stage that one of its decisions needed; a t on the way is always found by `exact`.
struct swept_convex_polyhedra {
  static Decided<FirstContact<double>> ask(const Meshd& a, const Meshd& b, const Vector3d& velocity);
};

}  // namespace touchstone::robust::stages
