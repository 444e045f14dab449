// SPDX-License-Identifier: Apache-2.0
#include <algorithm>

#include "audit/reducing/passes.h"
#include "audit/reducing/question_parts.h"
#include "audit/reducing/runs.h"

namespace touchstone::audit::reducing {
namespace {

bool refers_to_places(const QuestionParts& parts) {
  return std::any_of(parts.words.begin(), parts.words.end(),
                     [](const WordPlace& word) { return word.shape->kind == Shape::Kind::index; });
}

bool drop_from_list(Search& search, std::size_t list) {
  const Shape& shape = *search.operation().row().question;
  QuestionParts parts;
  const auto length = [&]() -> std::size_t {
    parts = parts_of(shape, search.best());
    return list < parts.lists.size() ? parts.lists[list].size() : 0;
  };
  const auto alone = [&](std::size_t first, std::size_t last) -> std::optional<Question> {
    return without(search.best(), parts.lists[list], first, last);
  };
  const auto with_what_refers = [&](std::size_t first, std::size_t last) -> std::optional<Question> {
    return without_and_referring(shape, search.best(), parts.lists[list], first, last);
  };
  bool better = drop_runs(search, {length, alone});
  if (refers_to_places(parts)) better = drop_runs(search, {length, with_what_refers}) || better;
  return better;
}

/// Removes optional values that are present.
bool drop_optional_values(Search& search) {
  bool better = false;
  for (bool dropped = true; dropped; better = better || dropped) {
    const QuestionParts parts = parts_of(*search.operation().row().question, search.best());
    const auto left_out = [&](std::size_t i) -> std::optional<Question> {
      const WordPlace& place = parts.words[i];
      if (place.shape->kind != Shape::Kind::optional) return std::nullopt;
      Question question = with_part(search.best(), place.value, {});
      question.words[place.word] = 0;
      return question;
    };
    dropped = search.first(parts.words.size(), left_out).has_value();
  }
  return better;
}

}  // namespace

bool drop_elements(Search& search) {
  bool better = false;
  const Shape& shape = *search.operation().row().question;
  for (std::size_t list = 0; list < parts_of(shape, search.best()).lists.size() && !search.over(); ++list)
    better = drop_from_list(search, list) || better;
  return drop_optional_values(search) || better;
}

}  // namespace touchstone::audit::reducing
