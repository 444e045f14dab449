// SPDX-License-Identifier: Apache-2.0
#pragma once

namespace touchstone::catalogue {}

/// The names of the modules below, in which audit is written.
namespace touchstone::audit {
using namespace catalogue;
}  // namespace touchstone::audit
