// SPDX-License-Identifier: Apache-2.0
#include "proptests/drawn.h"
#include "proptests/each_operation.h"

// Where robust answers questions over columns, it answers as it does one by one.
namespace touchstone::proptests::arrays_tests {
namespace {

/// Valid questions of all families in turn.
std::vector<Question> valid_questions(const Operation& operation, std::size_t count) {
  std::vector<Question> questions;
  for (std::uint64_t i = 0; questions.size() < count; ++i) {
    const std::size_t family = i % operation.families().size();
    DrawStream draws = DrawStream::seeded(catalogue::seed_of(1, "arrays", i));
    Question question = operation.draw(draws, family);
    try {
      operation.row().decide(question, 0);
    } catch (const InvalidInput&) {
      continue;
    }
    questions.push_back(std::move(question));
  }
  return questions;
}

/// The questions as columns that start `shift` numbers after an aligned address.
struct Columns {
  std::vector<std::vector<double>> numbers;
  std::vector<const double*> starts;
  Columns(const std::vector<Question>& questions, std::size_t count, std::size_t shift)
      : numbers(questions[0].numbers.size()) {
    for (std::size_t k = 0; k < numbers.size(); ++k) {
      numbers[k].resize(shift + count);
      for (std::size_t i = 0; i < count; ++i) numbers[k][shift + i] = questions[i].numbers[k];
      starts.push_back(numbers[k].data() + shift);
    }
  }
};

}  // namespace

TEST_CASE("arrays: orientation is answered over columns") {
  // Else what follows asks nothing.
  CHECK(catalogue::find_operation("orientation")->row().batch != nullptr);
}

EACH_OPERATION("over columns of any length and alignment it answers as one by one") {
  const auto batch = operation.row().batch;
  if (batch == nullptr) return;
  const std::vector<Question> questions = valid_questions(operation, static_cast<std::size_t>(scaled(20'000)));
  std::vector<std::size_t> counts{questions.size()};
  for (std::size_t count = 0; count <= 70 && count <= questions.size(); ++count) counts.push_back(count);
  for (const std::size_t count : counts) {
    for (std::size_t shift = 0; shift < 8; ++shift) {
      const Columns columns(questions, count, shift);
      std::vector<std::uint8_t> answers(count + 1, 255);
      batch(columns.starts.data(), count, answers.data());
      REQUIRE(answers[count] == 255);
      for (std::size_t i = 0; i < count; ++i) {
        if (answers[i] != operation.row().decide(questions[i], 0))
          FAIL(catalogue::one_line(operation.print(questions[i])));
      }
    }
  }
}

EACH_OPERATION("over columns the first question that is refused is named") {
  const auto batch = operation.row().batch;
  if (batch == nullptr) return;
  std::vector<Question> questions = valid_questions(operation, 70);
  for (const std::size_t place : {std::size_t{0}, std::size_t{17}, std::size_t{69}}) {
    const Question kept = questions[place];
    questions[place].numbers.back() = std::numeric_limits<double>::infinity();
    std::string one_by_one, over_columns;
    try {
      operation.row().decide(questions[place], 0);
    } catch (const InvalidInput& refused) {
      one_by_one = "questions[" + std::to_string(place) + "]." + refused.what();
    }
    std::vector<std::uint8_t> answers(questions.size());
    try {
      batch(Columns(questions, questions.size(), 0).starts.data(), questions.size(), answers.data());
    } catch (const InvalidInput& refused) {
      over_columns = refused.what();
    }
    CHECK(!one_by_one.empty());
    CHECK(over_columns == one_by_one);
    questions[place] = kept;
  }
}

}  // namespace touchstone::proptests::arrays_tests
