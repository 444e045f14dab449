// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <gmpxx.h>

#include "catalogue/codec/tape.h"

namespace touchstone::audit {

/// The numbers of the truth.
using TrueNumber = mpq_class;
using TrueTape = Tape<TrueNumber>;

}  // namespace touchstone::audit
