// SPDX-License-Identifier: Apache-2.0
// Embree as peer: its fast rays.
#include <embree3/rtcore_common.h>

#include "engines/embree_ray.h"
#include "program/engine_main.h"

using namespace touchstone;

struct Embree : EmbreeRay {
  static constexpr const char* name = "Embree 3.13.5";
  using number = float;
  Embree() : EmbreeRay(RTC_SCENE_FLAG_NONE) {}
};

TOUCHSTONE_ENGINE_MAIN(Embree)
