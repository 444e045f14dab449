// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "geometry/volumes.h"
#include "robust/kernel/filters/strict_math.h"
#include "robust/kernel/machine/parallel.h"

/// The order of boxes along a curve that fills space, so that most neighbours in space are neighbours in order. All of
/// it is estimated: no answer depends on it. Requires a guard in scope.
namespace touchstone::robust::pairs {

struct Placed {
  std::uint32_t key;
  Index body;
};

/// Per axis. Extents are halved so that none overflows.
using Extents = std::array<double, 3>;

inline double middle(double low, double high) { return 0.25 * low + 0.25 * high; }
inline double width(double low, double high) { return 0.5 * high - 0.5 * low; }

/// Where the middles of some boxes are, and their mean width.
struct Frame {
  Extents low, high, mean;
  std::size_t count;

  double spread(std::size_t axis) const { return high[axis] - low[axis]; }
  /// The lengths that the curve takes for equal: on each axis the mean width, of these boxes and of those that they are
  /// compared with, and the distance between as many boxes on the axes on which these are not long.
  Extents units(const Extents& other_mean) const;
  /// Returns whether the curve has other proportions if these boxes are compared with those.
  bool turns_among(const Frame& others) const;
  /// The coordinate of a middle that is nearest to 0, on each axis, not halved.
  Extents nearest_to_zero() const;
};

/// The parts of so many boxes that threads work on at the same time: a thread is made in about the time of a thousand.
inline kernel::ThreadParts parts_of(std::size_t threads, std::size_t boxes) { return {threads, boxes, 1U << 14}; }

class Curve {
 public:
  Curve(const Aabb3d* boxes, std::size_t threads) : boxes_(boxes), threads_(threads) {}

  Frame frame(const Placed* first, const Placed* last) const;
  void arrange(Placed* first, Placed* last, const Frame& frame, const Extents& other_mean, bool by_exponent = false);

 private:
  void set_keys(Placed* first, Placed* last, const Frame& frame, const Extents& other_mean) const;
  void set_keys_by_exponent(Placed* first, Placed* last, const Frame& frame) const;
  void sort_by_key(Placed* first, Placed* last);
  kernel::ThreadParts parts(const Placed* first, const Placed* last) const {
    return parts_of(threads_, static_cast<std::size_t>(last - first));
  }

  const Aabb3d* boxes_;
  std::size_t threads_;
  std::vector<Placed> sorted_;
};

}  // namespace touchstone::robust::pairs
