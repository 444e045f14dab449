// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>
#include <string>

#include "proptests/catch.h"

/// Properties: RapidCheck inside Catch2. Every run asks the same cases, because the seed follows from the property's
/// name.
///
///   RC_PARAMS="..."       RapidCheck's own parameters: seed, max_success, noshrink, reproduce=...
///   TOUCHSTONE_CASES=F    F times as many cases everywhere (a decimal, 1 unless told)
namespace touchstone::proptests {

/// `usual` times TOUCHSTONE_CASES, at least 1.
int scaled(int usual);

/// Checks `testable`, which draws with RapidCheck and fails with its assertions, under a name that no other property of
/// the program has. A failure prints the shrunk case and the line that repeats it; RapidCheck's own rc::prop gives no
/// name and therefore prints no such line.
void property(const std::string& name, const std::function<void()>& testable, int usual = 200);

/// Where nothing is drawn: fails with what `complaint` says, unless it says nothing.
void demand(const std::string& name, const std::function<std::string()>& complaint);

}  // namespace touchstone::proptests
