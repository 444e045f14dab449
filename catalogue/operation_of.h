// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "catalogue/decisions.h"
#include "catalogue/figures.h"
#include "catalogue/row.h"
#include "catalogue/codec/flat.h"
#include "catalogue/families/families.h"
#include "catalogue/judge/examination_of.h"

namespace touchstone::audit {

/// An operation of the catalogue, made from its row.
template <class Row>
class OperationOf final : public Operation {
 public:
  using Asked = typename Row::Question;
  using Exactly = typename ExaminationOf<Row>::Exactly;

  const Card& card() const override { return Row::card(); }
  std::vector<std::string> words() const override {
    std::vector<std::string> words;
    append_words<answer_t<Row>>(words);
    return words;
  }
  const std::vector<std::string>& families() const override { return families_.names(); }
  Question draw(Choices& choices, std::size_t family) const override { return flat(families_.draw(choices, family)); }
  Question zeros(std::size_t list_length) const override { return flat(audit::zeros<Asked>(list_length)); }
  std::vector<std::size_t> coordinates(const Question& question) const override {
    return coordinates_of(typed_of(question));
  }

  Question in_binary32(const Question& question) const override {
    Asked asked = typed_of(question);
    for_each_number(asked, [](double& number) {
      const auto rounded = static_cast<float>(number);
      number = std::isfinite(rounded) ? rounded : std::copysign(std::numeric_limits<float>::max(), rounded);
    });
    return flat(asked);
  }

  Question parse(const Json& input) const override { return flat(read_question<double>(input, read_double)); }
  Question parse_any(const Json& input) const override {
    return flat(read_question<double>(input, read_answer_number));
  }
  Json print(const Question& question) const override {
    return print_with(question, [](double number) { return written(number); });
  }
  Json print_hexadecimal(const Question& question) const override {
    return print_with(question, [](double number) { return Json(hexadecimal(number)); });
  }

  std::unique_ptr<Examination> examine(const Question& question) const override {
    return std::make_unique<ExaminationOf<Row>>(typed_of(question));
  }

  using Operation::refusal_mismatch;
  std::string refusal_mismatch(const Question& question, std::size_t environment) const override {
    const Asked asked = typed_of(question);
    const std::string by_oracle = refusal([&] { ask_oracle<Row>(asked); });
    const std::string by_robust =
        refusal([&] { in_environment(environment, asked, [](const Asked& q) { return ask_robust<Row>(q); }); });
    return by_oracle == by_robust ? "" : "oracle: " + by_oracle + "; robust: " + by_robust;
  }

  Json truth_as_typed(const Json& input) const override {
    const auto exact = read_question<mpq_class>(input, read_exact);
    if constexpr (oracle_takes<Row, rebound_t<Asked, mpq_class>>) {
      return ExaminationOf<Row>::answer_json(ask_oracle<Row>(exact).answer);
    }
    throw InvalidInput("--as-typed", "an operation whose truth is rational");
  }

  std::optional<DecisionCount> count_decisions(int size, std::uint64_t first, std::uint64_t last) const override {
    if constexpr (requires { typename Row::decision; }) {
      return count_decisions_of<Row>(size, first, last);
    }
    return std::nullopt;
  }

  Scene scene(const Question& question) const override {
    const Asked asked = typed_of(question);
    Scene scene;
    if constexpr (requires { Row::draw(scene, asked); }) {
      Row::draw(scene, asked);
    } else {
      for_each_field(asked, [&](const char* name, const auto& value) { audit::draw(scene, name, value, false); });
    }
    try {
      draw_answer(scene, Row::card().answer, ask_oracle<Row>(asked).answer);
    } catch (const InvalidInput& refused) {
      scene.notes.push_back(refused.what());
    }
    return scene;
  }

  Question map_centre() const override {
    if constexpr (requires { Row::map_centre(); }) return flat(Row::map_centre());
    Choices simplest = Choices::replayed({});
    return flat(families_.draw(simplest, 0));
  }
  std::pair<std::size_t, std::size_t> map_axes() const override {
    if constexpr (requires { Row::map_axes(); }) return Row::map_axes();
    const std::vector<std::size_t> places = coordinates(map_centre());
    return {places[places.size() - 2], places.back()};
  }

 private:
  static Question flat(const Asked& asked) { return {flattened(asked)}; }
  static Asked typed_of(const Question& question) { return unflattened<Asked>(question.numbers); }

  template <class Tuple, class Visit>
  static void for_each_field(Tuple& asked, const Visit& visit) {
    std::size_t i = 0;
    std::apply([&](auto&... value) { (visit(Row::card().fields[i++], value), ...); }, asked);
  }

  template <class Real, class ReadNumber>
  static rebound_t<Asked, Real> read_question(const Json& input, const ReadNumber& read_number) {
    if (!input.is_object()) throw InvalidInput("input", "object");
    const auto& fields = Row::card().fields;
    for (const auto& [key, value] : input.items()) {
      bool known = false;
      for (const char* field : fields) known = known || key == field;
      if (!known) throw InvalidInput(key, "known field");
    }
    rebound_t<Asked, Real> asked{};
    for_each_field(asked, [&](const char* name, auto& value) {
      if (!input.contains(name)) throw InvalidInput(name, "missing");
      read(input[name], name, value, read_number);
    });
    return asked;
  }

  template <class Write>
  Json print_with(const Question& question, const Write& write) const {
    const Asked asked = typed_of(question);
    const auto numbers = converted<Json>(asked, [&](double number) { return write(number); });
    Json result = Json::object();
    for_each_field(numbers, [&](const char* name, const auto& value) { result[name] = to_json(value); });
    return result;
  }

  template <class Ask>
  static std::string refusal(const Ask& ask) {
    try {
      ask();
      return "answered";
    } catch (const InvalidInput& refused) {
      return "refused, " + std::string(refused.what());
    }
  }

  /// Points and segments of the truth, rounded for the eye.
  template <class T>
  static void draw_answer(Scene& scene, const std::string& label, const T& value) {
    if constexpr (is_optional<T>) {
      if (value) draw_answer(scene, label, *value);
    } else if constexpr (Plain<T> || is_vector<T>) {
      scene.notes.push_back(label + ": " + one_line(to_json(value)));
    } else if constexpr (Enumeration<T>) {
      scene.notes.push_back(label + ": " + Words<T>::words[static_cast<std::size_t>(value)]);
    } else if constexpr (Composite<T>) {
      const auto rounded = converted<double>(value, [](const mpq_class& number) { return nearest(number); });
      if constexpr (requires { audit::draw(scene, label, rounded, true); }) {
        audit::draw(scene, label, rounded, true);
      } else {
        for_each_member<T>([&](const auto& member) { draw_answer(scene, member.name, value.*member.pointer); });
      }
    } else {
      scene.notes.push_back(label + " = " + value.get_str());
    }
  }

  Families<Row> families_;
};

template <class Row>
const Operation& operation_of_row() {
  static const OperationOf<Row> operation;
  return operation;
}

}  // namespace touchstone::audit
