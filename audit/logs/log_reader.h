// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "audit/logs/log_form.h"

namespace touchstone::audit {

/// Reads a log of either form from a file, or from standard input for "-", plain or compressed by gzip or zstd. It
/// holds one piece of the log at a time. JSON lines without a header are a log of version 1.
///
/// The constructor and `next` throw LogError if the file cannot be read, and if the log is of another version. Any
/// other defect only loses the affected part, and is reported in the account.
class LogReader {
 public:
  explicit LogReader(const std::string& file);
  ~LogReader();

  /// Reads the next call, into an object whose memory is reused; returns false at the end.
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
