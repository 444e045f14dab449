// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "audit/tally.h"

/// A tally as a file (`--json FILE`), version 1; all on one line:
///
///   {"touchstone":1, "kind":"tally",
///    "engine":{"name":"...", "number":"binary64|binary32", "boundary":"closed|open|unspecified", "tolerance":0},
///    "seed":1, "cases":200000, "grid":{"size":0,"shards":1,"done":[]}, "interrupted":false,
///    "operations":[{"operation":"orientation",
///                   "families":[{"family":"collinear", "cases":10, "counts":{"agree":9,"rounding":1, ...every
///                   verdict},
///                                "outcomes":{"left":4, ...}, "touches":{"closed":0,"open":0}, "refused":0,
///                                "worst_ulps":0, "smallest":{"rounding":{"input":{...}, "index":7, "answer":{...},
///                                "ulps":0, "remark":"", "touch":0}}}]}],
///    "robust":[...the same...]}
///
/// `cases` of a family is the sum of its counts. `touch`: how a touch was answered, 1 as closed sets, -1 as open sets,
/// else 0.
namespace touchstone::audit {

std::string tally_json(const Tally& tally);

/// Throws InvalidInput naming field and rule where the text is no such file, or of another version.
Tally read_tally(const std::string& text);

}  // namespace touchstone::audit
