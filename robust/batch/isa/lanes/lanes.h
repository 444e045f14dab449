// SPDX-License-Identifier: Apache-2.0
// Included by one unit for each instruction set, with TOUCHSTONE_LANES of its own.
#pragma once

#include <cstddef>
#include <cstdint>
#include <cstring>

#include "robust/kernel/filters/strict_math.h"

// Everything here is internal to its unit. A function that the linker could share with other units would carry this
// unit's instructions to processors that lack them.
namespace touchstone::robust::batch::isa {
namespace {

/// One bit for each lane.
using Mask = std::uint32_t;

constexpr std::size_t lanes = TOUCHSTONE_LANES;
constexpr Mask all_lanes = (Mask{1} << lanes) - 1;

struct Lanes {
#if TOUCHSTONE_LANES > 1
  __extension__ typedef double Numbers __attribute__((vector_size(8 * TOUCHSTONE_LANES)));
#else
  typedef double Numbers;
#endif
  Numbers v;

  Lanes() = default;
  explicit Lanes(Numbers v) : v(v) {}
  static Lanes at(const double* p) {
    Lanes loaded;
    std::memcpy(&loaded.v, p, sizeof loaded.v);
    return loaded;
  }

  friend Lanes operator+(Lanes a, Lanes b) { return Lanes(a.v + b.v); }
  friend Lanes operator-(Lanes a, Lanes b) { return Lanes(a.v - b.v); }
  friend Lanes operator*(Lanes a, Lanes b) { return Lanes(a.v * b.v); }
};

}  // namespace
}  // namespace touchstone::robust::batch::isa
