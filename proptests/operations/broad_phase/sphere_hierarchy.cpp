// SPDX-License-Identifier: Apache-2.0
#include "catalogue/rows/broad_phase/sphere_hierarchy.h"
#include "proptests/forward_error.h"
#include "robust/structures/ball_tree.h"

namespace touchstone::proptests::sphere_hierarchy_tests {
namespace {

using Row = rows::sphere_hierarchy;

Rational square(const Rational& x) { return Rational(x * x); }

/// Whether a ball is in another one, in rationals; an infinite one holds everything.
bool holds(const Sphere3d& outer, const Sphere3d& inner) {
  if (std::isinf(outer.radius)) return true;
  if (std::isinf(inner.radius)) return false;
  const Rational more = exact(outer.radius) - exact(inner.radius);
  const auto &p = outer.center, &q = inner.center;
  const Rational distance = square(Rational(exact(p.x) - exact(q.x))) + square(Rational(exact(p.y) - exact(q.y))) +
                            square(Rational(exact(p.z) - exact(q.z)));
  return sgn(more) >= 0 && distance <= square(more);
}

}  // namespace

TEST_CASE("BallTree: each node holds both below it, exactly") {
  const auto complaint = [](const Question& question) -> std::string {
    const auto asked = typed<Row>(question);
    const auto* spheres = std::get_if<std::tuple<Row::Spheres>>(&asked);
    if (spheres == nullptr) return "";
    try {
      const robust::BallTree tree(std::get<0>(*spheres));
      for (const auto& node : tree.nodes()) {
        if (node.leaf) continue;
        for (const Index below : {node.left, node.right})
          if (!holds(node.ball, tree.nodes()[below].ball)) return "a ball is not in the one above it";
      }
      return "";
    } catch (const InvalidInput&) {
      return "";
    }
  };
  never(catalogue::operation_of_row<Row>(), "nodes hold what is below", complaint, 6);
}

TEST_CASE("sphere_hierarchy: the deck's radius, rounded, loses a touch that robust finds") {
  // 3/10 as a double and its root's neighbours: some of these touch at the end of the node above.
  int lost = 0;
  for (int k = 1; k < 200; ++k) {
    Row::Spheres row;
    const double step = k / 10.0;
    for (int i = 0; i < 8; ++i) row.push_back({{i * step, i * step / 3, 0}, 0});
    for (int i = 0; i < 8; ++i) row.push_back({{i * step, i * step / 3, 0}, 0});
    const std::vector<IndexPair> found = robust::sphere_hierarchy(row);
    CHECK(found == robust::all_pairs(row));
    lost += reference::sphere_hierarchy(row) != found;
  }
  CHECK(lost > 0);
}

}  // namespace touchstone::proptests::sphere_hierarchy_tests
