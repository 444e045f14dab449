// SPDX-License-Identifier: Apache-2.0
#include <gmpxx.h>

#include <set>

#include "oracle/certificates/check.h"
#include "proptests/catch.h"
#include "proptests/machine/oracle/claims.h"

namespace touchstone::proptests {
namespace {

using audit::Choices;
using nlohmann::json;

const char* const script = "proptests/machine/oracle/checkers_agree.py ";

/// What both checkers were shown, and what the C++ one said.
struct Shown {
  std::vector<std::string> claims, verdicts;
  int accepted = 0;

  bool accepts(const json& claim) {
    const auto refused = certify::refuse(claim);
    claims.push_back(claim.dump()), verdicts.push_back(refused.value_or("accepted"));
    accepted += !refused;
    return !refused;
  }

  bool said_in_python_too() const {
    const LinesInFile all_claims("claims.jsonl", claims), all_verdicts("verdicts.txt", verdicts);
    return python_finds_nothing(script + all_claims.path() + " " + all_verdicts.path());
  }
};

json one_of(Choices& choices, const json& list) { return list[choices.below(list.size())]; }

/// The pointers of all leaves below one field; an empty list is none.
std::vector<json::json_pointer> leaves(const json& claim, const char* field) {
  std::vector<json::json_pointer> found;
  const json flat = claim[field].flatten();
  for (const auto& leaf : flat.items()) {
    if (leaf.key().empty() || leaf.value().is_null()) continue;
    found.push_back(json::json_pointer("/" + std::string(field) + leaf.key()));
  }
  return found;
}

/// Of many places some, as far from one another as can be: what is wrong with one angle of a hundred is wrong with the
/// others.
std::vector<json::json_pointer> some_of(std::vector<json::json_pointer> places) {
  constexpr std::size_t enough = 8;
  for (std::size_t i = 0; i < enough && places.size() > enough; ++i) places[i] = places[i * places.size() / enough];
  if (places.size() > enough) places.resize(enough);
  return places;
}

/// Every kind of certificate, each once.
json kinds_of(const std::vector<json>& claims) {
  std::set<std::string> kinds;
  for (const json& claim : claims) {
    for (const auto& place : leaves(claim, "certificate")) {
      if (place.back() == "kind") kinds.insert(claim[place].get<std::string>());
    }
  }
  return kinds;
}

const json junk = {nullptr,  true,           -7,         2.5,      "",    "x",   "1/0", "0/5", "-0",  "+1",
                   "1e5",    " 1",           "1 ",       "0x1p+0", "nan", "inf", "0x",  "--",  "1/-", "0x.",
                   "0x1p-1", "0x1p99999999", "-0x1.8p3", 1e308};

/// An exact value near to, or made from, the one that stands there.
std::string altered(Choices& choices, const std::string& text) {
  const mpq_class value(text);
  const mpq_class near_one = 1 + mpq_class(1, mpz_class(1) << 50);
  switch (choices.below(7)) {
    case 0: return mpq_class(value + 1).get_str();
    case 1: return mpq_class(-value).get_str();
    case 2: return mpq_class(value * 2).get_str();
    case 3: return mpq_class(value * near_one).get_str();
    case 4: return mpq_class(value + mpq_class(1, mpz_class(1) << 1200)).get_str();
    case 5: return "1";
    default: return "0";
  }
}

}  // namespace

TEST_CASE("certificates: the Python checker judges the files of claims as the C++ checker does") {
  std::vector<std::string> claims;
  for (const auto& file : std::filesystem::directory_iterator("oracle/certificates/claims")) {
    std::ifstream in(file.path());
    for (std::string line; std::getline(in, line);) claims.push_back(line);
  }
  REQUIRE(claims.size() > 300);
  CHECK(python_finds_nothing(script + LinesInFile("claims.jsonl", claims).path()));
}

TEST_CASE("certificates: both programs count refused inputs beside the certificates and find nothing in them") {
  const LinesInFile vectors("vectors.jsonl",
                            {R"({"op":"line_line","input":{},"refused":{"field":"a","rule":"two distinct points"}})"});
  const LinesInFile broken("broken.jsonl", {R"({"op":"line_line","input":{}})"});
  CHECK(python_finds_nothing("oracle/certificates/certify.py " + vectors.path()));
  CHECK(!python_finds_nothing("oracle/certificates/certify.py " + broken.path()));
}

TEST_CASE("certificates: both checkers refuse a claim nested 100,000 deep, for that reason") {
  std::vector<std::string> lines, verdicts;
  for (const std::size_t depth : {1u, 62u, 63u, 64u, 65u, 100'000u}) {
    const std::string open(depth, '['), close(depth, ']');
    for (const std::string& line : {open + close, open, "{\"op\":" + open + close + "}", "[\"\\\"" + open + "\"]"}) {
      lines.push_back(line), verdicts.push_back(*certify::refuse_text(line));
    }
  }
  CHECK(verdicts.back() == "claim: an object");
  CHECK(verdicts[verdicts.size() - 2] == "claim: nested at most 64 deep");
  const LinesInFile all_lines("lines.jsonl", lines), all_verdicts("verdicts.txt", verdicts);
  CHECK(python_finds_nothing(script + all_lines.path() + " " + all_verdicts.path()));
}

TEST_CASE("certificates: both checkers accept what the oracle claims") {
  Shown shown;
  const auto claims = drawn_claims("claims", 4);
  REQUIRE(claims.size() > 500);
  for (const json& claim : claims) CHECK(shown.accepts(claim));
  CHECK(shown.said_in_python_too());
}

TEST_CASE("certificates: both checkers refuse another truth, for the same reason") {
  Shown shown;
  Choices choices = Choices::seeded(audit::seed_of(1, "other truths", 0));
  for (const json& claim : drawn_claims("other truths", 3)) {
    for (const auto& place : some_of(leaves(claim, "truth"))) {
      if (claim[place].is_boolean()) {
        json broken = claim;
        broken[place] = !claim[place].get<bool>();
        CAPTURE(broken.dump());
        CHECK(!shown.accepts(broken));
        continue;
      }
      if (claim[place].is_number_unsigned()) {  // a place in a list
        json broken = claim;
        broken[place] = claim[place].get<unsigned>() + 1 + choices.below(3);
        CAPTURE(broken.dump());
        CHECK(!shown.accepts(broken));
      }
      if (!claim[place].is_string()) continue;
      const std::string value = claim[place];
      if (value.find_first_not_of("-0123456789/") != std::string::npos) continue;
      const std::string other = altered(choices, value);
      // An enclosure proves what the number rounds to, and no more than 2^-60 of a last place, which is 2^-1134 for the
      // smallest.
      const mpq_class gap = abs(mpq_class(mpq_class(other) - mpq_class(value)));
      const bool close = claim["certificate"]["kind"] == "enclosure" &&
                         (gap < abs(mpq_class(value)) / 1e16 || gap < mpq_class(1, mpz_class(1) << 1134));
      json broken = claim;
      broken[place] = other;
      CAPTURE(broken.dump());
      if (other != value && !close) CHECK(!shown.accepts(broken));
    }
  }
  CHECK(shown.claims.size() > 500);
  CHECK(shown.said_in_python_too());
}

TEST_CASE("certificates: both checkers say the same of altered certificates and of junk in any place") {
  Shown shown;
  Choices choices = Choices::seeded(audit::seed_of(1, "altered", 0));
  const auto claims = drawn_claims("altered", 2);
  const json kinds = kinds_of(claims);
  for (const json& claim : claims) {
    for (const auto& place : some_of(leaves(claim, "certificate"))) {
      json broken = claim;
      broken[place] =
          place.back() == "kind" ? one_of(choices, kinds).get<std::string>() : altered(choices, claim[place]);
      shown.accepts(broken);
    }
    for (const char* field : {"input", "truth", "certificate"}) {
      const auto places = leaves(claim, field);
      if (places.empty()) continue;
      json broken = claim;
      broken[places[choices.below(places.size())]] = one_of(choices, junk);
      shown.accepts(broken);
      broken = claim;
      broken[field].erase(broken[field].begin());
      CHECK(!shown.accepts(broken));
      broken = claim;
      broken[field]["more"] = "1";
      CHECK(!shown.accepts(broken));
    }
  }
  CHECK(shown.accepted > 0);  // a certificate may be altered and still prove the truth
  CHECK(shown.claims.size() > 20 * static_cast<std::size_t>(shown.accepted) / 19);
  CHECK(shown.said_in_python_too());
}

}  // namespace touchstone::proptests
