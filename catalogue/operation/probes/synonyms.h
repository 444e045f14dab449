// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace touchstone::catalogue {

/// A name in the field or in an engine, in lower case, and the operations that answer it, the best first.
struct Synonym {
  const char* phrase;
  std::vector<const char*> operations;
};
const std::vector<Synonym>& synonyms();

/// A quantity that people look for and no operation computes: "no operation computes " what.
struct NotComputed {
  const char* phrase;
  const char* what;
};
const std::vector<NotComputed>& not_computed();

/// Returns "no operation computes an area" if one of these phrases is in the name; otherwise "".
std::string why_not_computed(std::string_view name);

/// The operations nearest to a name that is not in the catalogue, the best first, at most `most` of them; none if no
/// word matches. A phrase of the table counts most, the longer the more; then a word of an operation's name, then one
/// of its question. "RayCast", "ray-cast" and "raycasts" are the same; `did_you_mean` finds misspellings.
std::vector<std::string> nearest_operations(std::string_view name, std::size_t most);

}  // namespace touchstone::catalogue
