// SPDX-License-Identifier: Apache-2.0
#include "robust/kernel/solids/obb_passage.h"

#include <algorithm>
#include <array>
#include <limits>

#include "robust/kernel/enclosed/loose.h"
#include "robust/kernel/enclosed/round_solids.h"
#include "robust/kernel/enclosed/window.h"
#include "robust/kernel/shapes/nearest_points.h"
#include "robust/kernel/shapes/triangle_clip.h"
#include "robust/kernel/solids/box_passage.h"

namespace touchstone::robust::kernel {

/// Along a normal the line's height starts at `height` and climbs by `climb` in a unit of t; the box reaches from
/// -reach to reach. A climb of 0 is exact: all of its terms are 0.
Perhaps<Passage<double>> ObbPassage::enclosed(const Line& line, const Obb3d& obb) {
  using filters::moderate;
  const auto& [from, to, ends] = line;
  if (!(moderate(from) & moderate(to) & moderate(obb)) || !rounds_to_nearest()) return std::nullopt;
  const auto way = ends ? loose_between(from, to) : loose({to.x, to.y, to.z}), start = loose_between(obb.center, from);
  const std::array edges{loose(obb.half_axes.u), loose(obb.half_axes.v), loose(obb.half_axes.w)};
  double first = 0, last = ends ? 1 : std::numeric_limits<double>::infinity();
  bool moves = false;
  for (std::size_t k = 0; k < 3; ++k) {
    const auto normal = cross(edges[(k + 1) % 3], edges[(k + 2) % 3]);
    const Loose volume = dot(normal, edges[k]);
    if (!certain(volume)) return std::nullopt;
    const Loose reach = volume.high > 0 ? volume : -volume, height = dot(normal, start), climb = dot(normal, way);
    if (none_of(climb)) {
      const Loose above = height - reach, below = -height - reach;
      if ((certain(above) && above.high > 0) || (certain(below) && below.high > 0)) return no_passage;
      if (!certain(above) || !certain(below)) return std::nullopt;
      continue;
    }
    if (!certain(climb)) return std::nullopt;
    moves = true;
    const Divisor<double> speed(climb);
    const bool rises = climb.high > 0;
    const auto entry = rounded((rises ? -reach - height : reach - height) / speed);
    const auto exit = rounded((rises ? reach - height : -reach - height) / speed);
    if (!entry || !exit) return std::nullopt;
    first = std::max(first, *entry), last = std::min(last, *exit);
  }
  if (last < first) return no_passage;
  if (!moves || !(first < last)) return std::nullopt;
  return Passage<double>{PassageRelation::hit, first, last};
}

Passage<double> ObbPassage::exact(const Line& line, const Obb3d& obb) {
  const auto& [u, v, w] = obb.half_axes;
  const auto [at, exponent] = integer_points(line.from, line.to, obb.center, u, v, w);
  const IntegerBox box = box_of(at, 2);
  const Vector3<mpz_class> start = at[0] - box.center,
                           end = line.ends ? at[1] - box.center : start + (at[1] - IntegerPoint{0, 0, 0});
  Clipped part = line.ends ? Clipped{} : Clipped::ray();
  for (std::size_t k = 0; k < 3; ++k) {
    const Vector3<mpz_class> normal = cross(box.half_axes[(k + 1) % 3], box.half_axes[(k + 2) % 3]);
    const mpz_class reach = abs(dot(normal, box.half_axes[k])), at_start = dot(normal, start),
                    at_end = dot(normal, end);
    part.keep(reach + at_start, reach + at_end), part.keep(reach - at_start, reach - at_end);
  }
  return rounded_passage(part, !zero(end - start));
}

}  // namespace touchstone::robust::kernel
