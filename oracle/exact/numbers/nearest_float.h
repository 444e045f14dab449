// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "oracle/truth.h"

namespace touchstone::oracle {

/// The binary32 number nearest to a rational, ties to even, from integers like nearest_double.h: zero gives +0.0f, a
/// nonzero value that rounds to zero keeps its sign, and from 2^128 - 2^103 on the result is infinite.
float nearest_float(const Rational& value);

}  // namespace touchstone::oracle
