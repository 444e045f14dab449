// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "audit/gate/gate.h"

namespace touchstone::audit {

/// The result of a gate as a SARIF 2.1.0 log: a rule for each operation and cause, and a result for each family in
/// which it was found, with level `error` if the gate fails it, otherwise `note`, and relative to a baseline `new` or
/// `unchanged`. `source`: the file at which the results are shown, such as the engine's own, relative to the
/// repository.
std::string sarif_json(const Tally& tally, const Gate& gate, const GateResult& result, const std::string& source);

}  // namespace touchstone::audit
