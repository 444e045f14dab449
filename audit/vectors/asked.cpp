// SPDX-License-Identifier: Apache-2.0
#include "audit/vectors/asked.h"

#include "audit/vectors/named_files.h"
#include "catalogue/codec/json.h"
#include "catalogue/operation/probes/fitted.h"

namespace touchstone::audit {

void VectorQuestions::add(std::uint64_t number, const std::string& text) {
  try {
    const Json line = parse_line(text);
    if (!line.is_object() || !line.contains("op") || !line["op"].is_string() || line.contains("refused")) return;
    const Operation* const operation = find_operation(line["op"].get<std::string>());
    if (operation == nullptr || !engine_.supports(operation->name())) return;
    Question question = operation->parse(without_names(line["input"], folder_));
    question = fitted(*operation, question, engine_.declaration());
    operation->examine(question);  // then it may be outside the contract
    pending_.push_back({number, line.value("id", ""), line.value("family", ""), operation, std::move(question)});
  } catch (const std::exception&) {
  }
}

std::vector<VectorQuestions::Answered> VectorQuestions::ask(Engine& engine) const {
  std::vector<Answered> all;
  for (std::size_t first = 0; first < pending_.size();) {
    const Operation& operation = *pending_[first].operation;
    std::vector<Question> questions;
    for (std::size_t i = first; i < pending_.size() && pending_[i].operation == &operation; ++i)
      questions.push_back(pending_[i].question);
    all.resize(first + questions.size());
    engine.ask_each(operation, questions, [&](std::size_t i, const Reply& reply) {
      const Pending& vector = pending_[first + i];
      const auto examination = operation.examine(vector.question);
      all[first + i] = {vector.number,
                        vector.id,
                        vector.family,
                        &operation,
                        vector.question,
                        examination->outcome(),
                        judged_and_kept(reply, *examination, engine.declaration())};
    });
    first += questions.size();
  }
  return all;
}

}  // namespace touchstone::audit
