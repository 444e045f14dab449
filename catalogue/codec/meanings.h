// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "catalogue/codec/json.h"
#include "catalogue/shape/shape.h"

namespace touchstone::catalogue {

/// A shape as json_of describes it (shape_json.h), with the meaning of each number instead of "number": "place" for a
/// coordinate of a point, "direction" for one of a vector, "length"; "number" is nothing but itself.
Json meanings_of(const Shape& shape);

}  // namespace touchstone::catalogue
