// SPDX-License-Identifier: Apache-2.0
// The user's own geometry/ stands first among the include directories, as it does in most projects.
#if __has_include(<touchstone/record.h>)  // it comes with the component audit
#include <touchstone/record.h>
#endif
#include <touchstone/reference/lines/orientation.h>
#include <touchstone/robust/lines/orientation.h>

#include "geometry/answers.h"
#include "geometry/points.h"

#if __has_include("geometry/invalid_input.h") || __has_include("robust/lines/orientation.h")
#error "touchstone's headers are reached without <touchstone/...>"
#endif

int main() {
  using touchstone::Point2d;
  const auto left = [] { return touchstone::robust::orientation({0, 0}, {2, 0}, {1, 1}); };
#if __has_include(<touchstone/record.h>)
  const touchstone::Recording recording("has_its_own_geometry.log");
  const touchstone::Side side = touchstone::record("orientation", left, Point2d{0, 0}, Point2d{2, 0}, Point2d{1, 1});
#else
  const touchstone::Side side = left();
#endif
  return side == touchstone::Side::left && user::Point2d{}.x == 42 ? 0 : 1;
}
