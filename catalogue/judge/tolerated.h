// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "catalogue/codec/tape.h"
#include "catalogue/judge/ulps.h"

namespace touchstone::audit {

/// Whether the margin of a truth lies inside an engine's declared tolerance, a length in the unit of the coordinates. A
/// margin that is an area or a square (degree 2) is compared with tolerance times the greatest coordinate of the
/// question.
inline bool tolerated(const mpq_class& margin, double tolerance, int degree, const Question& question) {
  if (!(tolerance > 0)) return false;
  mpq_class limit = exact_value(tolerance), greatest = 1;
  for (const double number : question.numbers) {
    const mpq_class size = abs(exact_value(number));
    if (size > greatest) greatest = size;
  }
  for (int i = 1; i < degree; ++i) limit *= greatest;
  return margin <= limit;
}

}  // namespace touchstone::audit
