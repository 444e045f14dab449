// SPDX-License-Identifier: Apache-2.0
#include "geometry/two_words.h"

#include <limits>

#include "catalogue/families/draw_stream.h"
#include "proptests/catch.h"

#ifdef __SIZEOF_INT128__
namespace touchstone::proptests::two_words_tests {
namespace {

using catalogue::DrawStream;
using Signed = TwoWords<true>;
using Unsigned = TwoWords<false>;
__extension__ using Int128 = __int128;
__extension__ using UInt128 = unsigned __int128;

/// Draws any bits, few digits, few zeros or one digit.
UInt128 drawn(DrawStream& draws) {
  const UInt128 high = draws.any_bits(), any = high << 64 | draws.any_bits();
  const auto places = static_cast<int>(draws.below(128));
  switch (draws.below(4)) {
    case 0: return any;
    case 1: return any >> places;
    case 2: return ~(any >> places);
    default: return UInt128{1} << places;
  }
}

Unsigned in_words(UInt128 n) {
  return Unsigned(static_cast<std::uint64_t>(n >> 64)) << 64 | static_cast<std::uint64_t>(n);
}
UInt128 in_one(const Unsigned& n) {
  return static_cast<UInt128>(static_cast<std::uint64_t>(n >> 64)) << 64 | static_cast<std::uint64_t>(n);
}

bool same(const Unsigned& ours, UInt128 builtin) { return in_one(ours) == builtin; }
bool same(const Signed& ours, Int128 builtin) { return in_one(Unsigned(ours)) == static_cast<UInt128>(builtin); }

/// Compares the operators that never overflow.
template <class Words, class Builtin>
bool compared_alike(const Words& p, const Words& q, Builtin a, Builtin b, int places) {
  return (p < q) == (a < b) && (p > q) == (a > b) && (p == q) == (a == b) && same(p & q, a & b) && same(p | q, a | b) &&
         same(p ^ q, a ^ b) && same(~p, ~a) && same(p >> places, a >> places);
}
template <class Words, class Builtin>
bool divided_alike(const Words& p, const Words& q, Builtin a, Builtin b) {
  return same(p / q, a / b) && same(p % q, a % b);
}

}  // namespace

TEST_CASE("two words: every operator gives what the compiler's integers of 128 bits give") {
  DrawStream draws = DrawStream::seeded(20261129);
  int wrong = 0;
  for (int i = 0; i < 200000; ++i) {
    const UInt128 a = drawn(draws), b = drawn(draws);
    const auto c = static_cast<Int128>(a), d = static_cast<Int128>(b);
    const Unsigned p = in_words(a), q = in_words(b);
    const Signed r(p), s(q);
    const auto places = static_cast<int>(draws.below(128));
    wrong += !compared_alike(p, q, a, b, places) || !compared_alike(r, s, c, d, places);
    wrong += !same(p + q, a + b) || !same(p - q, a - b) || !same(p * q, a * b) || !same(-p, -a);
    wrong += !same(p << places, a << places);
    // Signed and unsigned results have the same bits.
    wrong += in_one(Unsigned(r + s)) != a + b || in_one(Unsigned(r - s)) != a - b || in_one(Unsigned(r * s)) != a * b;
    wrong += in_one(Unsigned(-r)) != -a || in_one(Unsigned(r << places)) != a << places;
    if (b == 0) continue;
    wrong += !divided_alike(p, q, a, b);
    if (d != -1) wrong += !divided_alike(r, s, c, d);
  }
  CHECK(wrong == 0);
}

TEST_CASE("two words: narrower integers become the same number, and words are cut off from the top") {
  constexpr auto least = std::numeric_limits<std::int64_t>::min();
  CHECK(same(Signed(least), Int128{least}));
  CHECK(same(Unsigned(-1), static_cast<UInt128>(-1)));
  CHECK(same(Signed(~std::uint64_t{0}), Int128{~std::uint64_t{0}}));
  CHECK(same(Unsigned(Signed(-5)), static_cast<UInt128>(-5)));
  CHECK(static_cast<std::int64_t>(Signed(least) * 2 - 3) == -3);
  CHECK(static_cast<bool>(Unsigned(1) << 127));
  CHECK_FALSE(static_cast<bool>(Signed(0)));
}

}  // namespace touchstone::proptests::two_words_tests
#endif
