// SPDX-License-Identifier: Apache-2.0
#include "catalogue/operation/probes/synonyms.h"

#include <algorithm>
#include <set>

#include "catalogue/operation/operation.h"
#include "proptests/catch.h"
#include "proptests/uses.h"

namespace touchstone::proptests::synonyms_tests {
namespace {

using catalogue::nearest_operations;
using catalogue::Synonym;
using catalogue::synonyms;
using Names = std::vector<std::string>;

}  // namespace

TEST_CASE("synonyms: every target is an operation of the catalogue, named once") {
  CHECK(synonyms().size() > 60);
  for (const auto& [phrase, operations] : synonyms()) {
    INFO(phrase);
    CHECK_FALSE(operations.empty());
    std::set<std::string> named;
    for (const char* operation : operations) {
      INFO(operation);
      CHECK(catalogue::find_operation(operation) != nullptr);
      CHECK(named.insert(operation).second);
    }
  }
}

TEST_CASE("synonyms: phrases stand in the order of the alphabet, each once, and are no operations") {
  const auto& table = synonyms();
  for (std::size_t i = 0; i < table.size(); ++i) {
    INFO(table[i].phrase);
    if (i > 0) CHECK(std::string(table[i - 1].phrase) < table[i].phrase);
    CHECK(catalogue::find_operation(table[i].phrase) == nullptr);
  }
}

TEST_CASE("synonyms: a phrase of the table leads to its own operations first, in their order") {
  for (const auto& [phrase, operations] : synonyms()) {
    INFO(phrase);
    const Names nearest = nearest_operations(phrase, operations.size());
    REQUIRE_FALSE(nearest.empty());
    CHECK(nearest[0] == operations[0]);
    for (const std::string& name : nearest)
      CHECK(std::find(operations.begin(), operations.end(), name) != operations.end());
  }
}

TEST_CASE("synonyms: what no operation computes is said so, and has neighbours") {
  for (const auto& [phrase, what] : catalogue::not_computed()) {
    INFO(phrase);
    CHECK(catalogue::why_not_computed(phrase) == std::string("no operation computes ") + what);
    CHECK_FALSE(nearest_operations(phrase, 3).empty());
  }
  CHECK(catalogue::why_not_computed("BooleanUnion").ends_with("a difference of solids or areas"));
  CHECK(catalogue::why_not_computed("penetration_depth").empty());
  CHECK(catalogue::why_not_computed("segment_segment").empty());
  CHECK(catalogue::why_not_computed("areal").empty());
}

TEST_CASE("synonyms: the words are the same however they are joined") {
  const Names rays{"ray_triangle", "ray_aabb", "ray_sphere"};
  for (const char* spelt : {"raycast", "ray_cast", "ray-cast", "RayCast", "Ray casts", "rayCast"}) {
    INFO(spelt);
    CHECK(nearest_operations(spelt, 3) == rays);
  }
  CHECK(nearest_operations("GJKDistance", 1) == Names{"convex_distance"});
}

TEST_CASE("synonyms: a phrase meets the other words of a name") {
  CHECK(nearest_operations("sphere_box", 1) == Names{"sphere_aabb"});
  CHECK(nearest_operations("mesh_contains_point", 1) == Names{"point_in_polyhedron"});
  CHECK(nearest_operations("box_vs_plane", 1) == Names{"aabb_plane"});
  CHECK(nearest_operations("ray_box", 1) == Names{"ray_aabb"});
  CHECK(nearest_operations("triangle_cube", 1) == Names{"triangle_aabb"});
}

TEST_CASE("synonyms: where no word fits, nothing is near") {
  CHECK(nearest_operations("juggle", 3).empty());
  CHECK(nearest_operations("", 3).empty());
  CHECK(nearest_operations("___", 3).empty());
  CHECK(nearest_operations(std::string(1'000'000, 'a'), 3).empty());
  CHECK(nearest_operations("satellite", 3).empty());  // no word of it is "sat"
}

}  // namespace touchstone::proptests::synonyms_tests
