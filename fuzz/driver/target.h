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
/// The first byte picks a family of inputs and the rest are its draws; a byte beyond the families means that the rest
/// are the numbers and words themselves in canonical order, each a raw little-endian double, and 0xff that those
/// numbers which are not finite are made so: refusals tell little, and are exceptions, which cost more than answers.
/// Bytes that are missing are 0.
namespace touchstone::fuzz {

using catalogue::Question;
using Bytes = std::span<const std::uint8_t>;

inline constexpr std::uint8_t finite_numbers_follow = 0xff, any_numbers_follow = 0xfe;

class Target {
 public:
  explicit Target(const catalogue::Operation& operation) : operation_(operation) {}
  const catalogue::Operation& operation() const { return operation_; }

  /// Asks everybody, judges, and returns what is wrong ("" where nothing is).
  std::string complaint(Bytes data) const;
  /// The question in decimal, in hexadecimal, and the command that asks it again.
  std::string shown(Bytes data) const;
  void decode(Bytes data, Question& question) const;
  /// Seeds of a corpus by name: one for every hard case.
  std::vector<std::pair<std::string, std::vector<std::uint8_t>>> seeds() const;

 private:
  std::string judged(const Question& question, std::uint64_t hash) const;

  const catalogue::Operation& operation_;
};

/// The target of this process.
const Target& target();
/// Takes the operation from the program's name or, taking it away, from its first argument; ends the program where
/// neither names one.
void choose_target(int& argc, char** argv);

/// The bytes that mean this question; and the question of bytes after the first, whatever they are.
void encode(const catalogue::Shape& shape, const Question& question, std::vector<std::uint8_t>& data);
void decode(const catalogue::Shape& shape, Bytes rest, bool make_finite, Question& question);

/// How near the deciding quantity came to a change of answer is news to libFuzzer, as a branch that was not taken
/// before would be.
void report_margin(const mpq_class& margin, int degree, std::span<const double> numbers, std::size_t outcome);

/// Our own mutation: a pure function of the bytes and the seed. False where the bytes themselves should be mutated.
bool mutated(Bytes data, unsigned seed, std::vector<std::uint8_t>& result);

}  // namespace touchstone::fuzz
