// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>

namespace touchstone::certify {

/// The text of the file that an input field names instead of holding its value, as "meshes/NAME.json", NAME of
/// lower-case letters, digits and '_'; in that folder, and never in another. nullopt if the field's text does not end
/// in ".json", so that it names none. Throws Refusal with field and rule.
std::optional<std::string> text_of_named_file(const std::string& folder, const std::string& field,
                                              const std::string& text);

}  // namespace touchstone::certify
