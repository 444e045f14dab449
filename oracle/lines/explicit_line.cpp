// SPDX-License-Identifier: Apache-2.0
#include "oracle/lines/explicit_line.h"

#include "geometry/validation.h"
#include "oracle/exact/numbers/decode.h"

namespace touchstone::oracle {

template <Exact Number>
Truth<Height> explicit_line(const Number& slope, const Number& intercept, const Point2<Number>& point) {
  validation::validate("slope", slope), validation::validate("intercept", intercept),
      validation::validate("point", point);
  const Rational e(exact(point.y) - (exact(slope) * exact(point.x) + exact(intercept)));
  return {sgn(e) > 0   ? Height::above
          : sgn(e) < 0 ? Height::below
                       : Height::on,
          Rational(abs(e)), [e] {
            return Certificate{"height", {{"height", {e}}}};
          }};
}
template Truth<Height> explicit_line(const double&, const double&, const Point2d&);
template Truth<Height> explicit_line(const Rational&, const Rational&, const Point2<Rational>&);

}  // namespace touchstone::oracle
