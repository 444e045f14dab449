// SPDX-License-Identifier: Apache-2.0
#include "catalogue/numbers/true_number.h"

#include <cmath>
#include <cstdint>
#include <limits>

#include "catalogue/numbers/ulps.h"

namespace touchstone::catalogue {

double nearest(const TrueNumber& truth, bool binary32) {
  if (truth.rational()) return nearest(truth.rational_part(), binary32);
  return binary32 ? double{nearest_float(truth)} : nearest_double(truth);
}

double distance_in_ulps(double answered, const TrueNumber& truth, bool binary32) {
  if (truth.rational()) return distance_in_ulps(answered, truth.rational_part(), binary32);
  if (answered == nearest(truth, binary32)) return 0;
  // Below 2^-60 of half of the least subnormal, so that the distance is right to as many digits as anybody reads.
  constexpr std::int64_t bits = 1074 + 61;
  const double distance = distance_in_ulps(answered, truth.enclosure(bits).low, binary32);
  return distance > 0 ? distance : std::numeric_limits<double>::min();
}

}  // namespace touchstone::catalogue
