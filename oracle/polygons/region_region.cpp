// SPDX-License-Identifier: Apache-2.0
#include "oracle/polygons/region_region.h"

#include "oracle/rings/region.h"
#include "oracle/rings/slabs.h"

namespace touchstone::oracle {

template <Exact Number>
Truth<Contact> region_region(const Region2<Number>& a, const Region2<Number>& b) {
  validation::validate_numbers("a", a), validation::validate_numbers("b", b);
  const auto [regions, unit] = validated_regions<Number>({{"a", &a}, {"b", &b}}, {Number(0), Number(0)});
  return contact_by_slabs(edges_of(regions[0]), edges_of(regions[1]), unit);
}
template Truth<Contact> region_region(const Region2d&, const Region2d&);
template Truth<Contact> region_region(const Region2<Rational>&, const Region2<Rational>&);

}  // namespace touchstone::oracle
