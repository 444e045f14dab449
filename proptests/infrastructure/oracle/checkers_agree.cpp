// SPDX-License-Identifier: Apache-2.0
#include <gmpxx.h>

#include <cmath>

#include "oracle/certificates/check.h"
#include "proptests/catch.h"
#include "proptests/infrastructure/oracle/claims.h"
#include "proptests/property.h"

namespace touchstone::proptests::checkers_agree_tests {
namespace {

using catalogue::DrawStream;
using nlohmann::json;

const char* const script = "proptests/infrastructure/oracle/checkers_agree.py ";

/// What both checkers were shown, and what the C++ one said.
struct Shown {
  std::vector<std::string> claims, verdicts;

  bool accepts(const json& claim) {
    const auto refused = certify::refuse(claim);
    claims.push_back(claim.dump()), verdicts.push_back(refused.value_or("accepted"));
    return !refused;
  }

  bool said_in_python_too() const {
    const LinesInFile all_claims("claims.jsonl", claims), all_verdicts("verdicts.txt", verdicts);
    return python_finds_nothing(script + all_claims.path() + " " + all_verdicts.path());
  }
};

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

/// An exact value near to, or made from, the one that stands there.
std::string altered(DrawStream& draws, const std::string& text) {
  const mpq_class value(text);
  const mpq_class near_one = 1 + mpq_class(1, mpz_class(1) << 50);
  switch (draws.below(7)) {
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

TEST_CASE(
    "certificates: both checkers name the first number that is not finite, in the order of the operation's shapes") {
  std::vector<std::string> lines, verdicts;
  for (const catalogue::Operation* operation : catalogue::all_operations()) {
    if (operation->metadata().is_implementation()) continue;
    for (catalogue::Question question : operation->zeros_of_alternatives()) {
      const std::size_t count = question.numbers.size();
      for (std::size_t first = 0; first < count; ++first) {
        // All from here on, and every rule of the shapes broken: zeros are no directions, no masses.
        for (std::size_t i = 0; i < count; ++i) question.numbers[i] = i < first ? 0 : i % 2 == 0 ? HUGE_VAL : -HUGE_VAL;
        try {
          operation->row().solve(question);
          FAIL("answered");
        } catch (const InvalidInput& refused) {
          REQUIRE(refused.rule() == "finite number");
          lines.push_back("{\"op\":\"" + operation->name() +
                          "\",\"input\":" + catalogue::one_line(operation->print(question)) +
                          ",\"refused\":{\"field\":\"" + refused.field() + "\",\"rule\":\"finite number\"}}");
          verdicts.push_back(certify::refuse_text(lines.back()).value_or("accepted"));
          CHECK(verdicts.back() == "accepted");
        }
      }
    }
  }
  const LinesInFile all_claims("not_finite.jsonl", lines), all_verdicts("not_finite.txt", verdicts);
  CHECK(python_finds_nothing(script + all_claims.path() + " " + all_verdicts.path()));
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

TEST_CASE("certificates: both checkers verify every vector of a refused input, and refuse another field or rule") {
  Shown shown;
  int vectors = 0;
  for (const auto& file : std::filesystem::directory_iterator("vectors")) {
    if (file.path().extension() != ".jsonl") continue;
    std::ifstream in(file.path());
    int of_operation = 0;
    for (std::string line; std::getline(in, line);) {
      json vector = json::parse(line);
      if (!vector.contains("refused")) continue;
      if (line.find("\"meshes/") != std::string::npos) continue;  // named files are asked of both in named_files.cpp
      CAPTURE(line);
      CHECK(shown.accepts(vector));
      if (++of_operation % 8 != 0) continue;  // the others would say the same, in Python at length
      for (const char* part : {"field", "rule"}) {
        json wrong = vector;
        wrong["refused"][part] = wrong["refused"][part].get<std::string>() + "!";
        CHECK(!shown.accepts(wrong));
      }
    }
    vectors += of_operation;
  }
  CHECK(vectors > 1500);
  CHECK(shown.said_in_python_too());
}

TEST_CASE("certificates: both programs say the same of odd JSON, line by line, and of its bytes") {
  const std::string claim =
      R"({"op":"explicit_line","input":{"slope":0,"intercept":1,"point":[1,4]},"truth":{"side":"above"},)"
      R"("certificate":{"kind":"height","height":["3"]})";
  const std::string face =
      R"({"op":"point_in_convex_polyhedron","input":{"point":[1,1,1],)"
      R"("mesh":{"vertices":[[0,0,0],[4,0,0],[0,4,0],[0,0,4]],"faces":[[-0,2,1],[0,1,3],[0,3,2],[1,2,3]]}},)"
      R"("truth":{},"certificate":{}})";
  const auto with_slope = [&claim](const std::string& slope) {
    std::string text = claim + "}";
    return text.replace(text.find("\"slope\":0") + 8, 1, slope);
  };
  const auto with_height = [&claim](const std::string& height) {
    std::string text = claim + "}";
    return text.replace(text.find("\"3\""), 3, height);
  };
  const std::string long_digits(10'000'000, '3');
  const std::vector<std::string> lines{claim + "}",
                                       claim + R"(,"x":1e999})",
                                       claim + R"(,"x":-1e999})",
                                       with_slope("1e999"),
                                       with_slope("1e-999"),
                                       with_slope("18446744073709551616"),
                                       with_slope("-0"),
                                       with_slope(long_digits),
                                       with_slope("0." + long_digits),
                                       with_slope("NaN"),
                                       with_slope("Infinity"),
                                       with_slope("01"),
                                       with_slope("0x1"),
                                       with_slope("\"inf\""),
                                       with_height("\"" + long_digits + "\""),
                                       with_height("\"3/" + std::string(100'000, '1') + "\""),
                                       "\xef\xbb\xbf" + claim + "}",
                                       claim + "}" + std::string("\0 more", 6),
                                       claim + R"(,"x":"\ud800"})",
                                       claim + R"(,"\udc00":1})",
                                       claim + R"(,"x":"\ud83d\ude00"})",
                                       claim + ",\"x\":\"\xed\xa0\x80\"}",
                                       claim + ",\"x\":\"\xff\"}",
                                       claim + ",\"x\":\"\xc0\x80\"}",
                                       claim + ",\"x\":\"\t\"}",
                                       claim + R"(,"x":"\u0000"})",
                                       claim + R"(,"op":"orientation"})",
                                       claim + R"(,"x":{"y":1,"y":"\ud800"}})",
                                       "\f",
                                       claim + "} x",
                                       "null",
                                       "1",
                                       "\"x\"",
                                       claim + "}\r",
                                       claim + ",}",
                                       "'",
                                       face,
                                       claim + ",\"x\":" + std::string(70, '[') + "\xff"};
  const LinesInFile file("odd.jsonl", lines), said("said.txt", {});
  const std::string command = "python3 oracle/certificates/certify.py " + file.path() + " > " + said.path();
  if (!python_finds_nothing("-c pass") || std::system(command.c_str()) == -1) return;
  std::ifstream in(said.path().substr(1, said.path().size() - 2));
  std::vector<std::string> in_python(lines.size(), "accepted");
  for (std::string line; std::getline(in, line);) {
    const std::size_t at = line.find(".jsonl:");
    if (at == std::string::npos) continue;
    const std::size_t end = line.find(": ", at);
    in_python.at(std::stoul(line.substr(at + 7, end - at - 7)) - 1) = line.substr(end + 2);
  }
  std::size_t accepted = 0;
  for (std::size_t i = 0; i < lines.size(); ++i) {
    CAPTURE(i, lines[i].substr(0, 400));
    const std::string in_cpp = certify::refuse_text(lines[i]).value_or("accepted");
    CHECK(in_python[i] == in_cpp);
    accepted += in_cpp == "accepted";
  }
  CHECK(in_python[0] == "accepted");
  CHECK(in_python[1] == "not JSON");
  CHECK(in_python[14] == "certificate.height[0]: at most 100000 characters");
  CHECK(accepted >= 5);
}

TEST_CASE("certificates: both checkers accept what the oracle claims") {
  Shown shown;
  const auto claims = drawn_claims("claims", static_cast<std::uint64_t>(scaled(4)));
  REQUIRE(claims.size() > 500);
  for (const json& claim : claims) CHECK(shown.accepts(claim));
  CHECK(shown.said_in_python_too());
}

TEST_CASE("certificates: both checkers refuse another truth, for the same reason") {
  Shown shown;
  DrawStream draws = DrawStream::seeded(catalogue::seed_of(1, "other truths", 0));
  for (const json& claim : drawn_claims("other truths", static_cast<std::uint64_t>(scaled(3)))) {
    // Of a grown ball a claim proves that it holds every point and is not too large; so may be another.
    if (claim["certificate"]["kind"] == "lower_bound") continue;
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
        broken[place] = claim[place].get<unsigned>() + 1 + draws.below(3);
        CAPTURE(broken.dump());
        CHECK(!shown.accepts(broken));
      }
      if (!claim[place].is_string()) continue;
      const std::string value = claim[place];
      const std::size_t root = value.find("sqrt(");
      if (root != std::string::npos) {
        const mpz_class radicand(value.substr(root + 5, value.size() - root - 6)), next(radicand + 1);
        json broken = claim;
        broken[place] = value.substr(0, root + 5) + next.get_str() + ")";
        CAPTURE(broken.dump());
        CHECK(!shown.accepts(broken));
        continue;
      }
      if (value.find_first_not_of("-0123456789/") != std::string::npos) continue;
      const std::string other = altered(draws, value);
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

}  // namespace touchstone::proptests::checkers_agree_tests
