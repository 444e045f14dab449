// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "audit/uses.h"
#include "catalogue/codec/shape_json.h"

namespace touchstone::audit {

/// The types that test frameworks print by our codec: shapes, answers, enumerators.
template <class T>
concept Printed = Composite<T> || Worded<T>;

/// Prints JSON, with decimals that read back to the same double; an enumerator prints as its name.
template <Printed T>
std::string printed(const T& value) {
  if constexpr (Worded<T>) return Words<T>::words[static_cast<std::size_t>(value)];
  else return one_line(to_json(value));
}

}  // namespace touchstone::audit
