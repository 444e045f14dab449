// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <initializer_list>
#include <vector>

#include "catalogue/codec/shape_json.h"
#include "simulate/world/arithmetic.h"

/// The questions of a step, in their order.
namespace touchstone::simulate {

using catalogue::Json;

/// A pair of bodies, the first with the lesser index, or a body and a wall.
struct Touch {
  bool wall;
  std::size_t body, other;
  friend bool operator==(const Touch&, const Touch&) = default;
};

struct Asked {
  Touch touch;
  const char* operation;
  Json question, answer;  ///< in the form of `touchstone ask`, except for the name of a single bare enumerator
};
using Log = std::vector<Asked>;

/// Appends the question of a decision to the log, if there is one. The exact arithmetic is never logged: its numbers
/// are not doubles.
template <class Real, class Answer, class... Part>
Answer logged(Log* log, const Touch& touch, const char* operation, std::initializer_list<const char*> names,
              const Answer& answer, const Part&... part) {
  if constexpr (!std::is_same_v<Real, Exact>) {
    if (log == nullptr) return answer;
    const auto in_double = [](const auto& value) {
      return catalogue::to_json(catalogue::converted<double>(value, [](Real x) { return static_cast<double>(x); }));
    };
    Json question = Json::object();
    const char* const* name = names.begin();
    ((question[*name++] = in_double(part)), ...);
    log->push_back({touch, operation, std::move(question), in_double(answer)});
  }
  return answer;
}

}  // namespace touchstone::simulate
