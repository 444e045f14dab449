// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "catalogue/operation/operation.h"

/// One operation of the catalogue, asked by bytes.
///
/// The first byte picks a family of inputs and the rest are its draws. A first byte beyond the families means that the
/// rest are the numbers and enumerators in canonical order, each a raw little-endian double. 0xff means the same, with
/// numbers that are not finite made finite: refusals reveal little, and they are exceptions, which cost more than
/// answers. Missing bytes are 0.
namespace touchstone::fuzz {

using catalogue::Question;
using Bytes = std::span<const std::uint8_t>;

inline constexpr std::uint8_t finite_numbers_follow = 0xff, any_numbers_follow = 0xfe;

class Target {
 public:
  explicit Target(const catalogue::Operation& operation) : operation_(operation) {}
  const catalogue::Operation& operation() const { return operation_; }

  /// Asks every implementation, judges the answers, and returns the first complaint ("" if there is none).
  std::string complaint(Bytes data) const;
  /// Prints the question in decimal and in hexadecimal, and the command that asks it again.
  std::string shown(Bytes data) const;
  void decode(Bytes data, Question& question) const;
  /// The seeds of a corpus by name: one for each hard case.
  std::vector<std::pair<std::string, std::vector<std::uint8_t>>> seeds() const;

 private:
  std::string judged(const Question& question, std::uint64_t hash) const;

  const catalogue::Operation& operation_;
};

/// The fuzz target of this process.
const Target& target();
/// Takes the operation from the program's name, or from its first argument, which it then removes; ends the program if
/// neither names one.
void choose_target(int& argc, char** argv);

/// Encodes a question as bytes; and decodes any bytes after the first as a question.
void encode(const catalogue::Shape& shape, const Question& question, std::vector<std::uint8_t>& data);
void decode(const catalogue::Shape& shape, Bytes rest, bool make_finite, Question& question);

/// Reports to libFuzzer how near the deciding quantity came to a change of answer: a new degree counts as coverage,
/// like a branch not taken before.
void report_margin(const mpq_class& margin, int degree, std::span<const double> numbers, std::size_t outcome);

/// Our own mutation: a pure function of the bytes and the seed. Returns false if the bytes themselves should be
/// mutated.
bool mutated(Bytes data, unsigned seed, std::vector<std::uint8_t>& result);

}  // namespace touchstone::fuzz
