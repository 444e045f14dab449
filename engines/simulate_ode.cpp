// SPDX-License-Identifier: Apache-2.0
// ODE makes the steps of a scene, in double precision: touchstone simulate SCENE --engine .../simulate_ode.
#include <ode/ode.h>

#include "simulated_ode.h"

int main() {
  return simulated::run<simulated::Ode>(
      {{"engine", "ODE 0.16.2"},
       {"cannot", {"particles", "stick", "penalty"}},
       {"thresholds", {"no continuous detection", "0.2 of a depth is undone in a step (ERP)"}}});
}
