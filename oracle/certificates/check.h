// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <nlohmann/json.hpp>
#include <optional>
#include <string>

/// The small checker of certificates. It knows no geometry algorithm and includes nothing of the oracle that made them:
/// it multiplies, adds and compares rationals, and decides whether the claim follows.
namespace touchstone::certify {

/// Checks one claim, {"op":..,"input":{..},"truth":{..},"certificate":{"kind":..,facts}} (other keys are ignored):
/// empty if the certificate proves that the truth is the answer of that operation to that input, otherwise the reason
/// why it does not. Input numbers are JSON numbers or hexadecimal float strings, exact values "p/q" or "p". A test
/// vector of a refused input, {"op":..,"input":{..},"refused":{"field":..,"rule":..}}, has no certificate: the rule has
/// to be the first that the input breaks. Never throws.
std::optional<std::string> refuse(const nlohmann::json& claim);

/// The same for one line of text; refuses text that is not JSON as well. An input field that is the name of a file
/// (named_file.h) has the value that the file holds in JSON; `folder` contains the file of the line.
std::optional<std::string> refuse_text(const std::string& line, const std::string& folder = ".");

/// True if the line is a test vector of a refused input.
bool is_refused_input(const std::string& line);

}  // namespace touchstone::certify
