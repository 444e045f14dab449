// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>

#include "catalogue/families/passages/line_solid_cases.h"
#include "geometry/volumes.h"

namespace touchstone::catalogue {

struct TightTangent {
  Point3d origin;
  Vector3d direction;
  Sphere3d ball;
};

/// Rays that touch a ball, miss it or meet it by less than roundings, of numbers with all their digits, found by
/// climbing: rounded to nearest, the discriminant has the wrong sign and a size of 8 to 9 in a hundred of the bound of
/// the filter (robust/kernel/filters/ray_filter.h), which holds in every rounding mode. More has not been found. The
/// first two lie in the plane z = 0.
inline TightTangent tight_tangent(DrawStream& draws) {
  static constexpr TightTangent found[] = {
      {{-0x1.0489c2ed22c4bp+1, -0x1.8ca3c45cde73ap+0, 0},
       {0x1.af66bceaae8b5p-1, 0x1.28b5f8871d17ep-7, 0},
       {{0x1.e684e8388c4a4p-1, 0x1.29701974577c3p-1, 0}, 0x1.0c8e8afd6d711p+1}},
      {{0x1.d30d38012829fp-1, -0x1.3103054fdb741p+1, 0},
       {0x1.e4bc0a085420fp-3, 0x1.f6c051e280b7fp-1, 0},
       {{0, 0, 0}, 0x1.71f86e95cd37cp+0}},
      {{-0x1.adde3ee802c9dp+1, -0x1.763b4efd18c29p+1, -0x1.bca4de1031768p-2},
       {0x1.296ef22123c7bp-1, 0x1.9fbf35ea3c702p-1, 0x1.525e5b2b2bc5ep-3},
       {{0x1.50b1e191f3a9bp-1, -0x1.7923159f7f535p-1, -0x1.9a439747a6f4bp-1}, 0x1.1f770f7ec67f9p+1}},
      {{-0x1.f8da740207b98p+0, -0x1.341ce897dbb9dp-1, -0x1.611ac3ef38cfap-4},
       {0x1.1045de3f6d5b4p-1, 0x1.af8cb33a10164p-3, -0x1.3f26bb8e13732p-2},
       {{0, 0, 0}, 0x1.1272525c7a0abp+0}},
      {{-0x1.22a7047f875aep+1, 0x1.b575da2a133d5p+1, 0x1.e21c98a32e5d5p+0},
       {0x1.dddda7a5b45f0p-2, -0x1.b9427bb51522ap-1, 0x1.4575b7537ff0bp-6},
       {{0, 0, 0}, 0x1.0002fa7b6d15fp+1}},
      {{0x1.4b582fcbea437p+0, 0x1.4b33c648e8db7p+0, -0x1.80aafa3da57b3p-2},
       {0x1.d6b1ec05fa39bp-3, -0x1.15aecb19ca95ep-1, 0x1.39a38e36b2034p-9},
       {{0x1.7b13d468e07afp-1, -0x1.e0839991fa60dp-1, -0x1.b2191cca0044dp-2}, 0x1.61d3a014e22b1p+0}},
  };
  const auto& [p, v, ball] = found[draws.below(std::size(found))];
  // A power of two of all lengths, and one more of the direction, change no rounding.
  const double size = power_of_two(draws, -20, 20), way = power_of_two(draws, -20, 20);
  const Point3d& m = ball.center;
  return {{size * p.x, size * p.y, size * p.z}, way * v, {{size * m.x, size * m.y, size * m.z}, size * ball.radius}};
}

}  // namespace touchstone::catalogue
