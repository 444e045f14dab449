// SPDX-License-Identifier: Apache-2.0
#include "audit/vectors/vectors.h"

#include <algorithm>
#include <fstream>
#include <set>

#include "catalogue/families/not_finite.h"
#include "catalogue/operation.h"
#include "proptests/catch.h"

/// What `vectors check` says of vectors that were changed by hand.
namespace touchstone::audit {
namespace {

using Line = nlohmann::json;

/// Vectors of an operation as they stand in vectors/; the test program runs in the source folder.
std::vector<Line> stored(const std::string& operation) {
  std::ifstream in("vectors/" + operation + ".jsonl");
  std::vector<Line> lines;
  for (std::string text; std::getline(in, text);) lines.push_back(Line::parse(text));
  REQUIRE(lines.size() > 20);
  return lines;
}

std::string complaint(const Line& line) { return vector_complaint(line.dump()); }

}  // namespace

TEST_CASE("vectors: a refusal of another field or rule, or of what is valid, is complained about") {
  int refusals = 0;
  for (const char* operation : {"line_line", "line_point_at", "ray_segment"}) {
    for (Line line : stored(operation)) {
      if (!line.contains("refused")) {
        line["refused"] = {{"field", "a"}, {"rule", "finite number"}};
        CHECK(complaint(line) == "not refused");
        continue;
      }
      ++refusals;
      CHECK(complaint(line).empty());
      Line other = line;
      other["refused"]["rule"] = "another rule";
      CHECK(complaint(other) == "refused otherwise");
      other = line;
      other["refused"]["field"] = "elsewhere";
      CHECK(complaint(other) == "refused otherwise");
    }
  }
  CHECK(refusals >= 10);
}

TEST_CASE("vectors: every operation has a vector for each of its numbers that is not finite") {
  for (const Operation* operation : catalogue()) {
    if (operation->card().is_method()) continue;
    std::set<std::string> fields;
    for (const Line& line : stored(operation->name())) {
      if (line["family"] != "not_finite") continue;
      CHECK(line["refused"]["rule"] == "finite number");
      fields.insert(line["refused"]["field"]);
    }
    std::set<std::string> wanted;
    for (const Question& zeros : operation->zeros_of_alternatives()) {
      for (std::size_t i = 0; i < zeros.numbers.size(); ++i) {
        try {
          operation->examine(with_not_finite(*operation, zeros, i, std::nan("")));
        } catch (const InvalidInput& refused) {
          wanted.insert(refused.field());
        }
      }
      CHECK(wanted.size() >= zeros.numbers.size());
    }
    CHECK(fields == wanted);
  }
}

TEST_CASE("vectors: a truth that its certificate allows and that is not the oracle's is complained about") {
  int changed = 0;
  for (Line line : stored("parametric_circle")) {
    if (line.contains("refused") || line["certificate"]["kind"] != "enclosure") continue;
    mpq_class x(line["truth"]["point"][0].get<std::string>());
    x *= 1 + mpq_class(1, mpz_class(1) << 115);
    line["truth"]["point"][0] = x.get_str();
    const std::string said = complaint(line);
    INFO(said);
    CHECK_FALSE(said.empty());
    changed += said.starts_with("the oracle's truth is");
  }
  CHECK(changed >= 10);
}

TEST_CASE("vectors: whatever else a vector says is complained about where it is not so") {
  const auto lines = stored("segment_segment");
  const auto valid = std::find_if(lines.begin(), lines.end(), [](const Line& line) { return line.contains("truth"); });
  REQUIRE(valid != lines.end());
  CHECK(complaint(*valid).empty());
  const auto changed = [&](const char* name, const Line& value) {
    Line other = *valid;
    other[name] = value;
    return complaint(other);
  };
  CHECK(changed("family", "stranger") == "family: one of the operation's families");
  CHECK_THAT(changed("margin", "1/7919"), StartsWith("margin is "));
  CHECK_THAT(changed("flags", {"stranger"}), StartsWith("flags is "));
  CHECK_THAT(changed("rounded", {{"relation", "stranger"}}), StartsWith("rounded is "));
  CHECK_THAT(changed("as_typed", {{"relation", "point"}}), StartsWith("as_typed is "));
}

TEST_CASE("vectors: what is no vector is complained about") {
  CHECK(vector_complaint("nonsense") == "line: one JSON object");
  CHECK(vector_complaint("[]") == "line: one JSON object");
  CHECK(vector_complaint("{}") == "touchstone: version 1");
  CHECK(vector_complaint(R"({"touchstone":2})") == "touchstone: version 1");
  CHECK(vector_complaint(R"({"touchstone":1,"op":"rotation"})") == "op: an operation of the catalogue");
  CHECK(vector_complaint(R"({"touchstone":1,"op":7})") == "op: an operation of the catalogue");
}

}  // namespace touchstone::audit
