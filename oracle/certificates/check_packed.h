// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "oracle/certificates/check_reading.h"

/// Long lists in one string: base64 of their bytes, numbers with the lowest byte first.
namespace touchstone::certify {

std::vector<std::uint8_t> packed_bytes(const json& value, const std::string& what);
std::vector<std::uint32_t> packed_indices(const json& value, const std::string& what);
std::vector<double> packed_doubles(const json& value, const std::string& what);

std::string packed(const std::vector<std::uint8_t>& bytes);
std::string packed(const std::vector<std::uint32_t>& indices);
std::string packed(const std::vector<double>& numbers);

}  // namespace touchstone::certify
