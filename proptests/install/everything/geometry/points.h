// SPDX-License-Identifier: Apache-2.0
// A header of the user's own, of the same name as one of ours.
#pragma once

#include "geometry/answers.h"

namespace user {

struct Point2d {
  int x = answer;
};

}  // namespace user
