// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "catalogue/signatures/signature.h"

namespace touchstone::catalogue::signatures {

struct line_line : Signature<LineLine<double>(Line2d, Line2d)> {
  TOUCHSTONE_SIGNATURE(line_line)
};

}  // namespace touchstone::catalogue::signatures
