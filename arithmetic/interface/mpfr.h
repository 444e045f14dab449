// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "arithmetic/interface/gmpxx.h"
#include "arithmetic/names_of_mpfr.h"
