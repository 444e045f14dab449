// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <gmpxx.h>

#include <cstdint>
#include <nlohmann/json.hpp>
#include <string>

#include "geometry/invalid_input.h"

/// The JSON of the program. Numbers inside a parsed line are kept as they were typed until a reader asks for a double
/// or for the decimal itself.
namespace touchstone::catalogue {

using Json = nlohmann::ordered_json;

/// Parses one line. Every number becomes a `typed number` (see `is_typed_number`), so that 1e999 can be reported by its
/// field and 0.1 read as one tenth. Throws InvalidInput, which names the line if its text is not JSON or is nested too
/// deeply, or the duplicate key of an object.
Json parse_line(const std::string& text);
/// The same with numbers as JSON has them, for a line of a file that this program writes.
Json parse_own_line(const std::string& text);

bool is_typed_number(const Json& value);
/// The characters as they were typed, whether a number or not.
std::string typed_text(const Json& value);

/// The double nearest to the typed text: a decimal or a hexadecimal float string. Throws InvalidInput naming the field.
double read_double(const Json& value, const std::string& field);
/// The same, but also accepts "nan", "inf", "-inf", the bare words NaN, Infinity, -Infinity, and decimals beyond the
/// greatest double: an engine may answer them.
double read_answer_number(const Json& value, const std::string& field);
/// The typed text as an exact rational, before any rounding.
mpq_class read_exact(const Json& value, const std::string& field);

/// A double: an integer if it is one below 2^53, otherwise the shortest decimal that reads back; "nan", "inf", "-inf".
Json written(double value);
inline Json written(const Json& value) { return value; }
/// "p/q" or "p".
Json written(const mpq_class& value);
std::string hexadecimal(double value);
/// One number as text, in the form of `written`.
std::string decimal(double value);

/// One line, keys in the order of insertion, no spaces, printable ASCII only: safe to print on a terminal.
std::string one_line(const Json& value);

/// Refuses anything but an object with exactly these fields, and names the missing or unknown field.
void require_fields(const Json& object, const std::string& path, std::initializer_list<const char*> names);
void require_array(const Json& value, const std::string& path, std::size_t size);
std::string member_path(const std::string& path, const char* name);
/// The same for an unknown key, in a form that a complaint may print.
std::string unknown_path(const std::string& path, const std::string& key);

bool read_flag(const Json& value, const std::string& field);
/// An integer 0 <= n < 2^32.
std::uint32_t read_index(const Json& value, const std::string& field);

}  // namespace touchstone::catalogue
