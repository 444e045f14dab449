// SPDX-License-Identifier: Apache-2.0
#include "report/palette.h"

#include <fmt/format.h>

#include <algorithm>

namespace touchstone::audit {
namespace {

constexpr std::array<Colour, verdict_count> verdict_colours{{{0xa9, 0xba, 0xc6},    // agree
                                                             {0xe0, 0x7b, 0x12},    // rounding
                                                             {0x6a, 0x2c, 0x91},    // algorithm
                                                             {0x0f, 0x8b, 0x8d},    // inexact
                                                             {0x5a, 0xa9, 0xe6},    // convention
                                                             {0xd8, 0xc3, 0x5a},    // tolerance
                                                             {0x2b, 0x2b, 0x2b},    // invalid
                                                             {0xd5, 0xd5, 0xd5}}};  // unsupported

constexpr std::array<Colour, 4> tints{{{0xd9, 0xe6, 0xf2}, {0xf4, 0xec, 0xd8}, {0x55, 0x68, 0x7a}, {0xd6, 0xe8, 0xd8}}};

std::uint8_t mixed(std::uint8_t from, int to, int percent) {
  return static_cast<std::uint8_t>((from * (100 - percent) + to * percent) / 100);
}

Colour mixed(const Colour& from, int to, int percent) {
  return {mixed(from.red, to, percent), mixed(from.green, to, percent), mixed(from.blue, to, percent)};
}

}  // namespace

Colour colour_of(Verdict verdict) { return verdict_colours[static_cast<std::size_t>(verdict)]; }

Colour map_colour(Verdict verdict, std::size_t rank) {
  if (verdict == Verdict::agree) return tints[rank % tints.size()];
  // A number a little off is no wrong decision, and covers whole maps: it is to be seen, not to shout.
  if (verdict == Verdict::inexact) return mixed(colour_of(verdict), 255, rank % 4 == 0 ? 70 : rank % 4 == 1 ? 55 : 40);
  switch (rank % 4) {
    case 0: return mixed(colour_of(verdict), 255, 35);
    case 1: return mixed(colour_of(verdict), 0, 30);
    case 3: return mixed(colour_of(verdict), 255, 65);
    default: return colour_of(verdict);
  }
}

Colour distance_colour(Verdict verdict, std::size_t decade) {
  const int percent = static_cast<int>(decade) * 10;
  if (verdict == Verdict::agree) return mixed(tints[0], 90, std::min(2 * percent, 80));
  return decade < 4 ? mixed(colour_of(verdict), 255, 70 - 2 * percent)
                    : mixed(colour_of(verdict), 0, 11 * (static_cast<int>(decade) - 3));
}

std::string hex_of(const Colour& colour) {
  return fmt::format("#{:02x}{:02x}{:02x}", colour.red, colour.green, colour.blue);
}

}  // namespace touchstone::audit
