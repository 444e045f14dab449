// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <utility>
#include <vector>

/// What a fuzz target is to the driver: one operation of the catalogue, asked by bytes.
///
/// The first byte picks a family of inputs and the rest are its choices; a byte beyond the families means that the rest are the numbers
/// themselves, as raw little-endian doubles, and 0xff that those of them which are not finite are made so: refusals tell little, and are
/// exceptions, which cost more than answers. Bytes that are missing are 0.
namespace touchstone::fuzz {

using Bytes = std::span<const std::uint8_t>;

/// Which of the numbers of a question are what: lists are preceded by their length.
struct Layout {
  struct Point {
    std::size_t first, dimension;  ///< its coordinates are numbers first .. first + dimension - 1
  };
  struct List {
    std::size_t length, element;  ///< place of the length, numbers of one element; the elements follow the length
  };
  std::vector<std::size_t> coordinates;
  std::vector<Point> points;
  std::vector<List> lists;
};

class Target {
 public:
  virtual ~Target() = default;

  /// Asks everybody, judges, and returns what is wrong ("" where nothing is).
  virtual std::string complaint(Bytes data) const = 0;
  /// The question in decimal, in hexadecimal, and the command that asks it again.
  virtual std::string shown(Bytes data) const = 0;

  /// The first byte of a question of a family is less than this.
  virtual std::size_t families() const = 0;
  virtual void decode(Bytes data, std::vector<double>& numbers) const = 0;
  /// The layout of numbers that `decode` gave; good until the next call.
  virtual const Layout& layout(const std::vector<double>& numbers) const = 0;
  /// Seeds of a corpus by name: one for every hard case.
  virtual std::vector<std::pair<std::string, std::vector<std::uint8_t>>> seeds() const = 0;
};

/// The target of this program; TOUCHSTONE_FUZZ defines it.
const Target& target();

inline constexpr std::uint8_t finite_numbers_follow = 0xff, any_numbers_follow = 0xfe;

/// The bytes that mean these numbers.
void encode(const std::vector<double>& numbers, std::vector<std::uint8_t>& data);

/// Our own mutation: a pure function of the bytes and the seed. False where the bytes themselves should be mutated.
bool mutated(Bytes data, unsigned seed, std::vector<std::uint8_t>& result);

}  // namespace touchstone::fuzz
