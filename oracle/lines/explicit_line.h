// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "geometry/answers.h"
#include "oracle/certificates/certificate.h"

namespace touchstone::oracle {

/// Truth: sign of the rational y - (slope x + intercept). Margin: its absolute value (the vertical distance).
Truth<Height> explicit_line(double slope, double intercept, const Point2d& point);
Truth<Height> explicit_line(const Rational& slope, const Rational& intercept, const Point2<Rational>& point);
Certificate explicit_line_certificate(double slope, double intercept, const Point2d& point);

}  // namespace touchstone::oracle
