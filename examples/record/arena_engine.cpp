// SPDX-License-Identifier: Apache-2.0
// The collision tests of arena.cpp as an engine, so that what was recorded can be reduced:
//
//   arena_engine --serve       for touchstone reduce --engine
#if __has_include(<touchstone/program/engine_main.h>)
#include <touchstone/program/engine_main.h>
#else
#include "program/engine_main.h"
#endif

#include "arena_tests.h"

struct ArenaEngine {
  static constexpr const char* name = "arena 1.0";
  static constexpr auto boundary = touchstone::Boundary::closed;
  using number = float;

  bool sphere_sphere(const arena::Ball& a, const arena::Ball& b) { return arena::balls_meet(a, b); }
  bool sphere_aabb(const arena::Ball& ball, const arena::Crate& crate) { return arena::ball_meets_crate(ball, crate); }
  bool segment_aabb(const arena::Segment& shot, const arena::Crate& crate) {
    return arena::shot_meets_crate(shot, crate);
  }
  bool segment_segment(const arena::Segment& a, const arena::Segment& b) { return arena::steps_meet(a, b); }
};
TOUCHSTONE_ENGINE_MAIN(ArenaEngine)
