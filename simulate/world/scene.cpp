// SPDX-License-Identifier: Apache-2.0
#include "simulate/world/scene.h"

namespace touchstone::simulate {

State<double> Scene::start() const {
  State<double> state;
  for (const SceneBody& body : bodies) state.push_back(body.start);
  return state;
}

}  // namespace touchstone::simulate
