// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <cmath>

#include "catalogue/numbers/ulps.h"
#include "catalogue/shape/encoded_value.h"

namespace touchstone::catalogue {

/// The greatest magnitude of a question's numbers.
inline double greatest(const Question& question) {
  double size = 0;
  for (const double number : question.numbers) size = std::max(size, std::fabs(number));
  return size;
}

/// True if a margin, a length to that power, is at most this length: times the size of the question's numbers if it is
/// an area or a square (degree 2), and so on.
inline bool within(const mpq_class& margin, const mpq_class& length, const mpq_class& size, int degree) {
  mpq_class limit = length;
  for (int i = 1; i < degree; ++i) limit *= size;
  return margin <= limit;
}

/// True if the margin of a truth lies inside an engine's declared tolerance, a length in the unit of the coordinates.
inline bool tolerated(const mpq_class& margin, double tolerance, int degree, const Question& question) {
  return tolerance > 0 &&
         within(margin, exact_value(tolerance), exact_value(std::max(1.0, greatest(question))), degree);
}

}  // namespace touchstone::catalogue
