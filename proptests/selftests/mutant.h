// SPDX-License-Identifier: Apache-2.0
#pragma once

/// The number of the mutant that is on, 0 for none: read once from the environment variable TOUCHSTONE_MUTANT.
extern const int touchstone_mutant;
#define TOUCHSTONE_MUTANT(number) (touchstone_mutant == (number))
