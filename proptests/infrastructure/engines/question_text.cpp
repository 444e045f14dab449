// SPDX-License-Identifier: Apache-2.0
#include "audit/engines/question_text.h"

#include <bit>

#include "audit/counting/audit_run.h"
#include "proptests/catch.h"
#include "proptests/property.h"

using namespace touchstone::audit;

namespace {

bool same_bits(const Question& a, const Question& b) {
  return std::equal(a.numbers.begin(), a.numbers.end(), b.numbers.begin(), b.numbers.end(), [](double x, double y) {
    return std::bit_cast<std::uint64_t>(x) == std::bit_cast<std::uint64_t>(y);
  });
}

}  // namespace

TEST_CASE(
    "question text: what is written reads back to the bit, here and by the codec, in every family of every operation") {
  for (const Operation* operation : all_operations()) {
    const QuestionText text(*operation);
    for (std::size_t family = 0; family < operation->families().size(); ++family) {
      for (int i = 0; i < touchstone::proptests::scaled(200); ++i) {
        DrawStream draws = case_draws(*operation, family, 1, i);
        const Question question = operation->draw(draws, family);
        std::string written;
        text.write(question, written);
        INFO(operation->name() << " " << written);
        const bool has_lists = !question.words.empty();  // those the codec alone reads
        Question read;
        REQUIRE(text.read(written, read) != has_lists);
        REQUIRE((has_lists || same_bits(read, question)));
        REQUIRE(same_bits(operation->parse(parse_line(written)), question));
      }
    }
  }
}

TEST_CASE("question text: whatever looks otherwise is left to the codec") {
  const QuestionText text(*find_operation("orientation"));
  Question question;
  REQUIRE(text.read(R"({"p0":[0,0],"p1":[1,0],"p":[0,1]})", question));
  for (const char* other : {R"({"p0":[0,0],"p1":[1,0],"p":[0,1]} )", R"({"p0": [0,0],"p1":[1,0],"p":[0,1]})",
                            R"({"p1":[0,0],"p0":[1,0],"p":[0,1]})", R"({"p0":[0,0],"p1":[1,0],"p":[0,inf]})",
                            R"({"p0":[0,0],"p1":[1,0],"p":[0,-nan]})", R"({"p0":[0,0],"p1":[1,0],"p":[0,1e999]})",
                            R"({"p0":[0,0],"p1":[1,0],"p":[0,"0x1p+0"]})", R"({"p0":[0,0],"p1":[1,0],"p":[0,])",
                            R"({"p0":[0,0],"p1":[1,0]})", "", "{"}) {
    INFO(other);
    REQUIRE_FALSE(text.read(other, question));
  }
}
