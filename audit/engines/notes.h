// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <mutex>
#include <ostream>
#include <set>
#include <string>

#include "audit/uses.h"

namespace touchstone::audit {

/// Remarks on the behaviour of an engine that are not answers: unknown names in its first line, the number of restarts,
/// and lines that are not answers. The engines of several jobs write into one object. Such counts may depend on the
/// jobs, so they go to standard error and into no result.
class EngineNotes {
 public:
  void add_of_first_line(const std::string& remark);
  void add_restart(const std::string& defect);
  void add_stray_line(const std::string& line);

  /// The remarks on the first line, each after "; ": the end of a complaint.
  std::string of_first_line() const;
  std::uint64_t restarts() const;
  std::uint64_t stray_lines() const;
  /// Prints everything, one per line; unless `all`, only the first of the remarks on the first line, and their number.
  void tell(std::ostream& err, bool all = true) const;

 private:
  mutable std::mutex mutex_;
  std::set<std::string> remarks_;
  std::uint64_t restarts_ = 0, stray_lines_ = 0;
  std::string last_defect_, last_stray_;
};

}  // namespace touchstone::audit
