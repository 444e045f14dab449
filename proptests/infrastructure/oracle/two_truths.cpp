// SPDX-License-Identifier: Apache-2.0
#include <cstdint>

#include "catalogue/families/draw_stream.h"
#include "oracle/lines/orientation.h"
#include "oracle/lines/ray_segment.h"
#include "oracle/lines/segment_segment.h"
#include "proptests/catch.h"

namespace touchstone::proptests::two_truths_tests {
namespace {

using namespace oracle;
using catalogue::DrawStream;

/// Every pair of segments with all ends on a side x side grid of integers.
std::int64_t differences(int side, std::int64_t (&seen)[3]) {
  const int points = side * side;
  std::int64_t different = 0;
  const auto integer = [side](int i) { return Point2<std::int64_t>{i % side, i / side}; };
  const auto real = [side](int i) { return Point2d{static_cast<double>(i % side), static_cast<double>(i / side)}; };
  for (int i = 0; i < points * points; ++i) {
    for (int k = 0; k < points * points; ++k) {
      const Segment2d a{real(i / points), real(i % points)}, b{real(k / points), real(k % points)};
      const auto program = segment_segment(a, b).answer.relation;
      const auto elimination =
          segment_segment_relation<std::int64_t>(Segment2<std::int64_t>{integer(i / points), integer(i % points)},
                                                 Segment2<std::int64_t>{integer(k / points), integer(k % points)});
      different += program != elimination || program != segment_segment_relation(a, b);
      ++seen[static_cast<int>(program)];
    }
  }
  return different;
}

/// A whole number just within, or anywhere within, so many bits; beyond 53 of them the last ones are 0.
double within_bits(DrawStream& draws, int bits) {
  const std::int64_t most = (std::int64_t{1} << (bits < 53 ? bits : 53)) - 1;
  const std::int64_t less = draws.below(2) == 0 ? static_cast<std::int64_t>(draws.below(3))
                                                : static_cast<std::int64_t>(draws.any_bits() >> 1) % most;
  const auto size = static_cast<double>(most - less);
  const double scaled =
      bits > 53 && draws.below(2) == 0 ? size * static_cast<double>(std::int64_t{1} << (bits - 53)) : size;
  return draws.below(2) == 0 ? scaled : -scaled;
}

}  // namespace

TEST_CASE("segment_segment: linear program and elimination agree on the whole 3x3 and 4x4 grids") {
  for (const int side : {3, 4}) {
    std::int64_t seen[3] = {};
    CHECK(differences(side, seen) == 0);
    CHECK(seen[0] + seen[1] + seen[2] ==
          static_cast<std::int64_t>(side) * side * side * side * side * side * side * side);
    for (const std::int64_t count : seen) CHECK(count > 0);
  }
}

TEST_CASE("segment_segment, orientation: both truths agree where the integers stop to fit a word or two") {
  DrawStream draws = DrawStream::seeded(20240606);
  int different = 0, seen[3] = {};
  for (const int bits : {26, 27, 28, 29, 52, 53, 54, 59, 60, 61, 62, 63, 64, 100}) {
    for (int i = 0; i < 1500; ++i) {
      const auto point = [&] {
        const double x = within_bits(draws, bits);
        return Point2d{x, within_bits(draws, bits)};
      };
      Segment2d a{point(), point()}, b{point(), point()};
      const auto form = draws.below(6);
      if (form == 0) b = {a.b, a.a};
      if (form == 1) b.a = a.b;
      if (form == 2) b.b = b.a = a.a;
      const auto program = segment_segment(a, b).answer.relation;
      different += program != segment_segment_relation(a, b);
      different += orientation(a.a, a.b, b.b).answer != orientation_side(a.a, a.b, b.b);
      ++seen[static_cast<int>(program)];
    }
  }
  CHECK(different == 0);
  for (const int count : seen) CHECK(count > 1000);
}

}  // namespace touchstone::proptests::two_truths_tests
