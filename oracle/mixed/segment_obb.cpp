// SPDX-License-Identifier: Apache-2.0
#include "oracle/mixed/segment_obb.h"

#include "oracle/exact/shapes/obb_passage.h"

namespace touchstone::oracle {

template <Exact Number>
Truth<Passage<Rational>> segment_obb(const Segment3<Number>& segment, const Obb3<Number>& obb) {
  return passage_of_obb("segment", segment, obb);
}
template Truth<Passage<Rational>> segment_obb(const Segment3d&, const Obb3d&);
template Truth<Passage<Rational>> segment_obb(const Segment3<Rational>&, const Obb3<Rational>&);

}  // namespace touchstone::oracle
