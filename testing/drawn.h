// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <cstdint>
#include <string>
#include <utility>
#include <vector>

#include "catalogue/operation/operation.h"

/// Questions of the catalogue with the draws that produce them, for any test framework.
namespace touchstone::tests {

using catalogue::DrawStream;
using catalogue::Operation;

/// A question and the draws that produce it. Shrinking works on the draws, so that a shrunk question stays in its
/// family.
struct Drawn {
  const Operation* operation = nullptr;
  std::size_t family = 0;
  std::vector<std::uint8_t> draws;
  catalogue::Question question;
};

inline Drawn replayed(const Operation& operation, std::size_t family, std::vector<std::uint8_t> bytes) {
  DrawStream draws = DrawStream::replayed(bytes);
  catalogue::Question question = operation.draw(draws, family);
  return {&operation, family, std::move(bytes), std::move(question)};
}

/// Records the draws of a seed.
inline Drawn recorded(const Operation& operation, std::size_t family, std::uint64_t seed) {
  DrawStream draws = DrawStream::seeded(seed, true);
  catalogue::Question question = operation.draw(draws, family);
  return {&operation, family, draws.recorded(), std::move(question)};
}

/// Returns whether the question is within the operation's contract: families also draw what `robust` refuses.
inline bool is_valid(const Drawn& drawn) {
  try {
    drawn.operation->row().robust(drawn.question, 0);
    return true;
  } catch (const InvalidInput&) {
    return false;
  }
}

/// Prints operation and family, the question in decimal and in hexadecimal, and the command that asks it.
inline std::string shown(const Drawn& drawn) {
  const std::string name = drawn.operation->name();
  const std::string exact = catalogue::one_line(drawn.operation->print_hexadecimal(drawn.question));
  return name + ", family " + drawn.operation->families()[drawn.family] + '\n' +
         catalogue::one_line(drawn.operation->print(drawn.question)) + '\n' + exact + "\necho '" + exact +
         "' | touchstone ask " + name + " -";
}

/// Returns simpler draw streams: shorter ones first, then those with smaller bytes.
inline std::vector<std::vector<std::uint8_t>> simpler(const std::vector<std::uint8_t>& bytes) {
  std::vector<std::vector<std::uint8_t>> found;
  for (std::size_t length = bytes.size(); length > 0; length /= 2) {
    for (std::size_t at = 0; at + length <= bytes.size(); at += length) {
      const auto first = bytes.begin() + static_cast<std::ptrdiff_t>(at),
                 last = first + static_cast<std::ptrdiff_t>(length);
      std::vector<std::uint8_t> cut(bytes.begin(), first);
      cut.insert(cut.end(), last, bytes.end());
      found.push_back(std::move(cut));
      if (std::all_of(first, last, [](std::uint8_t byte) { return byte == 0; })) continue;
      std::vector<std::uint8_t> zeroed = bytes;
      std::fill_n(zeroed.begin() + static_cast<std::ptrdiff_t>(at), length, std::uint8_t{0});
      found.push_back(std::move(zeroed));
    }
  }
  for (std::size_t at = 0; at < bytes.size(); ++at) {
    for (const int lessened : {bytes[at] / 2, bytes[at] - 2, bytes[at] - 1}) {
      if (lessened <= 0 || lessened >= bytes[at]) continue;
      found.push_back(bytes);
      found.back()[at] = static_cast<std::uint8_t>(lessened);
    }
  }
  return found;
}

}  // namespace touchstone::tests
