// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "audit/logs/log_reader.h"
#include "proptests/infrastructure/program/called.h"

namespace touchstone::proptests {

/// All that a reader finds in these bytes; what it tells of them begins after the file's name.
struct ReadLog {
  explicit ReadLog(const std::string& bytes) : ReadLog(TextFile("log", bytes)) {}
  explicit ReadLog(const TextFile& file) {
    audit::LogReader log(file.path());
    for (audit::RecordedCall call; log.next(call);) calls.push_back(call);
    account = log.account();
    bytes = std::filesystem::file_size(file.path());
    const std::size_t name = std::string(file.path()).size();
    for (std::string& remark : account.remarks) remark.erase(0, name);
    for (auto& [reason, refused] : account.refused) refused.first.erase(0, name);
  }
  std::vector<audit::RecordedCall> calls;
  audit::LogAccount account;
  std::uintmax_t bytes;
};

}  // namespace touchstone::proptests
