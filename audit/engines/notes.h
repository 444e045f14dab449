// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <mutex>
#include <ostream>
#include <set>
#include <string>

#include "audit/uses.h"

namespace touchstone::audit {

/// What is worth telling of how an engine behaved and is no answer to a question: names of its first line that nobody
/// knows, how often it was started anew, and lines that are no answer. Engines of several jobs write into one.
/// How often something happened may depend on the jobs, so it is reported on standard error and stands in no result.
class EngineNotes {
 public:
  void add_of_first_line(const std::string& remark);
  void add_restart(const std::string& defect);
  void add_stray_line(const std::string& line);

  /// The remarks on the first line, each behind "; ": the end of a complaint.
  std::string of_first_line() const;
  std::uint64_t restarts() const;
  std::uint64_t stray_lines() const;
  /// Everything, a line each; unless `all`, of the remarks on the first line the first, and how many there are.
  void tell(std::ostream& err, bool all = true) const;

 private:
  mutable std::mutex mutex_;
  std::set<std::string> remarks_;
  std::uint64_t restarts_ = 0, stray_lines_ = 0;
  std::string last_defect_, last_stray_;
};

}  // namespace touchstone::audit
