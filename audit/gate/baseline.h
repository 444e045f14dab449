// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "audit/gate/gate.h"

/// A baseline as a file, version 1, one entry per line so that diffs show changes:
///
///   {"touchstone":1,"kind":"baseline","engine":"my engine 1.0","seed":1,"known":[
///   {"operation":"orientation","family":"collinear","cause":"algorithm","findings":12,"cases":400,"rate":0.03}
///   ]}
///
/// `rate` is for the reader: findings divided by cases.
namespace touchstone::audit {

std::string baseline_json(const Baseline& baseline);

/// Throws InvalidInput naming field and rule if the text is not such a file, or of another version.
Baseline read_baseline(const std::string& text);

}  // namespace touchstone::audit
