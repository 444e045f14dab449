// SPDX-License-Identifier: Apache-2.0
// Embree as peer: its fast rays.
#include <embree3/rtcore_common.h>
#include <touchstone/program/engine_main.h>

#include "embree_ray.h"

using namespace touchstone;

struct Embree : EmbreeRay {
  static constexpr const char* name = "Embree 3.13.5";
  using number = float;
  Embree() : EmbreeRay(RTC_SCENE_FLAG_NONE) {}
};

TOUCHSTONE_ENGINE_MAIN(Embree)
