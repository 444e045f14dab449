// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "audit/gate/gate.h"

namespace touchstone::audit {

/// The result of a gate as JUnit's XML: a suite for each operation, a test case for each of its families, which fails
/// where the gate fails it, and says what was accepted where it does not. What the engine does not answer is skipped.
/// No times and no dates: the same audit gives the same bytes.
std::string junit_xml(const Tally& tally, const GateResult& result);

/// Text as XML holds it, in attributes as in elements; what XML cannot hold at all is written \xNN.
std::string xml_text(const std::string& text);

}  // namespace touchstone::audit
