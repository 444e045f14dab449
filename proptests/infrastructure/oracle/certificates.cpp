// SPDX-License-Identifier: Apache-2.0
#include <filesystem>
#include <fstream>
#include <limits>
#include <nlohmann/json.hpp>
#include <set>
#include <string>
#include <vector>

#include "catalogue/operation/operation.h"
#include "oracle/certificates/check.h"
#include "proptests/catch.h"
#include "proptests/infrastructure/oracle/claims.h"

namespace {

using nlohmann::json;
using namespace touchstone::certify;
using touchstone::proptests::LinesInFile;
using touchstone::proptests::python_finds_nothing;

/// The claims of every file; those that hold, or the false ones. The test program runs in the source folder.
std::vector<json> claims(bool refused) {
  std::set<std::filesystem::path> files;
  for (const auto& entry : std::filesystem::directory_iterator("oracle/certificates/claims"))
    files.insert(entry.path());
  std::vector<json> result;
  for (const auto& file : files) {
    std::ifstream in(file);
    for (std::string text; std::getline(in, text);) {
      if (json claim = json::parse(text); claim.contains("refused") == refused) result.push_back(std::move(claim));
    }
  }
  return result;
}

}  // namespace

TEST_CASE("certificates: true claims of every kind are accepted") {
  const auto all = claims(false);
  REQUIRE(all.size() >= 20);
  for (const json& claim : all) {
    CAPTURE(claim.dump());
    CHECK(refuse(claim) == std::nullopt);
  }
}

TEST_CASE("certificates: false claims of every sort are refused, each for its own reason") {
  const auto all = claims(true);
  REQUIRE(all.size() >= 50);
  for (const json& claim : all) {
    CAPTURE(claim.value("because", ""), claim.dump());
    CHECK(refuse(claim) == claim["refused"].get<std::string>());
  }
}

TEST_CASE("certificates: a claim without one of its four fields is refused") {
  const json claim = claims(false)[0];
  for (const char* part : {"op", "input", "truth", "certificate"}) {
    json broken = claim;
    broken.erase(part);
    CHECK(refuse(broken) == "claim: field " + std::string(part) + " is missing");
  }
}

TEST_CASE("certificates: no other word is accepted in place of the truth's") {
  json words = json::array();
  for (const touchstone::catalogue::Operation* operation : touchstone::catalogue::all_operations()) {
    for (const std::string& word : operation->words()) words.push_back(word);
  }
  std::size_t replaced = 0;
  for (const json& claim : claims(false)) {
    const json leaves = claim["truth"].flatten();
    for (const auto& leaf : leaves.items()) {
      const bool is_word = leaf.value().is_string() &&
                           leaf.value().get<std::string>().find_first_not_of("-0123456789/") != std::string::npos;
      const json others = is_word ? words : leaf.value().is_boolean() ? json{true, false} : json::array();
      for (const json& other : others) {
        json broken = claim;
        broken["truth"][json::json_pointer(leaf.key())] = other;
        CAPTURE(broken.dump());
        CHECK((broken == claim) == !refuse(broken).has_value());
        ++replaced;
      }
    }
  }
  CHECK(replaced > 200);
}

TEST_CASE("certificates: a test vector of a refused input is told from a claim") {
  CHECK(is_refused_input(R"({"op":"line_line","input":{},"refused":{"field":"a","rule":"two distinct points"}})"));
  CHECK(!is_refused_input(
      R"({"op":"line_line","input":{},"truth":{},"certificate":{},"refused":"truth: x is missing"})"));
  CHECK(!is_refused_input(R"({"op":"line_line","input":{},"certificate":{}})"));
  CHECK(!is_refused_input("{"));
  CHECK(!is_refused_input("[]"));
}

TEST_CASE("certificates: a refused input has to break the rule that is named, before all others") {
  const auto refused = [](const std::string& op, const std::string& input, const std::string& refusal) {
    return refuse_text("{\"op\":\"" + op + "\",\"input\":" + input + ",\"refused\":" + refusal + "}")
        .value_or("accepted");
  };
  const std::string same_points = R"({"a":[[0,0],[0,0]],"b":[[0,0],[1,1]]})",
                    of_a = R"({"field":"a","rule":"two distinct points"})";
  CHECK(refused("line_line", same_points, of_a) == "accepted");
  const std::string another = "refused: this is not the first rule that the input breaks";
  CHECK(refused("line_line", R"({"a":[[0,0],[0,1]],"b":[[0,0],[1,1]]})", of_a) == another);
  CHECK(refused("line_line", same_points, R"({"field":"b","rule":"two distinct points"})") == another);
  CHECK(refused("line_line", same_points, R"({"field":"a","rule":"finite number"})") == another);
  CHECK(refused("segment_segment", same_points, of_a) == another);
  CHECK(refused("line_line", R"({"a":[[0,0],["inf",0]],"b":[[0,0],[1,1]]})", of_a) == another);
  // Numbers come before all rules.
  CHECK(refused("line_line", R"({"a":[[0,0],[0,0]],"b":[[0,0],[1,"nan"]]})", of_a) == another);
  CHECK(refused("line_line", R"({"a":[[0,0],[0,0]],"b":[[0,0],[1,"nan"]]})",
                R"({"field":"b[1][1]","rule":"finite number"})") == "accepted");
  CHECK(refused("line_line", "{}", of_a) == another);
  CHECK(refused("line_line", "[]", of_a) == another);
  // What is said of a truth that is not there is no rule for the input.
  CHECK(refused("orientation", R"({"p0":[0,0],"p1":[1,0],"p":[0,1],"certificate":1})",
                R"({"field":"certificate","rule":"field kind is missing"})") == another);
  CHECK(refused("line_line", same_points, "null") == "refused: an object");
  CHECK(refused("line_line", same_points, R"({"field":"a"})") == "refused: field rule is missing");
  CHECK(refused("line_line", same_points, R"({"field":"a","rule":1})") == "refused: field and rule are strings");
  CHECK(refused("juggle", same_points, of_a) == "op: not an operation with certificates");
  CHECK(refuse_text(R"({"refused":{"field":"a","rule":"b"}})") == "claim: field op is missing");
  CHECK(refuse_text(R"({"refused":1})") == "claim: field op is missing");
}

TEST_CASE("certificates: a line does not both answer and refuse") {
  const std::string true_claim = R"({"op":"line_line","input":{"a":[[0,0],[2,2]],"b":[[0,2],[2,0]]},"truth":)"
                                 R"({"relation":"crossing","ta":"1/2","tb":"1/2","point":["1","1"]},)"
                                 R"("certificate":{"kind":"transversal","determinant":["-8"]})";
  CHECK(refuse_text(true_claim + "}") == std::nullopt);
  const std::string both = true_claim + R"(,"refused":{"field":"a","rule":"two distinct points"}})";
  CHECK(refuse_text(both) == "claim: a truth or refused, not both");
  const LinesInFile lines("both.jsonl", {both});
  CHECK(!python_finds_nothing("oracle/certificates/certify.py " + lines.path()));
}

TEST_CASE("certificates: text that is not JSON and numbers that are not finite are refused") {
  CHECK(refuse_text("") == "not JSON");
  CHECK(refuse_text("{\"op\":") == "not JSON");
  CHECK(refuse_text("[]") == "claim: an object");
  json claim = json::parse(R"({"op":"explicit_line","input":{"intercept":1,"point":[1,4]},"truth":{"side":"above"},)"
                           R"("certificate":{"kind":"height","height":["1"]}})");
  claim["input"]["slope"] = std::numeric_limits<double>::infinity();
  CHECK(refuse(claim) == "slope: finite number");
}
