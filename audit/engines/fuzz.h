// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "audit/engines/adapter.h"

namespace touchstone::audit {

/// One libFuzzer input: its first byte selects the family, the others are the draws of a question of it. Aborts with
/// one line if the verdict on the engine's answer is one that stops: a finding, or with
/// TOUCHSTONE_FUZZ_ONLY=algorithm,invalid one of these. libFuzzer reports a crash of the engine. Returns -1 if the
/// input is not worth keeping, 0 otherwise.
int fuzz_member(const EngineMembers& engine, const char* operation, const unsigned char* bytes, std::size_t size);

template <class Engine, class Operation>
int fuzz_engine(const unsigned char* bytes, std::size_t size) {
  static_assert(has_operation<Engine, Operation, double> || has_operation<Engine, Operation, float>,
                "the engine has no member function of that operation's name and arguments");
  static Engine engine{};
  static const EngineMembers members = members_of(engine);
  return fuzz_member(members, Operation::name, bytes, size);
}

}  // namespace touchstone::audit

/// A libFuzzer target that looks for a wrong answer of the engine to one operation.
#define TOUCHSTONE_ENGINE_FUZZ(EngineType, operation)                                   \
  extern "C" int LLVMFuzzerTestOneInput(const unsigned char* bytes, std::size_t size) { \
    using Operation = ::touchstone::catalogue::signatures::operation;                   \
    return ::touchstone::audit::fuzz_engine<EngineType, Operation>(bytes, size);        \
  }
