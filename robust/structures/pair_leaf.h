// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>
#include <cstring>
#include <limits>

#include "geometry/volumes.h"
#include "robust/kernel/filters/ordered_bits.h"
#include "robust/kernel/filters/processor.h"

/// Eight boxes compared with a ninth at once, by coarse integers that keep the order of the coordinates.
namespace touchstone::robust::structures {

/// The upper half of the bits of a coordinate's difference from an origin, which rounding keeps in order: a coordinate
/// that is not greater than another never has the greater integer, and one with the smaller integer is smaller.
struct Coarse {
  std::array<double, 3> origin{};

  std::int32_t operator()(double value, std::size_t axis) const {
    return static_cast<std::int32_t>(kernel::ordered_bits(value - origin[axis]) >> 32);
  }
};

struct CoarseBox {
  std::array<std::int32_t, 3> low, high;
};

struct alignas(16) PairLeaf {
  static constexpr std::size_t places = 8;
  static constexpr std::int32_t least = std::numeric_limits<std::int32_t>::min(), most = ~least;

  std::array<std::array<std::int32_t, places>, 3> low, high;  ///< a free place meets nothing
  std::array<Index, places> body{};
  CoarseBox around{{most, most, most}, {least, least, least}};

  PairLeaf() {
    for (auto& ends : low) ends.fill(most);
    for (auto& ends : high) ends.fill(least);
  }
  CoarseBox box(std::size_t place) const {
    return {{low[0][place], low[1][place], low[2][place]}, {high[0][place], high[1][place], high[2][place]}};
  }
};

/// A bit for each place: set if a[k] > b.
class Bits {
 public:
  void add_where_greater(const std::array<std::int32_t, 8>& a, std::int32_t b) {
    const Half all{b, b, b, b};
    first_ |= reinterpret_cast<Found>(half(a, 0) > all);
    second_ |= reinterpret_cast<Found>(half(a, 4) > all);
  }
  void add_where_less(const std::array<std::int32_t, 8>& a, std::int32_t b) {
    const Half all{b, b, b, b};
    first_ |= reinterpret_cast<Found>(all > half(a, 0));
    second_ |= reinterpret_cast<Found>(all > half(a, 4));
  }
  unsigned mask() const { return kernel::processor::signs(first_) | kernel::processor::signs(second_) << 4; }

 private:
  using Half = kernel::processor::FourIntegers;
  using Found = kernel::processor::TwoBits;  // g++ 12 copies less than with four
  static Half half(const std::array<std::int32_t, 8>& a, std::size_t from) {
    Half four;
    std::memcpy(&four, __builtin_assume_aligned(a.data() + from, alignof(Half)), sizeof four);
    return four;
  }
  Found first_{}, second_{};
};

/// The places of a leaf whose boxes may meet a box; the others certainly do not.
inline unsigned may_meet(const PairLeaf& leaf, const CoarseBox& box) {
  Bits apart;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    apart.add_where_greater(leaf.low[axis], box.high[axis]);
    apart.add_where_less(leaf.high[axis], box.low[axis]);
  }
  return ~apart.mask() & 0xffU;
}

/// The places of a leaf whose boxes do meet it unless the coarse integers separate them.
inline unsigned surely_meet_or_apart(const PairLeaf& leaf, const CoarseBox& box) {
  unsigned surely = 0xffU;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    Bits below, above;
    below.add_where_less(leaf.low[axis], box.high[axis]);
    above.add_where_greater(leaf.high[axis], box.low[axis]);
    surely &= below.mask() & above.mask();
  }
  return surely;
}

}  // namespace touchstone::robust::structures
