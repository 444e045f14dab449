// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "catalogue/codec/json.h"

namespace touchstone::catalogue {

/// An answer as an engine typed it with its numbers parsed: the form that files keep.
Json plain(const Json& answer);

/// The same, as text if it is nested deeper than 32; an answer of more than 4,096 characters is truncated, with its
/// length.
Json kept(const Json& answer);

}  // namespace touchstone::catalogue
