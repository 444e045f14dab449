// SPDX-License-Identifier: Apache-2.0
// Bullet makes the steps of a scene, in single precision: touchstone simulate SCENE --engine .../simulate_bullet.
#include <bullet/LinearMath/btScalar.h>

#include "simulated_bullet.h"

int main() {
  const int version = btGetVersion();
  return simulated::run<simulated::Bullet>(
      {{"engine", "Bullet " + std::to_string(version / 100) + "." + std::to_string(version % 100)},
       {"number", "binary32"},
       {"cannot", {"particles", "stick", "penalty"}},
       {"thresholds",
        {"contacts from 0.02 m away (contact breaking threshold)", "0.2 of a depth is undone in a step (erp2)"}}});
}
