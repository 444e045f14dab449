// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <string_view>

#include "audit/uses.h"
#include "catalogue/codec/excerpt.h"

namespace touchstone::audit {

/// The end of what a process has written to its standard error.
class LastErrors {
 public:
  static constexpr std::size_t kept = 4096;

  void append(std::string_view piece) {
    text_ += piece;
    if (text_.size() > kept) text_.erase(0, text_.size() - kept);
  }

  /// `how` the process ended, and the last line unless that says it: "exit code 1: ImportError: no module".
  std::string after(const std::string& how) const {
    const std::string complaint = last_line();
    return how.find(complaint) != std::string::npos ? how : how + ": " + complaint;
  }

 private:
  std::string last_line() const {
    std::string_view text = text_;
    const std::size_t last = text.find_last_not_of(" \t\r\n");
    if (last == std::string_view::npos) return "";
    text = text.substr(0, last + 1);
    const std::size_t line = text.rfind('\n');
    return excerpt(line == std::string_view::npos ? text : text.substr(line + 1), 200);
  }

  std::string text_;
};

}  // namespace touchstone::audit
