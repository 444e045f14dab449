// SPDX-License-Identifier: Apache-2.0
#include <bit>
#include <cmath>
#include <set>
#include <stdexcept>

#include "catalogue/families/numbers.h"
#include "catalogue/operation/probes/shrink.h"
#include "proptests/drawn.h"
#include "proptests/each_operation.h"
#include "proptests/property.h"

namespace touchstone::proptests::draw_stream_tests {
namespace {

using Bytes = std::vector<std::uint8_t>;

std::vector<std::uint64_t> bits_of(const Question& question) {
  std::vector<std::uint64_t> bits;
  for (const double number : question.numbers) bits.push_back(std::bit_cast<std::uint64_t>(number));
  return bits;
}

}  // namespace

// Values from SplitMix64's definition (state += 0x9e3779b97f4a7c15; two xor-multiplies and a xor), computed in Python's
// integers.
TEST_CASE("draws: a seed draws the numbers of SplitMix64") {
  DrawStream zero = DrawStream::seeded(0), one = DrawStream::seeded(1);
  CHECK(zero.any_bits() == 0xe220a8397b1dcdafu);
  CHECK(zero.any_bits() == 0x6e789e6aa1b965f4u);
  CHECK(zero.any_bits() == 0x06c45d188009454fu);
  CHECK(one.any_bits() == 0x910a2dec89025cc1u);
  CHECK(one.any_bits() == 0xbeeb8da1658eec67u);
  CHECK(one.any_bits() == 0xf893a2eefb32555eu);
}

TEST_CASE("draws: below(n) is the draw modulo n, recording or not") {
  for (const bool record : {false, true}) {
    DrawStream one = DrawStream::seeded(1, record);
    CHECK(one.below(2) == 1);
    CHECK(one.below(10) == 9);
    CHECK(one.below(1000) == 590);
    CHECK(one.below(1) == 0);  // draws nothing
    CHECK(one.below(std::uint64_t{1} << 20) == 182539);
    CHECK(one.below(std::uint64_t{1} << 40) == 931219486137);
    CHECK(one.below(17) == 0);
  }
}

TEST_CASE("draws: single numbers drawn from a seed") {
  DrawStream one = DrawStream::seeded(1), five = DrawStream::seeded(5), seven = DrawStream::seeded(7);
  CHECK(catalogue::ordinary(one) == -0x1.7484ddbf68cfcp-2);
  CHECK(catalogue::small_integer(five) == -5);
  CHECK(catalogue::any_finite(seven) == 0x1.be1e459320dd7p+573);
  CHECK(catalogue::seed_of(1, "", 0) == 0xdce423fc82c0d5b8u);
  CHECK(catalogue::seed_of(1, "orientation/grid", 7) == 0xfe27add3d399d2deu);
}

TEST_CASE("draws: a replayed choice takes the least bytes that hold it, little end first; past the end it is 0") {
  const Bytes bytes{200, 1, 2, 1, 0, 0, 0, 9, 9, 0, 0, 0, 0, 0, 1, 77};
  DrawStream draws = DrawStream::replayed(bytes);
  CHECK(draws.below(256) == 200);
  CHECK(draws.below(65536) == 1 + 256 * 2);
  CHECK(draws.below(std::uint64_t{1} << 32) == 1);
  CHECK(draws.below(1) == 0);
  CHECK(draws.any_bits() == 9 + 256 * 9 + (std::uint64_t{1} << 56));
  CHECK(draws.below(257) == 77);  // one of its two bytes is there
  CHECK(draws.below(10) == 0);
  CHECK(draws.any_bits() == 0);
}

TEST_CASE("draws: below stays below, one_in is its last choice") {
  for (std::uint64_t i = 0; i < 20000; ++i) {
    DrawStream outer = DrawStream::seeded(catalogue::seed_of(3, "below", i), true);
    const std::uint64_t n = 1 + outer.below(std::uint64_t{1} << (1 + outer.below(60)));
    if (outer.below(n) >= n) FAIL("below(" << n << ")");
  }
  const Bytes bytes{0, 1, 2};
  DrawStream draws = DrawStream::replayed(bytes);
  CHECK_FALSE(draws.one_in(3));
  CHECK_FALSE(draws.one_in(3));
  CHECK(draws.one_in(3));
}

TEST_CASE("draws: numbers stay in their ranges") {
  std::set<double> small;
  for (std::uint64_t i = 0; i < 20000; ++i) {
    DrawStream draws = DrawStream::seeded(catalogue::seed_of(4, "ranges", i));
    const double n = catalogue::integer(draws, 20), x = catalogue::ordinary(draws), any = catalogue::any_finite(draws);
    if (n != std::trunc(n) || std::fabs(n) >= 0x1p20) FAIL("integer " << n);
    if (!(x >= -1 && x < 1) || x * 0x1p52 != std::trunc(x * 0x1p52)) FAIL("ordinary " << x);
    if (!std::isfinite(any) || !std::isfinite(catalogue::mixed_exponent(draws)) ||
        !std::isfinite(catalogue::typed(draws)))
      FAIL("not finite");
    const double moved = catalogue::moved_by_ulps(any, 3);
    if (std::fabs(any) < 1e300 && catalogue::moved_by_ulps(moved, -3) != any) FAIL("moved " << any);
    small.insert(catalogue::small_integer(draws, 2));
  }
  CHECK(small == std::set<double>{-2, -1, 0, 1, 2});
  CHECK(catalogue::moved_by_ulps(0, -1) == -5e-324);
  CHECK(catalogue::moved_by_ulps(-5e-324, 2) == 5e-324);
  CHECK(catalogue::moved_by_ulps(0x1.fffffffffffffp+1023, 5) == 0x1.fffffffffffffp+1023);
}

EACH_OPERATION("recorded bytes replay to the same question, and recording changes nothing") {
  for (std::size_t family = 0; family < operation.families().size(); ++family) {
    INFO(operation.families()[family]);
    for (int i = 0; i < scaled(200); ++i) {
      const std::uint64_t seed = catalogue::seed_of(5, operation.families()[family].c_str(), i);
      DrawStream plain = DrawStream::seeded(seed);
      const Drawn drawn = recorded(operation, family, seed);
      const auto bits = bits_of(drawn.question);
      if (bits_of(operation.draw(plain, family)) != bits) FAIL("recording changes the question of seed " << seed);
      if (bits_of(replayed(operation, family, drawn.draws).question) != bits)
        FAIL("the bytes of seed " << seed << " give another question");
    }
  }
}

EACH_OPERATION("any bytes give finite numbers in every family, and no bytes the simplest") {
  for (std::size_t family = 0; family < operation.families().size(); ++family) {
    const Question none = replayed(operation, family, {}).question;
    CHECK(bits_of(none) == bits_of(replayed(operation, family, Bytes(200, 0)).question));
    for (int i = 0; i < scaled(50); ++i) {
      DrawStream draws = DrawStream::seeded(catalogue::seed_of(6, "bytes", i));
      Bytes bytes(draws.below(40));
      for (auto& byte : bytes) byte = static_cast<std::uint8_t>(draws.below(256));
      const Question question = replayed(operation, family, bytes).question;
      if (operation.question_shape().fixed) {  // no lists
        CHECK(question.numbers.size() == operation.zeros().numbers.size());
      }
      for (const double number : question.numbers) {
        if (!std::isfinite(number)) FAIL("not finite in " << operation.families()[family]);
      }
    }
  }
}

TEST_CASE("shrinking: the predicate holds of the result, which is the simplest of its kind") {
  using catalogue::shrunk;
  CHECK(shrunk({7, 200, 3, 40}, [](const Bytes&) { return true; }) == Bytes{});
  CHECK(shrunk({7, 200, 3, 40}, [](const Bytes& b) {
          return std::any_of(b.begin(), b.end(), [](int x) { return x >= 10; });
        }) == Bytes{10});
  CHECK(shrunk({9, 9, 5, 9}, [](const Bytes& b) { return b.size() > 2 && b[2] == 5; }) == Bytes{0, 0, 5});
  CHECK(shrunk({9, 4, 100, 6, 251}, [](const Bytes& b) {
          return std::count_if(b.begin(), b.end(), [](int x) { return x >= 3; }) >= 2;
        }) == Bytes{3, 3});
  CHECK(shrunk({1, 2}, [](const Bytes& b) { return b == Bytes{1, 2}; }) == Bytes{1, 2});
}

TEST_CASE("shrinking: it asks no more often than its budget, and the same question always ends the same") {
  for (const int budget : {0, 1, 7, 50}) {
    int asked = 0;
    const auto big = [&](const Bytes& b) { return ++asked, b.size() >= 2 && b[0] + b[1] > 100; };
    const Bytes first = catalogue::shrunk(Bytes(60, 255), big, budget);
    CHECK(asked <= budget);
    CHECK(big(first));
    CHECK(catalogue::shrunk(Bytes(60, 255), big, budget) == first);
  }
}

EACH_OPERATION("a shrunk question stays in its family: a refused or degenerate one stays so") {
  // The property of the first family: its outcome is kept while its bytes become fewer.
  const Drawn start = recorded(operation, 0, 99);
  const std::string outcome = operation.examine(start.question)->outcome();
  const auto same_outcome = [&](const Bytes& bytes) {
    try {
      return operation.examine(replayed(operation, 0, bytes).question)->outcome() == outcome;
    } catch (const InvalidInput&) {
      return false;
    }
  };
  const Bytes end = catalogue::shrunk(start.draws, same_outcome);
  CHECK(same_outcome(end));
  CHECK(end.size() <= start.draws.size());
}

EACH_OPERATION("no two families have one name, as questions are drawn by names") {
  catalogue::RowFunctions row = operation.row();
  CHECK_NOTHROW(catalogue::Families(row));
  row.hard_cases.push_back({"typed", true});  // which follows from the types, too
  CHECK_THROWS_AS(catalogue::Families(row), std::logic_error);
}

}  // namespace touchstone::proptests::draw_stream_tests
