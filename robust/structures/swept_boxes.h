// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "geometry/commands.h"
#include "geometry/invalid_input.h"
#include "robust/kernel/filters/strict_math.h"

namespace touchstone::robust {

/// Bodies that come, move and go, kept as a plain list and sorted and swept when the pairs are asked for; the other
/// queries look at each.
///
/// A body has the index that `insert` returned for as long as it is there; no other gets it afterwards. A box that is
/// not valid throws InvalidInput ("box", "finite number" or "min <= max"), and so do a point that is not finite
/// ("point"), a ray that is not or has no direction ("ray.direction", "nonzero direction"), and the index of a body
/// that is not there ("body", "index of a body that is there"); nothing has changed then.
///
/// All answers are right for all finite doubles in every floating-point environment.
class SweptBoxes {
 public:
  Index insert(const Aabb3d& box);
  void move(Index body, const Aabb3d& box);
  void remove(Index body);

  /// The pairs of bodies i < j that meet, sorted. n log n, and one look at each pair whose intervals meet on the axis
  /// on which bodies overlap least.
  std::vector<IndexPair> pairs() const;
  /// The bodies that meet a box, or hold a point, sorted.
  std::vector<Index> in_box(const Aabb3d& box) const;
  std::vector<Index> at_point(const Point3d& point) const;
  /// The bodies that a ray meets, in the order in which it does; those that it meets at once by their indices.
  std::vector<Index> along_ray(const Ray3d& ray) const;

 private:
  std::size_t place_of(Index body) const;

  std::vector<Aabb3d> boxes_;  ///< of the bodies that are there, in the order of their indices
  std::vector<Index> bodies_;
  Index next_ = 0;
};

}  // namespace touchstone::robust
