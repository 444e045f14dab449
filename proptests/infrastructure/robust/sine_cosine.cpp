// SPDX-License-Identifier: Apache-2.0
#include "robust/kernel/integers/sine_cosine.h"

#include <mpfr.h>

#include <thread>

#include "catalogue/families/numbers.h"
#include "proptests/catch.h"

namespace touchstone::proptests::sine_cosine_tests {
namespace {

namespace kernel = robust::kernel;

/// floor(pi * 2^bits) by MPFR.
mpz_class floor_of_pi(std::uint64_t bits) {
  mpfr_t value;
  mpfr_init2(value, static_cast<mpfr_prec_t>(bits + 64));
  mpfr_const_pi(value, MPFR_RNDN);
  mpfr_mul_2ui(value, value, bits, MPFR_RNDN);
  mpz_class result;
  mpfr_get_z(result.get_mpz_t(), value, MPFR_RNDD);
  mpfr_clear(value);
  return result;
}

/// Off by less than 1: the whole number below pi * 2^bits, or the one above.
int wrong_digits(std::uint64_t bits) {
  const mpz_class least = floor_of_pi(bits), found = kernel::pi(bits);
  return found != least && found != least + 1;
}

}  // namespace

TEST_CASE("pi: off by less than 1 in the last of any number of bits, whatever was asked before") {
  int wrong = 0;
  // A thread of its own has nothing kept yet: what is kept first ends at 1280 bits, then at three more than were asked
  // for.
  std::thread([&] {
    for (std::uint64_t bits = 32; bits < 1400; bits += bits < 1260 ? 61 : 1) wrong += wrong_digits(bits);
    for (const std::uint64_t bits : {3000, 2997, 2998, 2999, 3000, 3001, 3002, 3003, 100, 3006})
      wrong += wrong_digits(bits);
    mpfr_free_cache2(MPFR_FREE_LOCAL_CACHE);
  }).join();
  CHECK(wrong == 0);
}

TEST_CASE("sine and cosine: within their error of MPFR's, at any size and sign of the angle") {
  mpfr_t angle, sine, cosine;
  mpfr_init2(angle, 53), mpfr_inits2(2000, sine, cosine, static_cast<mpfr_ptr>(nullptr));
  const auto within = [](mpfr_t exact, const mpz_class& n, const kernel::SineCosine& found) {
    mpfr_mul_2ui(exact, exact, found.bits, MPFR_RNDN);
    mpz_class low, high;
    mpfr_get_z(low.get_mpz_t(), exact, MPFR_RNDD), mpfr_get_z(high.get_mpz_t(), exact, MPFR_RNDU);
    return n - found.error <= low && high <= n + found.error;
  };
  int wrong = 0, wide = 0;
  for (std::uint64_t i = 0; i < 4000; ++i) {
    catalogue::DrawStream draws = catalogue::DrawStream::seeded(catalogue::seed_of(1, "sine and cosine", i));
    const double u = draws.below(2) == 1 ? catalogue::ordinary(draws) * 8 : catalogue::any_finite(draws);
    const std::uint64_t bits = 32 + draws.below(300);
    const kernel::SineCosine found = kernel::sine_cosine(u, bits);
    mpfr_set_d(angle, u, MPFR_RNDN);
    mpfr_sin_cos(sine, cosine, angle, MPFR_RNDN);
    wrong += found.bits != bits || !within(sine, found.sine, found) || !within(cosine, found.cosine, found);
    wide += found.error >= mpz_class(16 * bits);
  }
  CHECK(wrong == 0);
  CHECK(wide == 0);
  mpfr_clears(angle, sine, cosine, static_cast<mpfr_ptr>(nullptr));
}

}  // namespace touchstone::proptests::sine_cosine_tests
