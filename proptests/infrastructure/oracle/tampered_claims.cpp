// SPDX-License-Identifier: Apache-2.0
#include <array>
#include <map>
#include <set>

#include "oracle/certificates/check.h"
#include "proptests/catch.h"
#include "proptests/infrastructure/oracle/claims.h"
#include "proptests/infrastructure/oracle/tampering.h"
#include "proptests/property.h"

namespace touchstone::proptests::tampered_claims_tests {
namespace {

using catalogue::DrawStream;
using nlohmann::json;

/// The true claims of every file, by operation. The test program runs in the source folder.
std::map<std::string, std::vector<json>> written_claims() {
  std::map<std::string, std::vector<json>> found;
  for (const auto& file : std::filesystem::directory_iterator("oracle/certificates/claims")) {
    std::ifstream in(file.path());
    for (std::string line; std::getline(in, line);) {
      if (json claim = json::parse(line); !claim.contains("refused")) found[claim["op"]].push_back(std::move(claim));
    }
  }
  return found;
}

std::map<std::string, Tampering> tamperings(const std::map<std::string, std::vector<json>>& written) {
  std::set<std::string> kinds;
  for (const auto& [operation, claims] : written) {
    for (const json& claim : claims) kinds.insert(claim["certificate"]["kind"]);
  }
  std::map<std::string, Tampering> found;
  for (const auto& [operation, claims] : written) found.try_emplace(operation, claims, kinds);
  return found;
}

std::string without_digits(std::string text) {
  std::erase_if(text, [](char c) { return c >= '0' && c <= '9'; });
  return text;
}

/// What the C++ checker says of tampered claims. The Python checker is slower: of the claims that are tampered with in
/// the same place and refused for the same reason it gets the first.
class Verdicts {
 public:
  /// Whether it is accepted.
  bool add(const json& genuine, const json::json_pointer& place, const json& claim) {
    const std::string verdict = certify::refuse(claim).value_or("accepted");
    const std::string reason = without_digits(verdict);
    reasons_.insert(reason);
    const Alike alike{genuine["op"], genuine["certificate"]["kind"], without_digits(place.to_string()), reason};
    if (alike_.insert(alike).second) claims_.push_back(claim.dump()), verdicts_.push_back(verdict);
    return verdict == "accepted";
  }

  std::size_t reasons() const { return reasons_.size(); }

  bool python_agrees() const {
    const LinesInFile claims("claims.jsonl", claims_), verdicts("verdicts.txt", verdicts_);
    return python_finds_nothing("proptests/infrastructure/oracle/checkers_agree.py " + claims.path() + " " +
                                verdicts.path());
  }

 private:
  using Alike = std::array<std::string, 4>;
  std::set<Alike> alike_;
  std::set<std::string> reasons_;
  std::vector<std::string> claims_, verdicts_;
};

}  // namespace

TEST_CASE("certificates: written claims made malformed are refused, and of altered ones both checkers say the same") {
  Verdicts verdicts;
  const auto written = written_claims();
  for (const auto& [operation, tampering] : tamperings(written)) {
    for (const json& claim : written.at(operation)) {
      for (const auto& place : Tampering::places(claim)) {
        for (const json& changed : Tampering::malformed(claim, place)) {
          if (verdicts.add(claim, place, changed)) FAIL_CHECK(changed.dump());
        }
        for (const json& changed : tampering.altered(claim, place)) verdicts.add(claim, place, changed);
      }
    }
  }
  CHECK(verdicts.reasons() > 1000);
  CHECK(verdicts.python_agrees());
}

TEST_CASE("certificates: drawn claims made malformed are refused, and of altered ones both checkers say the same") {
  Verdicts verdicts;
  DrawStream draws = DrawStream::seeded(catalogue::seed_of(1, "tampered", 0));
  const auto by_operation = tamperings(written_claims());
  for (const json& claim : drawn_claims("tampered", static_cast<std::uint64_t>(scaled(2)))) {
    const Tampering& tampering = by_operation.at(claim["op"]);
    const auto places = Tampering::places(claim);
    for (int i = 0; i < 2; ++i) {
      const auto& place = places[draws.below(places.size())];
      for (const json& changed : Tampering::malformed(claim, place)) {
        if (verdicts.add(claim, place, changed)) FAIL_CHECK(changed.dump());
      }
      for (const json& changed : tampering.altered(claim, place)) verdicts.add(claim, place, changed);
    }
  }
  CHECK(verdicts.reasons() > 500);
  CHECK(verdicts.python_agrees());
}

}  // namespace touchstone::proptests::tampered_claims_tests
