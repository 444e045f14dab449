// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "catalogue/signatures/signature.h"

namespace touchstone::catalogue::signatures {

struct kdop_kdop {
  TOUCHSTONE_SIGNATURE(kdop_kdop)
  using Question = std::tuple<Kdop3d, Kdop3d>;
  using Answer = Contact;
};

}  // namespace touchstone::catalogue::signatures
