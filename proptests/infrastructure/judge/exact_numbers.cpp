// SPDX-License-Identifier: Apache-2.0
#include <utility>

#include "catalogue/numbers/exact.h"
#include "catalogue/numbers/ulps.h"
#include "proptests/catch.h"
#include "proptests/uses.h"

/// The number type in which the judge runs the slides' formulas again without rounding.
namespace touchstone::proptests::exact_numbers_tests {

TEST_CASE("Exact: x / 0 is undefined, and so is what is computed from it; every comparison with it is false") {
  const Exact undefined = Exact(3) / Exact(0), one(1);
  CHECK_FALSE(undefined.defined());
  CHECK_FALSE((Exact(0) / Exact(0)).defined());
  for (const Exact& derived :
       {undefined + one, one - undefined, undefined * Exact(0), one / undefined, -undefined, cos(undefined)}) {
    CHECK_FALSE(derived.defined());
  }
  for (const auto& [a, b] : {std::pair{undefined, one}, {one, undefined}, {undefined, undefined}}) {
    CHECK_FALSE(a < b);
    CHECK_FALSE(a > b);
    CHECK_FALSE(a <= b);
    CHECK_FALSE(a >= b);
    CHECK_FALSE(a == b);
    CHECK(a != b);  // as with NaN
  }
}

TEST_CASE("Exact: arithmetic and comparisons of rationals") {
  const Exact third = Exact(1) / Exact(3);
  CHECK((third + third + third == Exact(1)));
  CHECK((third * Exact(3) - Exact(1) == Exact(0)));
  CHECK((-third < Exact(0) && third > Exact(0) && third <= third && third >= third && third != Exact(1)));
  CHECK((cos(Exact(0)) == Exact(1) && sin(Exact(0)) == Exact(0)));
  const Exact c = cos(Exact(1)), s = sin(Exact(1));
  mpq_class within(1);
  within >>= 2390;
  CHECK(abs((c * c + s * s - Exact(1)).value()) < within);
  CHECK(nearest(c.value()) == 0.54030230586813971740093660744297660373);  // OEIS A049470
}

TEST_CASE("Exact: roots of squares, other roots, and what has none") {
  CHECK((sqrt(Exact(49) / Exact(100)) == Exact(7) / Exact(10)));
  CHECK((sqrt(Exact(0)) == Exact(0)));
  CHECK_FALSE(sqrt(Exact(-1)).defined());
  CHECK_FALSE(sqrt(Exact(1) / Exact(0)).defined());
  mpq_class within(1);
  within >>= 8990;
  for (const double x : {2.0, 0.1, 1e308, 5e-324}) {
    const Exact a(exact_value(x)), root = sqrt(a);
    CHECK(abs((root * root / a - Exact(1)).value()) < within);
  }
}

TEST_CASE("Exact: arc cosines, also of numbers as near to 1 and -1 as cosines of doubles come, and what has none") {
  CHECK((acos(Exact(1)) == Exact(0)));
  CHECK(nearest(acos(Exact(-1)).value()) == 3.14159265358979323846264338327950288419);  // OEIS A000796
  CHECK_FALSE(acos(Exact(1) / Exact(0)).defined());
  mpq_class within(1), above(1);
  within >>= 2390;
  above >>= 8401;
  CHECK(abs((acos(Exact(0)) + acos(Exact(0)) - acos(Exact(-1))).value()) < within);
  CHECK_FALSE(acos(Exact(mpq_class(1 + above))).defined());
  CHECK_FALSE(acos(Exact(mpq_class(-1 - above))).defined());
  for (const double x : {0.1, -0.7, 1 - 0x1p-53, -1 + 0x1p-53, 5e-324}) {
    CHECK(abs((cos(acos(Exact(exact_value(x)))) - Exact(exact_value(x))).value()) < within);
  }
  // 1 - cos x = x^2 / 2 - x^4 / 24 + ...
  for (const int k : {2500, 5000, 8401}) {
    mpq_class room(1);
    room >>= static_cast<mp_bitcnt_t>(k);
    const Exact small = acos(Exact(mpq_class(1 - room))), other = acos(Exact(-1)) - acos(Exact(mpq_class(room - 1)));
    CHECK(abs((small * small / Exact(mpq_class(2 * room))).value() - 1) < within);
    CHECK((other > Exact(0) && abs((other * other / Exact(mpq_class(2 * room))).value() - 1) < mpq_class(1, 2)));
  }
}

}  // namespace touchstone::proptests::exact_numbers_tests
