// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "audit/gate/gate.h"

namespace touchstone::audit {

/// The result of a gate as JUnit's XML: a suite for each operation, and a test case for each of its families, which
/// fails if the gate fails it, and otherwise lists the accepted findings. Families that the engine does not answer are
/// skipped. No times and no dates: the same audit gives the same bytes.
std::string junit_xml(const Tally& tally, const GateResult& result);

/// Text escaped for XML, in attributes and in elements; characters that XML cannot represent are written \xNN.
std::string xml_text(const std::string& text);

}  // namespace touchstone::audit
