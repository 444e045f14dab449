// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "audit/cli/commands.h"
#include "oracle/certificates/check.h"

namespace touchstone::proptests {

/// What the checker says against the oracle's certificate for a legal question; empty if it accepts it.
inline std::string certificate_complaint(const audit::Operation& operation, const audit::Question& question) {
  const auto refused = certify::refuse(nlohmann::json::parse(audit::explained(operation, question).dump()));
  return refused ? "the checker refuses the oracle's certificate: " + *refused : "";
}

}  // namespace touchstone::proptests
