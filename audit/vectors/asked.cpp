// SPDX-License-Identifier: Apache-2.0
#include "audit/vectors/asked.h"

#include "audit/audit_run.h"
#include "audit/vectors/named_files.h"
#include "catalogue/codec/plain.h"
#include "catalogue/operation/fitted.h"

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
    const std::vector<Reply> replies = engine.ask(operation, questions);
    for (const Reply& reply : replies) {
      const Pending& vector = pending_[first++];
      const auto examination = operation.examine(vector.question);
      all.push_back({vector.number, vector.id, vector.family, &operation, vector.question, examination->outcome(),
                     judged(reply, *examination, engine.declaration()), kept(reply.answer), reply.asked});
    }
  }
  return all;
}

}  // namespace touchstone::audit
