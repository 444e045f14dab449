// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "geometry/commands.h"
#include "geometry/invalid_input.h"
#include "robust/kernel/filters/strict_math.h"

namespace touchstone::robust {

/// Bodies that are inserted, moved and removed in a plain list, which is sorted and swept when the pairs are requested;
/// the other queries test each body.
///
/// A body keeps the index that `insert` returned until it is removed; the index is never reused. A box that is not
/// valid throws InvalidInput ("box", "finite number" or "min <= max"), and so do a point that is not finite ("point"),
/// a ray that is not finite or has no direction ("ray.direction", "nonzero direction"), and the index of a missing body
/// ("body", "index of a body that is there"); nothing has changed then.
///
/// All answers are right for all finite doubles in every floating-point environment.
class SweptBoxes {
 public:
  Index insert(const Aabb3d& box);
  void move(Index body, const Aabb3d& box);
  void remove(Index body);

  /// The pairs of bodies i < j that meet, sorted. Takes n log n, and one test of each pair whose intervals meet on the
  /// axis on which bodies overlap least.
  std::vector<IndexPair> pairs() const;
  /// The bodies that meet a box, or contain a point, sorted.
  std::vector<Index> in_box(const Aabb3d& box) const;
  std::vector<Index> at_point(const Point3d& point) const;
  /// The bodies that a ray meets, in the order in which it meets them; those met at the same time by index.
  std::vector<Index> along_ray(const Ray3d& ray) const;

 private:
  std::size_t place_of(Index body) const;

  std::vector<Aabb3d> boxes_;  ///< of the existing bodies, in the order of their indices
  std::vector<Index> bodies_;
  Index next_ = 0;
};

}  // namespace touchstone::robust
