// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "audit/counting/tally.h"

/// A tally as a file (`--json FILE`), version 1; all on one line:
///
///   {"touchstone":1, "kind":"tally",
///    "engine":{"name":"...", "number":"binary64|binary32", "boundary":"closed|open|unspecified", "tolerance":0},
///    "seed":1, "cases":200000, "grid":{"size":0,"shards":1,"done":[]}, "interrupted":false,
///    "limits":{"least":7.888609052210118e-31, "most":1.2676506002282294e+30}, "undeclared":["line_line", ...],
///    "operations":[{"operation":"orientation",
///                   "families":[{"family":"collinear", "cases":10, "counts":{"agree":9,"rounding":1, ...every
///                   verdict}, "cancellation":1, "out_of_range":0,
///                                "ordinary":{"cases":8, "counts":{...}, "cancellation":1, "out_of_range":0},
///                                "ways":[{"verdict":"rounding", "truth":"on", "answer":"left",
///                                         "cases":{"ordinary":1,"extreme":0},
///                                         "out_of_range":{"ordinary":0,"extreme":0}, "example":{...}}, ...],
///                                "outcomes":{"left":4, ...}, "touches":{"closed":0,"open":0}, "refused":0,
///                                "worst_ulps":0, "smallest":{"rounding":{"input":{...}, "hex":{...}, "truth":{...},
///                                "cause":"cancellation", "index":7, "answer":{...}, "ulps":0, "remark":"", "touch":0,
///                                "range":"ordinary", "features":0, "repeat":"echo ... | touchstone ask ..."}}}]}],
///    "robust":[...the same...]}
///
/// `ways` counts everything (JudgedOutcome, OutcomeCount); the other counts by verdict or truth are its sums,
/// and `smallest` is the best of its examples for each verdict. `truth` is exact and null if the question is refused;
/// `cause` is the verdict, or for `rounding` its kind. If the verdict is about a number, `number` is {"exact":0,
/// "answered":-1.92}, the exact one as the nearest of the engine's type. `touch`: how a touch was answered, 1 as closed
/// sets, -1 as open sets, otherwise 0. `vector` is the id if a test vector was asked (vectors check --engine); then
/// `index` is its line, and seed and cases are 0. If they are not 0 a family also has `surplus`, `apart`, `left_out`,
/// `other_nearest`, `other_alternative`, and, with the reason `given_up`, `not_asked` (audit/counting/tally.h: Cell).
/// Other declarations of an engine are in `engine` as in its greeting; `max_surplus` is the limit of --max-surplus. For
/// recorded calls `logs` names the files, seed and cases are 0, `family` is the call site, `index` its number in the
/// log, and each family has `recorded`: {"nearness":{"tie":3,"1":0,...}, "in_double":0, "in_float":2, "as_open_sets":3}
/// (audit/counting/recorded.h).
namespace touchstone::audit {

std::string tally_json(const Tally& tally);

/// Throws InvalidInput naming field and rule if the text is not such a file, or of another version.
Tally read_tally(const std::string& text);

}  // namespace touchstone::audit
