// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>

#include "geometry/answers.h"
#include "geometry/volumes.h"

namespace touchstone::reference {

/// Decides whether two k-DOPs with the same normals overlap, only touch, or neither: slab by slab.
///
/// Deck p. 43: slabs [d1, d2] of the same normal are compared as the intervals of boxes are (p. 45-47); the volumes are
/// apart where on some normal one ends before the other begins. The slide says no more; as for boxes, a pair of slabs
/// that passes this test and fails it with <= is `touching` here.
///
/// The contract: `disjoint` if some pair of slabs has no number in common; otherwise `touching` if some pair has no
/// interval in common, but a number alone; otherwise `overlapping`. A flat slab (d1 == d2) has no interior, so it makes
/// the answer `touching` at most. This is the slide's answer, and conservative: `disjoint` is always true of the
/// solids, but slabs may meet where the solids do not (their edges pass one another, or one of them is empty).
/// a, b: their d / |N| in any unit of length, the same for both; N of any length.
/// Refused by robust and oracle with field and rule, the first that applies: a, then b, as point_in_kdop refuses its
/// k-DOP (fields "a.normals[i]", "b.slabs[i][1]" ...); then normals that are not the same in number ("b.normals", "the
/// same normals as a"), coordinate for coordinate and in the same order ("b.normals[i]", "the same normal as in a").
/// -0.0 is 0; the same direction with another length is another normal.
///
/// The test with <= assumes that both slabs have an interior. Where a slab is flat within the open interval of the
/// other, and nothing else touches, the formula answers `overlapping`, in exact arithmetic too (cause: algorithm).
/// Otherwise it is right in exact arithmetic.
///
/// Rounding: none; comparisons are exact. So in every environment that does not read subnormals as zero the double
/// version is right for every two k-DOPs without flat slabs. Margin: the least difference of a max and a min of one
/// pair of slabs, its size: a difference of N . P, which counts as a length.
template <class Real>
Contact kdop_kdop(const Kdop3<Real>& a, const Kdop3<Real>& b) {
  Contact contact = Contact::overlapping;
  for (std::size_t i = 0; i < a.slabs.size(); ++i) {
    const Slab<Real>&s = a.slabs[i], &t = b.slabs[i];
    if (s.max < t.min || t.max < s.min) return Contact::disjoint;
    if (s.max <= t.min || t.max <= s.min) contact = Contact::touching;
  }
  return contact;
}

}  // namespace touchstone::reference
