// SPDX-License-Identifier: Apache-2.0
#pragma once

/// The number of the mutant that is on, 0 for none; first that in the environment variable TOUCHSTONE_MUTANT.
extern int touchstone_mutant;
#define TOUCHSTONE_MUTANT(number) (touchstone_mutant == (number))
