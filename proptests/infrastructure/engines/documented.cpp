// SPDX-License-Identifier: Apache-2.0
#include <unistd.h>

#include <filesystem>
#include <fstream>
#include <iterator>

#include "audit/engines/engine.h"
#include "proptests/catch.h"
#include "proptests/infrastructure/program/called.h"
#include "proptests/uses.h"

/// The engines that the documentation shows: each works as it stands there.
namespace touchstone::proptests::documented_tests {
namespace {

std::string text_of(const std::string& file) {
  std::ifstream in(file);
  REQUIRE(in);
  return std::string(std::istreambuf_iterator<char>(in), {});
}

/// The first block of code in a language.
std::string block_of(const std::string& file, const std::string& language) {
  const std::string text = text_of(file), fence = "```" + language + "\n";
  const std::size_t begin = text.find(fence);
  REQUIRE(begin != std::string::npos);
  return text.substr(begin + fence.size(), text.find("```\n", begin + fence.size()) - begin - fence.size());
}

void require_answers(const std::string& command, const std::vector<std::string>& operations) {
  const auto engine = pipe_engine(command, 60);
  for (const Operation* operation : all_operations()) {
    const auto found = std::find(operations.begin(), operations.end(), operation->name());
    INFO(operation->name());
    REQUIRE(engine->supports(operation->name()) == (found != operations.end()));
  }
  REQUIRE(engine->declaration().boundary == Declaration::Boundary::closed);
  const auto replies =
      engine->ask(*find_operation("segment_segment"), {{{0, 0, 2, 2, 0, 2, 2, 0}}, {{0, 0, 2, 2, 3, 2, 4, 0}}});
  REQUIRE(replies[0].kind == Reply::Kind::answered);
  REQUIRE(replies[0].answer == true);
  REQUIRE(replies[1].answer == false);
  // -1 in exact arithmetic, 0 in doubles: a question's integers are doubles.
  const Operation& orientation = *find_operation("orientation");
  if (engine->supports("orientation")) {
    const auto side = engine->ask(orientation, {{{0, 0, 134217729, 134217728, 134217728, 134217727}}});
    REQUIRE(side[0].answer["side"] == "on");
  }
}

}  // namespace

TEST_CASE("documented: the engines of examples/ answer") {
  require_answers("python3 examples/engine.py", {"orientation", "segment_segment"});
}

TEST_CASE("documented: the engine that README.md shows answers when it is copied") {
  const auto copy = std::filesystem::temp_directory_path() / (std::to_string(::getpid()) + "_readme_engine.py");
  std::ofstream(copy) << block_of("README.md", "python");
  require_answers("python3 " + copy.string(), {"segment_segment"});
  std::filesystem::remove(copy);
}

TEST_CASE("documented: docs/engines.md shows examples/engine.py") {
  const std::string example = text_of("examples/engine.py");
  REQUIRE(block_of("docs/engines.md", "python") == example.substr(example.find("import json")));
}

TEST_CASE("documented: docs/engines.md lists what every operation is given and answers") {
  const auto without = [](std::string text, const std::string& letters) {
    std::erase_if(text, [&](char letter) { return letters.find(letter) != std::string::npos; });
    return text;
  };
  const std::string page = without(text_of("docs/engines.md"), " \\");
  for (const Operation* operation : all_operations()) {
    const Json described = operation->question_description();
    std::string inputs;
    for (const Json& input : described.is_array() ? described : Json::array({described}))
      inputs += (inputs.empty() ? "`" : "`or`") + input.dump();
    const std::string row = "|`" + operation->name() + "`|" + inputs + "`|`" + operation->answer_description().dump();
    INFO(row);
    const bool listed = page.find(without(row, " ") + "`|") != std::string::npos;
    CHECK(listed != operation->metadata().is_implementation());
  }
}

TEST_CASE("documented: docs/testing.md shows a strategy of examples/own_tests") {
  const std::string block = block_of("docs/testing.md", "python");
  const std::string strategy = block.substr(0, block.find("\n\n"));
  REQUIRE_THAT(strategy, StartsWith("def questions("));
  REQUIRE_THAT(text_of("examples/own_tests/test_hypothesis.py"), ContainsSubstring(strategy));
}

TEST_CASE("documented: docs/operations.md is what the program prints") {
  const Called page = called({"ops", "--markdown"});
  CHECK(page.code == nothing_found);
  CHECK(page.out == text_of("docs/operations.md"));
}

TEST_CASE("documented: docs/operations.md lists each operation, and names each method") {
  const std::string page = text_of("docs/operations.md");
  for (const Operation* operation : all_operations()) {
    const bool listed = page.find("\n### `" + operation->name() + "`\n") != std::string::npos;
    CHECK(listed != operation->metadata().is_implementation());
    CHECK_THAT(page, ContainsSubstring("`" + operation->name() + "`"));
  }
}

}  // namespace touchstone::proptests::documented_tests
