// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "robust/kernel/staged.h"
#include "robust/response/momentum.h"

namespace touchstone::robust::stages {

/// There is no filter: numbers have to be found.
struct momentum {
  static Perhaps<Vector3d> enclosed(const std::vector<Bodyd>& bodies);
  static Vector3d exact(const std::vector<Bodyd>& bodies);
  static Decided<Vector3d> ask(const std::vector<Bodyd>& bodies);
};

}  // namespace touchstone::robust::stages
