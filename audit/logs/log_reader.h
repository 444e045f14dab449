// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "audit/logs/log_form.h"

namespace touchstone::audit {

/// Reads a log of either form from a file, or from standard input for "-", compressed by gzip or zstd or not. Of the
/// log it holds a piece at a time. JSON lines without a header are a log of version 1.
///
/// The constructor and `next` throw LogError where the file cannot be read, and where the log is of another version.
/// Whatever else is wrong costs what cannot be read, and stands in the account.
class LogReader {
 public:
  explicit LogReader(const std::string& file);
  ~LogReader();

  /// The next call, into an object whose memory is used again; false at the end.
  bool next(RecordedCall& call);

  const LogAccount& account() const { return account_; }
  const LogHeader& header() const { return account_.header; }
  const std::vector<std::string>& sites() const { return account_.sites; }
  bool is_binary() const { return binary_; }

 private:
  ByteSource source_;
  LogAccount account_;
  bool binary_;
  std::unique_ptr<LogForm> form_;
};

}  // namespace touchstone::audit
