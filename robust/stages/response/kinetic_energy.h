// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "robust/kernel/staged.h"
#include "robust/response/kinetic_energy.h"

namespace touchstone::robust::stages {

/// There is no filter: numbers have to be found.
struct kinetic_energy {
  static Perhaps<double> enclosed(const std::vector<Bodyd>& bodies);
  static double exact(const std::vector<Bodyd>& bodies);
  static Decided<double> ask(const std::vector<Bodyd>& bodies);
};

}  // namespace touchstone::robust::stages
