// SPDX-License-Identifier: Apache-2.0
#pragma once

namespace touchstone::catalogue {}
namespace touchstone::audit {}
namespace touchstone::report {}

/// The names of lower modules that program uses.
namespace touchstone::program {
using namespace catalogue;
using namespace audit;
using namespace report;
}  // namespace touchstone::program
