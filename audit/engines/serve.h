// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "audit/engines/member.h"
#include "audit/engines/protocol.h"

namespace touchstone::audit {

/// The engine's side of the pipe: an answer in JSON, nothing where it does not support the question, an exception where
/// it fails.
using Answerer = std::function<std::optional<Json>(const Question&)>;

struct ServedOperation {
  const Operation& operation;
  QuestionText text;
  Answerer answer;
};

struct Served {
  Hello hello;
  std::map<std::string, ServedOperation, std::less<>> operations;
  /// Of operations that it has, the alternatives of a question that it has not: "sphere_sphere(Sphere3<double> a,
  /// ...)".
  std::vector<std::string> left_out{};
};

/// The engine as it is served. Refers to the engine's object.
Served served(const EngineMembers& engine);

/// Speaks the protocol of docs/engines.md on standard input and output until the input ends. Whatever else writes to
/// standard output meanwhile is sent to standard error.
int serve(const Served& engine);

}  // namespace touchstone::audit
