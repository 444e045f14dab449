// SPDX-License-Identifier: Apache-2.0
#include "robust/kernel/integers/enclosed_angles.h"

#include <mpfr.h>

#include "catalogue/families/numbers.h"
#include "proptests/catch.h"

// Sine, cosine and arc tangent against MPFR with 300 bits: no enclosure misses the truth, and hardly any is too wide to
// round.
namespace touchstone::proptests::enclosed_angles_tests {
namespace {

using namespace robust::kernel;
using catalogue::DrawStream;

class Truth {
 public:
  Truth() { mpfr_init2(value, 300), mpfr_init2(other, 300); }
  ~Truth() { mpfr_clear(value), mpfr_clear(other); }
  Truth(const Truth&) = delete;
  Truth& operator=(const Truth&) = delete;

  mpfr_t value, other;
};

struct Count {
  int asked = 0, given = 0, missed = 0, misrounded = 0, found = 0;
  double farthest = 0;

  void add(const Enclosed<double>& x, Truth& truth) {
    given += 1;
    const double nearest = mpfr_get_d(truth.value, MPFR_RNDN);
    mpfr_sub_d(truth.value, truth.value, x.high, MPFR_RNDN), mpfr_sub_d(truth.value, truth.value, x.low, MPFR_RNDN);
    mpfr_abs(truth.value, truth.value, MPFR_RNDN);
    missed += mpfr_cmp_d(truth.value, x.error) > 0;
    if (x.error > 0) farthest = std::max(farthest, mpfr_get_d(truth.value, MPFR_RNDN) / x.error);
    const auto said = rounded(x);
    found += said.has_value();
    misrounded += said && *said != nearest;
  }
  void check() const {
    INFO(asked << " asked, " << given << " given, " << found << " found, farthest " << farthest);
    CHECK(missed == 0);
    CHECK(misrounded == 0);
    CHECK(given > asked - asked / 50);
    CHECK(found > given - given / 50);
    CHECK(farthest > 1 / 64.0);  // a sixty-fourth of the bound would be too small
  }
};

/// An angle of any size, near a multiple of a step or of a quarter turn, or anywhere.
double drawn_angle(DrawStream& draws) {
  const double x = catalogue::ordinary(draws);
  switch (draws.below(5)) {
    case 0: return x;
    case 1: return x * 8;
    case 2: return std::ldexp(x, static_cast<int>(draws.below(21)));
    case 3: {
      const auto steps = static_cast<double>(draws.below(2000));
      return steps / 512 + std::ldexp(x, -10 - static_cast<int>(draws.below(20)));
    }
    default: {
      const auto quarters = static_cast<double>(draws.below(40));
      return quarters * 0x1.921fb54442d18p-1 + std::ldexp(x, -static_cast<int>(draws.below(20)));
    }
  }
}

}  // namespace

TEST_CASE("enclosed angles: sine and cosine are MPFR's") {
  Truth truth;
  Count sines, cosines;
  for (std::uint64_t i = 0; i < 100000; ++i) {
    DrawStream draws = DrawStream::seeded(catalogue::seed_of(1, "enclosed sine and cosine", i));
    const double u = drawn_angle(draws);
    const auto said = enclosed_cosine_sine(u);
    sines.asked += 1, cosines.asked += 1;
    if (!said) continue;
    const auto part = [](Two x, bool second) { return second ? x.second() : x.first(); };
    for (const bool second : {false, true}) {
      mpfr_set_d(truth.other, u, MPFR_RNDN);
      second ? mpfr_sin(truth.value, truth.other, MPFR_RNDN) : mpfr_cos(truth.value, truth.other, MPFR_RNDN);
      (second ? sines : cosines)
          .add({part(said->high, second), part(said->low, second), part(said->error, second)}, truth);
    }
  }
  sines.check(), cosines.check();
}

TEST_CASE("enclosed angles: the angle of a vector is MPFR's") {
  Truth truth;
  Count angles;
  for (std::uint64_t i = 0; i < 100000; ++i) {
    DrawStream draws = DrawStream::seeded(catalogue::seed_of(1, "enclosed angle", i));
    double x = catalogue::ordinary(draws), y = catalogue::ordinary(draws);
    if (draws.below(2) == 1) x = std::ldexp(x, static_cast<int>(draws.below(60)) - 30);
    if (x == 0 || y == 0) continue;
    angles.asked += 1;
    const auto said = enclosed_angle({x, 0, 0}, {y, 0, 0});
    if (!said) continue;
    mpfr_set_d(truth.other, x, MPFR_RNDN), mpfr_set_d(truth.value, y, MPFR_RNDN);
    mpfr_atan2(truth.value, truth.value, truth.other, MPFR_RNDN);
    if (y < 0) {
      mpfr_const_pi(truth.other, MPFR_RNDN), mpfr_mul_2ui(truth.other, truth.other, 1, MPFR_RNDN);
      mpfr_add(truth.value, truth.value, truth.other, MPFR_RNDN);
    }
    angles.add(*said, truth);
  }
  angles.check();
}

TEST_CASE("enclosed angles: beyond 2^20, and where nothing is left of an angle, nothing is said") {
  CHECK(!enclosed_cosine_sine(0x1.00001p20));
  CHECK(enclosed_cosine_sine(-0x1p20));
  CHECK(!enclosed_angle({1, 0, 0.5}, {1, 0, 0}));
  CHECK(!enclosed_angle({0, 0, 0}, {1, 0, 0}));
}

}  // namespace touchstone::proptests::enclosed_angles_tests
