// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "geometry/validation.h"
#include "robust/batch/shapes/linear_numbers.h"
#include "robust/batch/isa/run.h"
#include "robust/polygons/point_in_polygon.h"
#include "robust/prepared/polygon.h"

namespace touchstone::robust::batch::isa {

/// The number of vertices from which a tree of the edges is asked instead of all of them for many points at a time. As
/// measured on one processor with AVX-512, before edges were linear functions, a tree is faster from about 130 vertices
/// of a star on; that of a comb with slanted teeth is slower at 1,000, too.
inline constexpr std::size_t many_vertices = 512;

/// Locates each point in a polygon that has been validated, by a filter of rings like it.
inline void locate(Filter* Filters::*filter, const Polygon2d& polygon, const Points2& points, std::size_t count,
                   std::uint8_t* answers, const Limits& limits) {
  static_assert(sizeof(Point2d) == 2 * sizeof(double));
  if (polygon.size() >= many_vertices) {
    const Polygon prepared(Validated{}, *validation::OpenRing(polygon));
    const auto by_tree = [&](const Point2d& point) { return robust::point_in_polygon(prepared, point); };
    return decide_each(limits, by_tree, count, answers, points);
  }
  const std::size_t vertices = polygon.size() - validation::closed(polygon.vertices);
  const double* const first = &polygon.vertices.data()->x;
  std::vector<double> numbers(first, first + 2 * vertices);
  add_lines(numbers);
  const auto decide = [&](const Point2d& point) { return robust::point_in_polygon(polygon, point); };
  run(Which{filter, &Filters::close_point_in_ring}, Shared{numbers.data(), vertices}, limits, decide, decide, count,
      answers, points);
}

}  // namespace touchstone::robust::batch::isa
