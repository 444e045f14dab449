// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "audit/counting/judged.h"

/// Test vectors as questions to an engine.
namespace touchstone::audit {

/// The vectors of one file that an engine may be asked: those of operations that it has, except refused inputs.
class VectorQuestions {
 public:
  /// `folder` contains the file: vectors name meshes in it.
  VectorQuestions(const Engine& engine, std::string folder) : engine_(engine), folder_(std::move(folder)) {}

  /// Adds a line of the file; a line that is not a vector is skipped (vector_complaint says why).
  void add(std::uint64_t number, const std::string& line);

  /// An engine's answer to one vector, as the oracle judges it.
  struct Answered {
    std::uint64_t number;
    std::string id, family;
    const Operation* operation;
    Question question;
    std::string truth;  ///< Examination::outcome()
    JudgedReply reply;
  };
  /// In the order of the lines.
  std::vector<Answered> ask(Engine& engine) const;

 private:
  struct Pending {
    std::uint64_t number;
    std::string id, family;
    const Operation* operation;
    Question question;
  };
  const Engine& engine_;
  std::string folder_;
  std::vector<Pending> pending_;
};

}  // namespace touchstone::audit
