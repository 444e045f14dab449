// SPDX-License-Identifier: Apache-2.0
#pragma once

/// The number of the planted bug that is on, 0 for none: read once from the environment variable of the same name.
extern const int touchstone_planted;
#define TOUCHSTONE_PLANTED(number) (touchstone_planted == (number))
