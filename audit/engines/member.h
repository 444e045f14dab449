// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <vector>

#include "audit/uses.h"
#include "catalogue/judge/verdict.h"
#include "catalogue/shape/encoded_value.h"

/// A C++ engine with its types forgotten: what audit/engines/adapter.h makes of a struct.
namespace touchstone::audit {

/// What a member function of an engine returned.
struct MemberAnswer {
  enum class Kind {
    unsupported,  ///< nothing
    whole,        ///< an answer of the operation
    word,         ///< the enumerator of one field of the answer
    flag,         ///< true or false
  };
  Kind kind = Kind::unsupported;
  catalogue::EncodedValue<double> value{};  ///< of `whole`; else the word or the flag
  const char* field = nullptr;              ///< of `word`
};

/// A member function of an engine.
struct Member {
  const char* operation;
  MemberAnswer (*ask)(void* engine, const catalogue::Question&);
  /// For which alternatives of the question the engine has an overload, and for which it has none.
  std::vector<std::size_t> answered{}, left_out{};
};

struct EngineMembers {
  catalogue::Declaration declaration;
  void* engine;
  std::vector<Member> members{};
};

}  // namespace touchstone::audit
