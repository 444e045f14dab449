// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <vector>

#include "audit/uses.h"
#include "catalogue/judge/verdict.h"
#include "catalogue/shape/encoded_value.h"

/// A C++ engine with its types erased, as audit/engines/adapter.h makes it of a struct.
namespace touchstone::audit {

/// The return value of an engine's member function.
struct MemberAnswer {
  enum class Kind {
    unsupported,  ///< std::nullopt
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
  /// The alternatives of the question for which the engine has an overload, and those for which it has none.
  std::vector<std::size_t> answered{}, left_out{};
};

struct EngineMembers {
  catalogue::Declaration declaration;
  void* engine;
  std::vector<Member> members{};
};

}  // namespace touchstone::audit
