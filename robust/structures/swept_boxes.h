// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "geometry/commands.h"
#include "geometry/invalid_input.h"
#include "robust/kernel/strict_math.h"

namespace touchstone::robust {

/// Bodies that come, move and go, kept as a plain list and sorted and swept when the pairs are asked for.
///
/// A body has the index that `insert` returned for as long as it is there; no other gets it afterwards. A box that is
/// not valid throws InvalidInput ("box", "finite number" or "min <= max"), and so does the index of a body that is not
/// there ("body", "index of a body that is there"); nothing has changed then.
class SweptBoxes {
 public:
  Index insert(const Aabb3d& box);
  void move(Index body, const Aabb3d& box);
  void remove(Index body);

  /// The pairs of bodies i < j that meet, sorted. Right for all finite doubles in every floating-point environment.
  /// n log n, and one look at each pair whose intervals meet on the axis on which bodies overlap least.
  std::vector<IndexPair> pairs() const;

 private:
  std::size_t place_of(Index body) const;

  std::vector<Aabb3d> boxes_;  ///< of the bodies that are there, in the order of their indices
  std::vector<Index> bodies_;
  Index next_ = 0;
};

}  // namespace touchstone::robust
