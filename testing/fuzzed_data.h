// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdio>
#include <cstdlib>

#include "testing/asked.h"

/// Questions from libFuzzer's bytes, in the manner of its FuzzedDataProvider. The first choice is the family and the
/// others the question's parameters, so that degenerate inputs are common; past the end of the bytes every choice is 0.
///
///   extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t size) {
///     touchstone::tests::FuzzedData data(bytes, size);
///     const auto question = data.question<operations::segment_segment>();
///     if (!question) return -1;                          // outside the contract: not for the corpus
///     const auto& [a, b] = *question;
///     if (my::segments_meet(a, b) != ...) fail(*question);
///     return 0;
///   }
namespace touchstone::tests {

class FuzzedData {
 public:
  /// Does not copy the bytes.
  FuzzedData(const std::uint8_t* bytes, std::size_t size) : draws_(DrawStream::replayed({bytes, size})) {}

  /// Returns the next question; nullopt if it is outside the operation's contract or of another alternative.
  /// TOUCHSTONE_ENGINE_FUZZ reads the same bytes as a single question.
  template <class Row, class... Ts>
  std::optional<Asked<Row, Ts...>> question() {
    const Operation& operation = operation_of<Row>();
    const std::size_t family = draws_.below(operation.families().size());
    Drawn drawn{&operation, family, {}, operation.draw(draws_, family)};
    if (!is_valid(drawn)) return std::nullopt;
    return typed<Row, Ts...>(std::move(drawn));
  }

  /// 0 <= result < n, n >= 1. For anything else that the test draws.
  std::uint64_t below(std::uint64_t n) { return draws_.below(n); }

 private:
  DrawStream draws_;
};

/// Prints the question and the command that asks for the truth, and aborts; libFuzzer keeps the input as a crash.
template <class Row, class... Ts>
[[noreturn]] void fail(const Asked<Row, Ts...>& asked, const std::string& remark = "") {
  std::fprintf(stderr, "%s%s%s\n", remark.c_str(), remark.empty() ? "" : "\n", shown(asked).c_str());
  std::abort();
}

}  // namespace touchstone::tests
