// SPDX-License-Identifier: Apache-2.0
#include "report/maps/palette.h"

#include <fmt/format.h>

#include <algorithm>

namespace touchstone::report {
namespace {

struct Colours {
  std::array<Colour, verdict_count> verdicts;
  Colour range;
  Colour hatch, line;  ///< on right answers
  Colour blank;
  int towards;  ///< the colour mixed into strong ones: black on paper, white in dark mode
};

constexpr Colours light{{{{0xdf, 0xe8, 0xf0},    // agree
                          {0xcf, 0x5f, 0x00},    // rounding
                          {0x5b, 0x2a, 0x99},    // algorithm
                          {0x0a, 0x7c, 0x80},    // inexact
                          {0x7f, 0xb2, 0xe5},    // convention
                          {0xd9, 0xc5, 0x5c},    // tolerance
                          {0x1f, 0x1f, 0x1f},    // invalid
                          {0xc4, 0xc4, 0xc4}}},  // unsupported
                        {0xb3, 0x12, 0x2f},
                        {0x9f, 0xb4, 0xc6},
                        {0x6f, 0x85, 0x98},
                        {0xff, 0xff, 0xff},
                        0};
constexpr Colours dark{{{{0x25, 0x30, 0x3a},
                         {0xff, 0x9b, 0x3f},
                         {0xb9, 0x8a, 0xf2},
                         {0x2f, 0xc4, 0xc0},
                         {0x3f, 0x74, 0xa8},
                         {0x85, 0x78, 0x39},
                         {0xf5, 0xf5, 0xf5},
                         {0x55, 0x55, 0x55}}},
                       {0xff, 0x5d, 0x6c},
                       {0x52, 0x67, 0x7a},
                       {0x84, 0x98, 0xaa},
                       {0x14, 0x18, 0x1c},
                       255};

const Colours& colours_of(Scheme scheme) { return scheme == Scheme::light ? light : dark; }

std::uint8_t mixed(std::uint8_t from, int to, int percent) {
  return static_cast<std::uint8_t>((from * (100 - percent) + to * percent) / 100);
}

Colour mixed(const Colour& from, int to, int percent) {
  return {mixed(from.red, to, percent), mixed(from.green, to, percent), mixed(from.blue, to, percent)};
}

}  // namespace

Colour colour_of(Verdict verdict, Scheme scheme) {
  return colours_of(scheme).verdicts[static_cast<std::size_t>(verdict)];
}
Colour range_colour(Scheme scheme) { return colours_of(scheme).range; }
Colour blank_colour(Scheme scheme) { return colours_of(scheme).blank; }

bool Look::marked(std::size_t column, std::size_t row) const {
  switch (pattern) {
    case Pattern::plain: return false;
    case Pattern::hatch: return (column + row) % 6 < 2;
    case Pattern::counter_hatch: return (column + 6 * 256 - row) % 6 < 2;
    case Pattern::dots: return column % 4 < 2 && row % 4 < 2;
    case Pattern::bars: return row % 5 < 2;
  }
  return false;
}

Look look_of(Verdict verdict, const Rank& rank, Scheme scheme) {
  const Colours& colours = colours_of(scheme);
  const Colour own = colour_of(verdict, scheme);
  constexpr std::size_t patterns = 5;
  const auto pattern = [](std::size_t place) { return static_cast<Look::Pattern>(place % patterns); };
  if (verdict == Verdict::agree)
    return rank.rare ? Look{colours.line, mixed(colours.line, 255 - colours.towards, 35), pattern(rank.place)}
                     : Look{own, colours.hatch, pattern(rank.place)};
  // Neither the ground nor the mark of a finding is ever pale. A rare truth is most often a wrong answer: plain.
  return {own, mixed(own, colours.towards, 45), pattern(rank.rare ? 0 : rank.place + 1)};
}

Look look_of_distance(std::size_t level, Verdict verdict, Scheme scheme) {
  // Each differs from its neighbours in lightness, increasing the contrast with the page.
  constexpr std::array<Colour, distance_levels> on_paper{{{0x8f, 0x7a, 0x00},
                                                          {0x66, 0x77, 0x00},
                                                          {0x24, 0x6b, 0x3f},
                                                          {0x0a, 0x5a, 0x68},
                                                          {0x1f, 0x3f, 0x8a},
                                                          {0x3a, 0x24, 0x80},
                                                          {0x2c, 0x0a, 0x4a}}},
      in_the_dark{{{0x6f, 0x7f, 0xd8},
                   {0x4a, 0x9a, 0xe0},
                   {0x2f, 0xb4, 0xc8},
                   {0x3f, 0xc8, 0x96},
                   {0x8c, 0xd8, 0x60},
                   {0xd4, 0xe2, 0x4a},
                   {0xff, 0xf2, 0xa0}}};
  const Colour own = (scheme == Scheme::light ? on_paper : in_the_dark)[std::min(level, distance_levels - 1)];
  if (verdict == Verdict::inexact) return {own, own};
  return {own, colour_of(verdict, scheme), Look::Pattern::hatch};
}

std::string hex_of(const Colour& colour) {
  return fmt::format("#{:02x}{:02x}{:02x}", colour.red, colour.green, colour.blue);
}

}  // namespace touchstone::report
