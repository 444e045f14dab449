// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <gmpxx.h>

#include <cstdint>
#include <nlohmann/json.hpp>
#include <string>

#include "geometry/invalid_input.h"

/// JSON as the program speaks it. Numbers inside a parsed line are kept as they were typed until a reader asks for a
/// double or for the decimal itself.
namespace touchstone::catalogue {

using Json = nlohmann::ordered_json;

/// Parses one line. Every number arrives as a `typed number` (see `is_typed_number`), so that 1e999 can be reported by
/// its field and 0.1 read as one tenth. Throws InvalidInput naming the line where its text is no JSON or nested too
/// deep, or the key that an object has twice.
Json parse_line(const std::string& text);
/// The same with numbers as JSON has them: a line of a file that this program writes.
Json parse_own_line(const std::string& text);

bool is_typed_number(const Json& value);
/// Its characters as they were typed, a number or not.
std::string typed_text(const Json& value);

/// The double nearest to what was typed: a decimal or a hexadecimal float string. Throws InvalidInput naming the field.
double read_double(const Json& value, const std::string& field);
/// The same, and "nan", "inf", "-inf" are let through, the bare words NaN, Infinity, -Infinity, and decimals beyond the
/// greatest double: an engine may answer them.
double read_answer_number(const Json& value, const std::string& field);
/// What was typed as an exact rational, before any rounding.
mpq_class read_exact(const Json& value, const std::string& field);

/// A double: an integer where it is one below 2^53, else the shortest decimal that reads back; "nan", "inf", "-inf".
Json written(double value);
inline Json written(const Json& value) { return value; }
/// "p/q" or "p".
Json written(const mpq_class& value);
std::string hexadecimal(double value);
/// One number in text, as it stands in `written`.
std::string decimal(double value);

/// One line, keys in the order of insertion, no spaces, nothing but printable ASCII: a terminal shows it as it is.
std::string one_line(const Json& value);

/// Refuses what is not an object with exactly these fields, naming the field that is missing or not known.
void require_fields(const Json& object, const std::string& path, std::initializer_list<const char*> names);
void require_array(const Json& value, const std::string& path, std::size_t size);
std::string member_path(const std::string& path, const char* name);
/// The same for a key that is not one of ours, as a complaint may show it.
std::string unknown_path(const std::string& path, const std::string& key);

bool read_flag(const Json& value, const std::string& field);
/// An integer 0 <= n < 2^32.
std::uint32_t read_index(const Json& value, const std::string& field);

}  // namespace touchstone::catalogue
