// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "simulate/world/scene.h"

namespace touchstone::simulate {

/// Strict: throws InvalidInput, which names the place in the file, the rule and what was found instead; a field or a
/// word that is misspelled is told which was meant. docs/simulate.md describes the fields.
Scene read_scene(const Json& json);

}  // namespace touchstone::simulate
