// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstddef>
#include <string>
#include <string_view>

#include "audit/uses.h"
#include "geometry/invalid_input.h"

namespace touchstone::audit::meshes {

/// The bytes of a binary file, read in order. Errors name the byte at which the defective part begins, counted from 0.
class Bytes {
 public:
  Bytes(std::string name, std::string_view all, std::endian order, std::size_t at = 0)
      : name_(std::move(name)), all_(all), order_(order), at_(at), began_(at) {}

  std::size_t left() const { return all_.size() - at_; }
  /// True if only blanks and line ends are left.
  bool blank() const { return all_.find_first_not_of(std::string_view(" \t\r\n\0", 5), at_) == all_.npos; }
  void skip(std::size_t count) { take(count); }

  std::string_view take(std::size_t count) {
    began_ = at_;
    if (count > all_.size() - at_) refuse("more bytes: the file ends too early");
    at_ += count;
    return all_.substr(began_, count);
  }

  template <class Number>
  Number number() {
    std::array<char, sizeof(Number)> raw{};
    const std::string_view found = take(sizeof(Number));
    std::copy(found.begin(), found.end(), raw.begin());
    if (order_ != std::endian::native) std::reverse(raw.begin(), raw.end());
    return std::bit_cast<Number>(raw);
  }
  template <class Number>
  double finite() {
    const auto value = static_cast<double>(number<Number>());
    if (!std::isfinite(value)) refuse("finite number");
    return value;
  }

  [[noreturn]] void refuse(const std::string& rule) const {
    throw InvalidInput(name_ + ": byte " + std::to_string(began_), rule);
  }

 private:
  std::string name_;
  std::string_view all_;
  std::endian order_;
  std::size_t at_, began_;
};

}  // namespace touchstone::audit::meshes
