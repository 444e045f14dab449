// SPDX-License-Identifier: Apache-2.0
#include "catalogue/operation/operation.h"

#include <cmath>
#include <limits>

#include "catalogue/codec/expected.h"
#include "catalogue/numbers/ulps.h"

namespace touchstone::catalogue {
namespace {

/// A question's shape with the names of its fields.
Shape with_names(const Shape& shape, const FieldNames& names) {
  Shape named = shape;
  for (std::size_t i = 0; i < named.parts.size(); ++i) named.parts[i].name = names[i];
  return named;
}

/// The positions of the enumerators of a question that a grid runs over, and the number of values of each.
struct GridWords {
  std::vector<std::pair<std::size_t, std::uint64_t>> places;
  const Word* begin = nullptr;
  void number(const Shape&, const Cursor<double>&) {}
  void word(const Shape& shape, const Cursor<double>& at) {
    const auto place = static_cast<std::size_t>(at.word - begin);
    if (shape.kind == Shape::Kind::word) places.emplace_back(place, shape.words.size());
    if (shape.kind == Shape::Kind::flag) places.emplace_back(place, 2);
  }
};
GridWords grid_words(const Shape& shape, const Question& question) {
  GridWords found;
  found.begin = question.words.data();
  Cursor<double> at(question);
  walk_encoded(shape, at, found);
  return found;
}

/// For one alternative; nullopt beyond 2^64.
std::optional<std::uint64_t> configurations_of(const Shape& shape, const Question& zero, int size) {
  std::uint64_t total = 1;
  const auto times = [&total](std::uint64_t factor) { return __builtin_mul_overflow(total, factor, &total); };
  for (std::size_t i = zero.numbers.size(); i > 0; --i) {
    if (times(static_cast<std::uint64_t>(size))) return std::nullopt;
  }
  for (const auto& [place, values] : grid_words(shape, zero).places) {
    if (times(values)) return std::nullopt;
  }
  return total;
}

std::string refusal(const auto& ask) {
  try {
    ask();
    return "answered";
  } catch (const InvalidInput& refused) {
    return "refused, " + std::string(refused.what());
  }
}

}  // namespace

Operation::Operation(RowFunctions functions) : row_(std::move(functions)), families_(row_) {
  if (row_.question->kind != Shape::Kind::choice) {
    question_ = with_names(*row_.question, fields());
    return;
  }
  question_ = *row_.question;
  alternatives_.reserve(question_.parts.size());
  for (std::size_t i = 0; i < question_.parts.size(); ++i) {
    alternatives_.push_back(with_names(*question_.parts[i].shape, fields(i)));
    question_.parts[i].shape = &alternatives_.back();
  }
}

const FieldNames& Operation::fields(std::size_t alternative) const {
  const auto& others = metadata().other_fields;
  return alternative == 0 || others.empty() ? metadata().fields : others[alternative - 1];
}

Question Operation::zeros(std::size_t list_length, std::size_t alternative) const {
  Question question;
  if (question_.kind == Shape::Kind::choice) {
    question.words.push_back(static_cast<Word>(alternative));
    append_zeros(*question_.parts[alternative].shape, list_length, question);
  } else {
    append_zeros(question_, list_length, question);
  }
  return question;
}

std::vector<Question> Operation::zeros_of_alternatives(std::size_t list_length) const {
  std::vector<Question> all;
  const std::size_t count = question_.kind == Shape::Kind::choice ? question_.parts.size() : 1;
  for (std::size_t i = 0; i < count; ++i) all.push_back(zeros(list_length, i));
  return all;
}

Question Operation::in_binary32(const Question& question) const {
  return encoded_with<double>(question, [](double number) {
    const auto rounded = static_cast<float>(number);
    return double{std::isfinite(rounded) ? rounded : std::copysign(std::numeric_limits<float>::max(), rounded)};
  });
}

template <class Real>
EncodedValue<Real> Operation::read(const Json& input, ReadNumber<Real> read_number) const {
  if (!input.is_object())
    throw InvalidInput("input", expected("an object like " + one_line(example_of(question_)), input));
  EncodedValue<Real> encoded;
  read_json(question_, input, "", encoded, read_number);
  return encoded;
}
Question Operation::parse(const Json& input) const { return read<double>(input, read_double); }
Question Operation::parse_any(const Json& input) const { return read<double>(input, read_answer_number); }

Json Operation::print(const Question& question) const {
  return json_of<double>(question_, question, [](const double& number) { return written(number); });
}
Json Operation::print_hexadecimal(const Question& question) const {
  return json_of<double>(question_, question, [](const double& number) { return Json(hexadecimal(number)); });
}

Json Operation::named(Json bare) const {
  if (metadata().answer[0] == 0) return bare;
  Json object = Json::object();
  object[metadata().answer] = std::move(bare);
  return object;
}
Json Operation::answer_json(const EncodedValue<double>& answer) const {
  return named(json_of<double>(*row_.answer, answer, [](const double& number) { return written(number); }));
}
Json Operation::answer_json(const EncodedTruth& answer) const {
  return named(json_of<TrueNumber>(*row_.answer, answer, [](const TrueNumber& number) { return written(number); }));
}

Json Operation::question_description() const {
  if (alternatives_.empty()) return json_of(question_);
  Json list = Json::array();
  for (const Shape& alternative : alternatives_) list.push_back(json_of(alternative));
  return list;
}

std::unique_ptr<Examination> Operation::examine(const Question& question) const {
  return std::make_unique<Examination>(*this, question);
}

std::string Operation::refusal_mismatch(const Question& question, std::size_t environment) const {
  const std::string by_oracle = refusal([&] { row_.solve(question); });
  const std::string by_robust = refusal([&] { row_.robust(question, environment); });
  return by_oracle == by_robust ? "" : "oracle: " + by_oracle + "; robust: " + by_robust;
}

Json Operation::truth_as_typed(const Json& input) const {
  const EncodedValue<mpq_class> exact = read<mpq_class>(input, read_exact);
  if (row_.solve_as_typed == nullptr) throw InvalidInput("--as-typed", "an operation whose truth is rational");
  return answer_json(row_.solve_as_typed(exact).answer);
}

std::optional<std::uint64_t> Operation::configurations(int size, std::size_t list_length) const {
  return row_.world ? row_.world->count(size) : configurations_of_plain_grid(size, list_length);
}

std::optional<std::uint64_t> Operation::configurations_of_plain_grid(int size, std::size_t list_length) const {
  std::uint64_t total = 0;
  for (const Question& zero : zeros_of_alternatives(list_length)) {
    const auto configurations = configurations_of(question_, zero, size);
    if (!configurations || __builtin_add_overflow(total, *configurations, &total)) return std::nullopt;
  }
  return total;
}

Question Operation::on_grid(int size, std::uint64_t index, std::size_t list_length) const {
  if (row_.world) return row_.world->at(size, index);
  std::vector<Question> alternatives = zeros_of_alternatives(list_length);
  std::size_t which = 0;
  for (; which + 1 < alternatives.size(); ++which) {
    const auto configurations = configurations_of(question_, alternatives[which], size);
    if (!configurations || index < *configurations) break;
    index -= *configurations;
  }
  Question& question = alternatives[which];
  for (const auto& [place, values] : grid_words(question_, question).places) {
    question.words[place] = static_cast<Word>(index % values);
    index /= values;
  }
  for (std::size_t i = question.numbers.size(); i-- > 0; index /= static_cast<std::uint64_t>(size))
    question.numbers[i] = static_cast<double>(index % static_cast<std::uint64_t>(size));
  return std::move(question);
}

std::optional<DecisionCount> Operation::count_decisions(int size, std::uint64_t first, std::uint64_t last,
                                                        std::size_t list_length) const {
  if (row_.count_decisions == nullptr) return std::nullopt;
  return row_.count_decisions(size, first, last, list_length);
}

Question Operation::map_centre() const {
  if (row_.map_centre != nullptr) return row_.map_centre();
  DrawStream simplest = DrawStream::replayed({});
  return draw(simplest, 0);
}

std::pair<std::size_t, std::size_t> Operation::map_axes() const {
  if (row_.map_axes != nullptr) return row_.map_axes();
  const std::size_t numbers = map_centre().numbers.size();
  return {numbers - 2, numbers - 1};
}

const Operation* find_operation(const std::string& name) {
  for (const Operation* operation : all_operations()) {
    if (operation->name() == name) return operation;
  }
  return nullptr;
}

}  // namespace touchstone::catalogue
