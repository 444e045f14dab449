// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <set>

#include "audit/counting/easy_questions.h"
#include "audit/engines/protocol.h"
#include "proptests/catch.h"
#include "proptests/uses.h"

namespace touchstone::proptests::check_engine_tests {
namespace {

/// Six times the volume of the first mesh of a question. The words are the numbers of its vertices and faces, and the
/// faces.
double signed_volume(const std::vector<double>& numbers, const std::vector<Word>& words) {
  const auto at = [&](Word vertex, int axis) { return numbers[3 * vertex + axis] - numbers[axis]; };
  double sum = 0;
  for (Word f = 0; f < words[1]; ++f) {
    const Word a = words[2 + 3 * f], b = words[3 + 3 * f], c = words[4 + 3 * f];
    for (int k = 0; k < 3; ++k) {
      const int l = (k + 1) % 3, m = (k + 2) % 3;
      sum += at(a, k) * (at(b, l) * at(c, m) - at(b, m) * at(c, l));
    }
  }
  return sum;
}

}  // namespace

TEST_CASE("check-engine: every operation is offered, and no method of one") {
  const Json offered = parse_own_line(greeting())["ops"];
  for (const Operation* operation : all_operations()) {
    INFO(operation->name());
    CHECK(std::count(offered.begin(), offered.end(), operation->name()) ==
          (operation->metadata().is_implementation() ? 0 : 1));
  }
}

TEST_CASE("check-engine: every operation has five easy questions, or as many as it has, and robust answers them") {
  for (const Operation* operation : all_operations()) {
    if (operation->metadata().is_implementation()) continue;
    const auto easy = easy_questions(*operation);
    INFO(operation->name());
    CHECK(easy.size() == 5);
    std::set<std::string> asked;
    for (const EasyQuestion& one : easy) {
      CHECK_FALSE(one.examination->touch());
      CHECK(one.examination->judge_robust().verdict == Verdict::agree);
      asked.insert(one_line(operation->print(one.question)));
    }
    CHECK(asked.size() == easy.size());
  }
  for (const char* of_meshes : {"point_in_convex_polyhedron", "point_in_polyhedron", "swept_convex_polyhedra"})
    for (const EasyQuestion& one : easy_questions(*find_operation(of_meshes)))
      CHECK(signed_volume(one.question.numbers, one.question.words) > 0);
  const auto sides = easy_questions(*find_operation("orientation"));
  std::set<std::string> truths;
  for (const EasyQuestion& one : sides) truths.insert(one.examination->outcome());
  CHECK(truths == std::set<std::string>{"left", "right"});  // "on" is a touch
}

}  // namespace touchstone::proptests::check_engine_tests
