// SPDX-License-Identifier: Apache-2.0
#include "catalogue/rows/polygons/convex_partition.h"

#include "proptests/partition_laws.h"

namespace touchstone::proptests::convex_partition_tests {
namespace {

using Row = rows::convex_partition;

/// How many vertices of a lattice ring are reflex.
std::size_t reflex(const Polygon2d& given) {
  const Polygon2d ring = opened(given);
  Int128 area = 0;
  for (std::size_t i = 0; i < ring.size(); ++i) area += lattice_turn({0, 0}, ring[i], ring.next(i));
  std::size_t count = 0;
  for (std::size_t i = 0; i < ring.size(); ++i) {
    const Int128 turn = lattice_turn(ring.previous(i), ring[i], ring.next(i));
    count += area > 0 ? turn < 0 : turn > 0;
  }
  return count;
}

}  // namespace

PARTITION_LAWS("convex_partition", "pieces")

LAW("convex_partition: at most 2 r + 1 pieces for r reflex vertices, so one if there is none, and enough to end every "
    "reflex angle",
    ring) {
  if (!on_lattice(asked)) return true;
  const std::size_t r = reflex(ring), pieces = ask(asked).size();
  return pieces <= 2 * r + 1 && 2 * pieces >= r + 2;
}

TEST_CASE("convex_partition: rings with one partition that leaves no diagonal to take out, worked by hand") {
  only_answer<Row>({{{0, 0}, {1, 0}, {0, 1}}}, {{0, 1, 2}});
  only_answer<Row>({{{0, 0}, {4, 0}, {4, 4}, {0, 4}}}, {{0, 1, 2, 3}});
  only_answer<Row>({{{0, 4}, {4, 4}, {4, 0}, {0, 0}}}, {{0, 3, 2, 1}});          // clockwise
  only_answer<Row>({{{0, 0}, {2, 1}, {4, 0}, {2, 4}}}, {{0, 1, 3}, {1, 2, 3}});  // a dart
  only_answer<Row>({{{0, 0}, {1, 0}, {2, 0}, {2, 2}, {1, 2}, {0, 2}}},
                   {{0, 1, 2, 3, 4, 5}});  // flat vertices stay in their piece
  only_answer<Row>({{{0, 0}, {1, 0}, {2, 0}, {3, 0}, {0, 3}}}, {{0, 1, 2, 3, 4}});
}

TEST_CASE("convex_partition: a last position that repeats the first is no vertex") {
  only_answer<Row>({{{0, 0}, {4, 0}, {4, 4}, {0, 4}, {0, 0}}}, {{0, 1, 2, 3}});
  only_answer<Row>({{{0, 0}, {1, 0}, {0, 1}, {-0.0, 0}}}, {{0, 1, 2}});
  only_answer<Row>({{{2, 4}, {4, 0}, {2, 1}, {0, 0}, {2, 4}}}, {{0, 2, 1}, {0, 3, 2}});  // a dart, clockwise
}

TEST_CASE("convex_partition: huge, subnormal, and where the formula's products leave the range") {
  const Polygon2d dart{{{0, 0}, {2, 1}, {4, 0}, {2, 4}}}, square{{{0, 0}, {1, 0}, {1, 1}, {0, 1}}};
  only_answer<Row>(times(0x1p1021, dart), {{0, 1, 3}, {1, 2, 3}});
  only_answer<Row>(times(tiny, dart), {{0, 1, 3}, {1, 2, 3}}, false);
  only_answer<Row>(times(tiny, square), {{0, 1, 2, 3}}, false);
}

}  // namespace touchstone::proptests::convex_partition_tests
