// SPDX-License-Identifier: Apache-2.0
// Embree as peer: what it documents for rays that must not leak.
#include <embree3/rtcore_common.h>
#include <touchstone/program/engine_main.h>

#include "embree_ray.h"

using namespace touchstone;

struct EmbreeRobust : EmbreeRay {
  static constexpr const char* name = "Embree 3.13.5, robust";
  using number = float;
  EmbreeRobust() : EmbreeRay(RTC_SCENE_FLAG_ROBUST) {}
};

TOUCHSTONE_ENGINE_MAIN(EmbreeRobust)
