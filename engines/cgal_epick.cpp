// SPDX-License-Identifier: Apache-2.0
// CGAL as peer: surfaces, triangles and boxes by its kernel Epick, whose predicates are exact by the manual.
// Under the GPL with what it includes.
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/box_intersection_d.h>
#include <touchstone/program/engine_main.h>

#include "cgal_meshes.h"

using namespace touchstone;

struct CgalEpick : CgalMeshes<CGAL::Exact_predicates_inexact_constructions_kernel> {
  static constexpr const char* name = "CGAL Epick " CGAL_VERSION_STR " (triangles, surfaces, boxes)";
  static constexpr auto boundary = Boundary::closed;
  static constexpr auto pairs = Pairs::exact;

  /// Boxes are closed by default.
  std::vector<IndexPair> all_pairs(const std::vector<Aabb3d>& boxes) {
    using Box = CGAL::Box_intersection_d::Box_with_handle_d<double, 3, const Aabb3d*>;
    std::vector<Box> theirs;
    for (const Aabb3d& box : boxes) {
      const auto& [p, q] = box;
      theirs.emplace_back(CGAL::Bbox_3(p.x, p.y, p.z, q.x, q.y, q.z), &box);
    }
    std::vector<IndexPair> found;
    const auto index = [&boxes](const Box& box) { return static_cast<Index>(box.handle() - boxes.data()); };
    CGAL::box_self_intersection_d(theirs.begin(), theirs.end(), [&](const Box& a, const Box& b) {
      found.push_back({index(a), index(b)});
    });
    return found;
  }
};

TOUCHSTONE_ENGINE_MAIN(CgalEpick)
