// SPDX-License-Identifier: Apache-2.0
#pragma once

namespace touchstone::catalogue {}
namespace touchstone::audit {}

/// The names of lower modules that report uses.
namespace touchstone::report {
using namespace catalogue;
using namespace audit;
}  // namespace touchstone::report
