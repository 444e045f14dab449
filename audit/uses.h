// SPDX-License-Identifier: Apache-2.0
#pragma once

namespace touchstone::catalogue {}

/// The names of lower modules that audit uses.
namespace touchstone::audit {
using namespace catalogue;
}  // namespace touchstone::audit
