// SPDX-License-Identifier: Apache-2.0
#include "proptests/catch.h"
#include "proptests/uses.h"
#include "report/pages/html_finding.h"
#include "report/words/phrases.h"

/// Answers as sentences.
namespace touchstone::proptests::answers_in_words_tests {

TEST_CASE("answers in words: enumerators, numbers, tuples, lists and bodies") {
  const Operation& segments = *find_operation("segment_segment");
  CHECK(phrase(segments, Json{{"relation", "disjoint"}}) == "no common point");
  CHECK(phrase(segments, Json::parse(R"({"relation":"point","ta":0.5,"tb":"1/3","point":[1,2]})")) ==
        "a common point, ta = 0.5, tb = 1/3, point (1, 2)");
  CHECK(phrase(*find_operation("polygon_convexity"), std::string("not_simple/none")) ==
        "crossing itself, no orientation");
  CHECK(phrase(segments, Json(nullptr)) == "no answer");
  CHECK(sentence(segments, Json::parse(R"({"relation":"point","ta":"1234567890123/1234567890124"})")) ==
        "a common point, ta = about 1");
  const auto said = [](const char* operation, const char* answer) {
    return sentence(*find_operation(operation), Json::parse(answer));
  };
  CHECK(said("simulation_step", R"({"contacts":[[0,1]],"bodies":[{"position":[3.5,4,0],"velocity":["1/3",0,0]}]})") ==
        "contacts (0, 1); ball 0 ends at (3.5, 4, 0) with velocity (1/3, 0, 0)");
  CHECK(said("all_pairs", R"({"pairs":[]})") == "no pairs");
  CHECK(said("quadtree", R"({"replies":[{"bodies":[]},{"pairs":[[0,1],[1,2]]}]})") ==
        "reply 0: no bodies; reply 1: pairs (0, 1), (1, 2)");
  CHECK(said("triangulate_polygon", R"({"triangles":[[0,1,2],[0,2,3],[0,3,4],[0,4,5],[0,5,6]]})") ==
        "triangles (0, 1, 2), (0, 2, 3), (0, 3, 4), (0, 4, 5), \u2026");
  CHECK(said("interior_angles", R"({"angles":["about 1.5",1.5,1.5,1.5,1.5,1.5,1.5]})") ==
        "angles (\u22481.5, 1.5, 1.5, 1.5, 1.5, 1.5, \u2026)");
}

}  // namespace touchstone::proptests::answers_in_words_tests
