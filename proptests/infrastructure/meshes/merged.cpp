// SPDX-License-Identifier: Apache-2.0
#include "audit/meshes/merged.h"

#include <cmath>
#include <limits>
#include <random>

#include "proptests/catch.h"

namespace touchstone::proptests::merged_tests {
namespace {

using Vertices = std::vector<Point3d>;
using Into = std::vector<Index>;

/// Single linkage by its definition: each vertex takes the least number that a near one has, until nothing changes.
Into by_definition(const Vertices& vertices, double reach) {
  Into into(vertices.size());
  for (Index v = 0; v < into.size(); ++v) into[v] = v;
  for (bool changed = true; changed;) {
    changed = false;
    for (Index v = 0; v < into.size(); ++v) {
      for (Index w = 0; w < into.size(); ++w) {
        const Vector3d d = vertices[v] - vertices[w];
        const double apart = std::hypot(d.x, d.y, d.z);
        if ((apart == 0 || apart < reach) && into[w] < into[v]) into[v] = into[w], changed = true;
      }
    }
  }
  return into;
}

}  // namespace

TEST_CASE("merged vertices: tolerance 0 merges equal positions, -0 and 0 alike, and no others") {
  const auto merging = audit::merging_of({{1, 0, 0}, {0, 0, 0}, {-0.0, 0, -0.0}, {1, 0, 5e-324}, {1, 0, 0}}, 0);
  CHECK(merging.into == Into{0, 1, 1, 3, 0});
  CHECK(merging.merged == 2);
  CHECK(merging.largest == 0);
}

TEST_CASE("merged vertices: a chain of near vertices is one, and what is as far apart as the tolerance is not near") {
  const auto merging = audit::merging_of({{0, 0, 0}, {1.5, 0, 0}, {0.75, 0, 0}, {1024, 0, 0}, {1023, 0, 0}}, 0x1p-10);
  CHECK(merging.into == Into{0, 0, 0, 3, 4});
  CHECK(merging.merged == 2);
  CHECK(merging.largest == 1.5);
}

TEST_CASE("merged vertices: the grid finds the pairs that the definition finds") {
  std::mt19937_64 draw(1);
  const auto cell = [&draw](unsigned most) { return static_cast<double>(draw() % most); };
  for (int turn = 0; turn < 50; ++turn) {
    Vertices vertices{{0, 0, 0}, {4096, 4096, 4096}};
    for (int i = 0; i < 150; ++i) vertices.push_back({300 + cell(40) / 4, 300 + cell(40) / 4, 300 + cell(40) / 4});
    const double tolerance = 0x1p-12 * (1 + cell(8) / 4), size = audit::size_of(vertices);
    REQUIRE(size == 4096);
    CHECK(audit::merging_of(vertices, tolerance).into == by_definition(vertices, tolerance * size));
  }
}

TEST_CASE("merged vertices: the greatest and the least doubles do not overflow") {
  constexpr double most = std::numeric_limits<double>::max();
  CHECK(audit::merging_of({{-most, 0, 0}, {most, 0, 0}, {-most, most * 0x1p-40, 0}}, 1e-9).into == Into{0, 1, 0});
  CHECK(audit::merging_of({{0, 0, 0}, {5e-324, 0, 0}}, 1e-9).into == Into{0, 1});
  CHECK(audit::merging_of({{0, 0, 0}, {0, 0, 0}}, 1e-9).into == Into{0, 0});
  CHECK(audit::merging_of({}, 1e-9).into.empty());
}

}  // namespace touchstone::proptests::merged_tests
