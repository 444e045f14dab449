// SPDX-License-Identifier: Apache-2.0
#include "oracle/mixed/segment_capsule.h"

#include "oracle/exact/shapes/passage.h"

namespace touchstone::oracle {

template <Exact Number>
Truth<Passage<Surd>> segment_capsule(const Segment3<Number>& segment, const Capsule3<Number>& capsule) {
  return passage_of_capsule("segment", segment, capsule);
}
template Truth<Passage<Surd>> segment_capsule(const Segment3d&, const Capsule3d&);
template Truth<Passage<Surd>> segment_capsule(const Segment3<Rational>&, const Capsule3<Rational>&);

}  // namespace touchstone::oracle
