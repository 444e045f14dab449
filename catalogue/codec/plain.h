// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "catalogue/codec/json.h"

namespace touchstone::catalogue {

/// An answer as an engine typed it with its numbers read: what a file keeps of it.
Json plain(const Json& answer);

/// The same, as a text where it is nested deeper than 32; of more than 4,096 characters the beginning and the length.
Json kept(const Json& answer);

}  // namespace touchstone::catalogue
