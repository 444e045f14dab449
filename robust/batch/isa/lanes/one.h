// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "robust/batch/isa/lanes/bytes.h"

namespace touchstone::robust::batch::isa {
namespace {

Lanes same(double x) { return Lanes(x); }
Lanes magnitude(Lanes x) { return Lanes(__builtin_fabs(x.v)); }
Lanes lesser(Lanes x, Lanes y) { return x.v < y.v ? x : y; }
Lanes greater(Lanes x, Lanes y) { return x.v > y.v ? x : y; }
Lanes multiply_add(Lanes a, Lanes b, Lanes c) { return a * b + c; }
Mask above(Lanes x, Lanes y) { return x.v > y.v; }
Mask not_below(Lanes x, Lanes y) { return x.v >= y.v; }
Mask equal(Lanes x, Lanes y) { return x.v == y.v; }
Mask negative(Lanes x) { return static_cast<Mask>(__builtin_signbit(x.v) != 0); }

}  // namespace
}  // namespace touchstone::robust::batch::isa
