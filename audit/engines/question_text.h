// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "audit/uses.h"
#include "catalogue/operation/operation.h"

namespace touchstone::audit {

/// The JSON text of an operation's questions, without a document in between: what stands around the numbers is the same
/// in all of them. Ten times faster than the codec, which remains the judge of every text that looks otherwise.
class QuestionText {
 public:
  explicit QuestionText(const Operation& operation);

  void write(const Question& question, std::string& text) const;
  /// False where the text is not, to the letter, as `write` writes it, or a number is out of range.
  bool read(std::string_view text, Question& question) const;

 private:
  const Operation& operation_;
  std::vector<std::string>
      around_;  ///< before, between and after the numbers; empty where questions differ in their length
};

}  // namespace touchstone::audit
