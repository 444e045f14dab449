// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <utility>

#include "catalogue/families/draw_stream.h"
#include "geometry/triangles.h"

namespace touchstone::catalogue {

/// Pairs of triangles that a library was reported to be wrong about, with the numbers of the report.
inline const auto& all_reported_triangles() {
  // github.com/libigl/libigl/issues/2381: triangles of one that was subdivided twice, "5 self-intersecting pairs".
  static constexpr std::array<Point3d, 6> v{{{0.33890101313590998, 0.78804200887680098, 0.48812699317932101},
                                             {0.31805300712585399, 0.76836401224136397, 0.49308800697326699},
                                             {0.32418551295995701, 0.79794725775718722, 0.48203899711370451},
                                             {0.33368901163339598, 0.78312250971794173, 0.48936724662780751},
                                             {0.30854950845241502, 0.78318876028060946, 0.485759757459164},
                                             {0.32326500862836799, 0.77328351140022322, 0.4918477535247805}}};
  // .../2382: 0.003 apart, and reported to meet.
  static constexpr std::array<Point3d, 6> w{{{0.39234799146652199, 0.38443601131439198, 0.44744500517845198},
                                             {0.38924700021743752, 0.385637506842613, 0.45762349665164948},
                                             {0.38700349628925301, 0.38789276033639897, 0.45634675025939975},
                                             {0.39079749584197976, 0.38503675907850249, 0.45253425091505073},
                                             {0.38769650459289529, 0.38623825460672351, 0.46271274238824822},
                                             {0.39279749989509577, 0.37299175560474374, 0.45553924888372399}}};
  static const std::array<std::pair<Triangle3d, Triangle3d>, 7> pairs{
      {{{v[1], v[5], v[4]}, {v[0], v[2], v[3]}},
       {{w[0], w[3], w[2]}, {w[1], w[5], w[4]}},
       // github.com/CGAL/cgal/issues/9486: two coincident faces, which do not "self-intersect".
       {{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, {{0, 0, 0}, {0, 1, 0}, {1, 0, 0}}},
       // github.com/llnl/axom/issues/152: a common corner, missed in 6 of 36 orders of the corners.
       {{{76.648, 54.6752, 15.0012}, {76.648, 54.6752, 14.5542}, {76.582, 54.6752, 14.7879}},
        {{76.6252, 54.6752, 14.892}, {76.582, 54.6752, 14.7879}, {76.5617, 54.6752, 14.7929}}},
       // github.com/benardp/contours/issues/1: apart, and reported to meet.
       {{{12.3015, -0.253368, 5.49101}, {18.6765, -2.55337, 4.91756}, {12.3015, -2.55337, 4.91756}},
        {{-11.9885, -0.253368, 5.49101}, {1.61448, -0.253368, 5.49101}, {1.61448, -2.55337, 4.91756}}},
       // github.com/BrunoLevy/geogram/issues/10: an assertion.
       {{{1898.68, 775, 1158.48}, {2000, 775, 1166.7}, {1898.68, 675, 1148.6}},
        {{1966.41, 675, 1163.79}, {1971.63, 675, 1166.95}, {1967.56, 684.554, 1166.67}}},
       // github.com/CGAL/cgal/issues/6384: an intersection that is empty.
       {{{-1.2251099999999999, -5.8899699999999999, -7.987949999999999},
         {0.40490799999999999, -6.0014500000000002, -3.314319999999999},
         {-1.2251099999999999, -5.8899699999999999, -3.314319999999999}},
        {{-0.21243100000000001, -5.7414293000000001, -4.50379500000000},
         {-0.15238699999999999, -6.0416264999999996, -4.51681199999999},
         {-0.56714299999999995, -5.9451375000000004, -4.37800200000000}}}}};
  return pairs;
}

inline std::pair<Triangle3d, Triangle3d> reported_triangles(DrawStream& draws) {
  const auto& pairs = all_reported_triangles();
  return pairs[draws.below(pairs.size())];
}

}  // namespace touchstone::catalogue
