// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "geometry/invalid_input.h"

namespace touchstone::proptests {

/// What the input of a call is refused with, or "accepted".
template <class Call>
std::string refusal_of(const Call& call) {
  try {
    call();
    return "accepted";
  } catch (const InvalidInput& refused) {
    return refused.what();
  }
}

}  // namespace touchstone::proptests
