// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "arithmetic/names_of_gmp.h"

using touchstone::arithmetic::sqrt;  // a declaration, as ::sqrt is one of C's functions, too
using namespace touchstone::arithmetic::names;
