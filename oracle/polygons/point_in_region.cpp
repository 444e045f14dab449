// SPDX-License-Identifier: Apache-2.0
#include "oracle/polygons/point_in_region.h"

#include "oracle/rings/parity.h"
#include "oracle/rings/region.h"

namespace touchstone::oracle {

template <Exact Number>
Truth<Location> point_in_region(const Region2<Number>& region, const Point2<Number>& point) {
  validation::validate_numbers("region", region), validation::validate_numbers("point", point);
  const auto [regions, unit] = validated_regions<Number>({{"region", &region}}, point);
  return location_by_parity(regions[0], unit);
}
template Truth<Location> point_in_region(const Region2d&, const Point2d&);
template Truth<Location> point_in_region(const Region2<Rational>&, const Point2<Rational>&);

}  // namespace touchstone::oracle
