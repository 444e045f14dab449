// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "catalogue/families/draw_stream.h"
#include "geometry/int128.h"

/// Numbers so near to the middle between two doubles that only their last digits tell on which side they lie.
namespace touchstone::catalogue {

/// t v + rest is 2^51 times an odd integer of 54 digits, and one more or less: 2^-104 of it from a tie. All three
/// are integers.
struct NearTie {
  double t, v, rest;
};

inline NearTie near_tie(DrawStream& draws) {
  using Wide = Int128;
  const std::uint64_t half = std::uint64_t{1} << 52;
  const auto t = static_cast<std::int64_t>(half + draws.below(half));
  const Wide tie = (static_cast<Wide>(2 * (half + draws.below(half)) + 1)) << 51;
  const auto v = static_cast<std::int64_t>(tie / t);
  const Wide rest = tie - static_cast<Wide>(t) * v + (draws.coin() ? -1 : 1);  // below t, so of 53 digits
  return {static_cast<double>(t), static_cast<double>(v), static_cast<double>(static_cast<std::int64_t>(rest))};
}

/// way / speed is an odd integer of 54 digits, and one `speed`th more or less: near a halfway case by far less than
/// enclosures can tell. The way is low + high; speed is an integer of 31 digits.
struct WayBesideTie {
  double low, high, speed;
};

inline WayBesideTie way_beside_tie(DrawStream& draws) {
  using Wide = Int128;
  const std::uint64_t half = std::uint64_t{1} << 52, least = std::uint64_t{1} << 30;
  const auto odd = static_cast<Wide>(2 * (half + draws.below(half)) + 1);
  const auto speed = static_cast<std::int64_t>(least + draws.below(least));
  const Wide displacement = odd * speed + (draws.coin() ? -1 : 1);
  return {static_cast<double>(static_cast<std::int64_t>(displacement & 0xffffffff)),
          static_cast<double>(static_cast<std::int64_t>(displacement >> 32)) * 0x1p32, static_cast<double>(speed)};
}

/// (2 d q + d + 1) / d is 2 q + 1, an odd integer of 54 digits, and 1 / d more.
struct QuotientNearTie {
  double d, q;
};

inline QuotientNearTie quotient_near_tie(DrawStream& draws) {
  const std::uint64_t least = std::uint64_t{1} << 52, room = std::uint64_t{1} << 50;
  const double q = static_cast<double>(least + draws.below(least - room));
  return {static_cast<double>(room / 2 + draws.below(room / 2)), q};  // d + 1 + q is below 2^53
}

}  // namespace touchstone::catalogue
