// SPDX-License-Identifier: Apache-2.0
#include <optional>
#include <vector>

#include "oracle/polygons/polygon_convexity.h"
#include "oracle/polygons/polygon_polygon.h"
#include "oracle/rings/boxes.h"
#include "oracle/rings/simple.h"
#include "proptests/catch.h"
#include "proptests/long_rings.h"

namespace touchstone::proptests::rings_tests {
namespace {

using namespace oracle;

Polygon2d moved(Polygon2d ring, double by) {
  for (Point2d& p : ring.vertices) p.x += by;
  return ring;
}

}  // namespace

TEST_CASE("boxes: the edges that are visited hold all whose boxes meet, in order up and down") {
  for (std::size_t n = 3; n < 80; ++n) {
    const IntegerRing ring(random_ring(n));
    const std::vector<Segment2<Integer>> edges = ring.edges();
    const Boxes boxes(edges);
    const Boxes::Box own = Boxes::box_of(edges[n / 2]);
    const auto may_meet = [&own](const Boxes::Box& box) { return Boxes::meet(own, box); };
    std::vector<std::size_t> up, down, right;
    boxes.ascending(n / 3, may_meet, [&](std::size_t i) { return up.push_back(i), false; });
    boxes.descending(may_meet, [&](std::size_t i) { return down.push_back(i), i == n / 2; });
    for (std::size_t i = n / 3; i < n; ++i) {
      if (may_meet(Boxes::box_of(edges[i]))) right.push_back(i);
    }
    CHECK(up == right);
    CHECK(down.back() == n / 2);
    CHECK(std::is_sorted(down.rbegin(), down.rend()));
  }
}

TEST_CASE("boxes: the least distance is the least of all edges that count") {
  for (std::size_t n = 3; n < 60; ++n) {
    const IntegerRing ring(n % 2 == 0 ? random_ring(n) : comb(n, true));
    const std::vector<Segment2<Integer>> edges = ring.edges();
    const Boxes boxes(edges);
    for (std::size_t v = 0; v < n; ++v) {
      const auto counts = [&](std::size_t i) { return i != v && (i + 1) % n != v; };
      std::optional<SquaredLength<Integer>> found, least;
      boxes.lessen(found, ring[v], counts);
      for (std::size_t i = 0; i < n; ++i) {
        if (!counts(i)) continue;
        auto distance = squared_distance(ring[v], edges[i], Extent::segment);
        if (!least || distance < *least) least = distance;
      }
      REQUIRE(found.has_value());
      CHECK(quotient(found->numerator, found->denominator) == quotient(least->numerator, least->denominator));
    }
  }
}

// Seconds; at 100 nanoseconds for each pair of edges each of these would be a quarter of an hour, and their limit in
// ctest is a third of that (cmake/proptests.cmake).
TEST_CASE("oracle: very long rings are answered") {
  constexpr std::size_t n = 100'000;
  CHECK(polygon_convexity(wavy_ring(n)).certificate().kind != "");
  CHECK(polygon_convexity(spoilt_at_the_end(wavy_ring(n))).certificate().kind != "");
  CHECK(polygon_convexity(comb(n, true)).certificate().kind != "");
  CHECK_NOTHROW(polygon_polygon(wavy_ring(n), moved(wavy_ring(n), 5)));
  CHECK_NOTHROW(polygon_polygon(wavy_ring(n), moved(wavy_ring(n), 1)));
}

}  // namespace touchstone::proptests::rings_tests
