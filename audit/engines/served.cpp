// SPDX-License-Identifier: Apache-2.0
#include "audit/engines/serve.h"
#include "audit/engines/signature.h"

namespace touchstone::audit {
namespace {

/// The enumerator of one field of an answer, under the field's name.
Json word_of(const Shape& answer, const MemberAnswer& said) {
  Json object = Json::object();
  for (const Shape::Part& part : answer.parts)
    if (part.name == std::string_view(said.field)) object[part.name] = part.shape->words[said.value.words[0]];
  return object;
}

std::optional<Json> in_json(const Operation& operation, const MemberAnswer& said) {
  switch (said.kind) {
    case MemberAnswer::Kind::unsupported: return std::nullopt;
    case MemberAnswer::Kind::whole: return operation.answer_json(said.value);
    case MemberAnswer::Kind::word: return word_of(operation.answer_shape(), said);
    case MemberAnswer::Kind::flag: return Json(said.value.words[0] != 0);
  }
  return std::nullopt;
}

}  // namespace

Served served(const EngineMembers& engine) {
  Served all;
  all.hello.declaration = engine.declaration;
  for (const Member& member : engine.members) {
    const Operation& operation = *find_operation(member.operation);
    all.hello.operations.insert(operation.name());
    if (!member.left_out.empty())
      all.hello.declaration.alternatives[operation.name()] = {member.answered.begin(), member.answered.end()};
    for (const std::size_t alternative : member.left_out)
      all.left_out.push_back(operation.name() + arguments_text(operation, alternative));
    const auto answer = [&operation, ask = member.ask, object = engine.engine](const Question& question) {
      return in_json(operation, ask(object, question));
    };
    all.operations.emplace(operation.name(), ServedOperation{operation, QuestionText(operation), answer});
  }
  return all;
}

}  // namespace touchstone::audit
