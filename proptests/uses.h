// SPDX-License-Identifier: Apache-2.0
#pragma once

namespace touchstone::catalogue {}
namespace touchstone::audit {}
namespace touchstone::report {}
namespace touchstone::program {}

/// Tests see everything.
namespace touchstone::proptests {
using namespace catalogue;
using namespace audit;
using namespace report;
using namespace program;
}  // namespace touchstone::proptests
