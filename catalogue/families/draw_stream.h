// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace touchstone::catalogue {

/// One draw stream, from which every input is drawn. A choice is a number 0 <= k < n and 0 is the simplest, so
/// that a shorter or smaller stream gives a simpler input: shrinking works on the stream and never leaves a family.
///
/// Two sources: a seeded generator (the same on every machine), and bytes (libFuzzer's, RapidCheck's, a crash file's;
/// past their end every choice is 0). A seeded stream that records gives the bytes that repeat it.
class DrawStream {
 public:
  static DrawStream seeded(std::uint64_t seed, bool record = false);
  static DrawStream replayed(std::span<const std::uint8_t> bytes);

  /// 0 <= result < n; n >= 1. Takes 1, 2, 4 or 8 bytes: the least that hold n - 1.
  std::uint64_t below(std::uint64_t n) {
    if (n <= 1) return 0;
    return source_ == Source::seeded && !record_ ? next() % n : recorded_below(n);
  }

  bool one_in(std::uint64_t n) { return below(n) == n - 1; }
  bool coin() { return one_in(2); }
  std::uint64_t any_bits() { return source_ == Source::seeded && !record_ ? next() : recorded_below(0); }

  /// The bytes taken so far by a recording stream.
  const std::vector<std::uint8_t>& recorded() const { return record_bytes_; }

 private:
  enum class Source : std::uint8_t { seeded, bytes };
  std::uint64_t next();
  std::uint64_t recorded_below(std::uint64_t n);

  Source source_ = Source::seeded;
  bool record_ = false;
  std::uint64_t state_ = 0;
  std::span<const std::uint8_t> bytes_;
  std::vector<std::uint8_t> record_bytes_;
};

/// A seed for case `index` of a named stream: the same on every machine, unlike std::hash.
std::uint64_t seed_of(std::uint64_t seed, const char* name, std::uint64_t index);

}  // namespace touchstone::catalogue
