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

/// The engine's side of the pipe: returns an answer in JSON, or nullopt if it does not support the question; throws if
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
  /// The alternatives of a question that it lacks, for the operations that it has: "sphere_sphere(Sphere3<double> a,
  /// ...)".
  std::vector<std::string> left_out{};
};

/// The engine in the form that is served. It refers to the engine's object.
Served served(const EngineMembers& engine);

/// Speaks the protocol of docs/engines.md on standard input and output until the input ends. Other output to standard
/// output is redirected to standard error.
int serve(const Served& engine);

}  // namespace touchstone::audit
