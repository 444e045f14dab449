// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "simulate/world/scene.h"

namespace touchstone::simulate {

/// Strict: throws InvalidInput, which names the position in the file, the rule and the value found; for a misspelled
/// field or enumerator, also the one that was probably meant. docs/simulate.md describes the fields.
Scene read_scene(const Json& json);

}  // namespace touchstone::simulate
