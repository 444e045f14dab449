// SPDX-License-Identifier: Apache-2.0
#include "audit/engines/notes.h"

#include <algorithm>

#include "catalogue/codec/excerpt.h"

namespace touchstone::audit {
namespace {

constexpr std::size_t most_of_a_line = 200;

std::string times(std::uint64_t n) { return n == 1 ? "once" : std::to_string(n) + " times"; }

}  // namespace

void EngineNotes::add_of_first_line(const std::string& remark) {
  const std::lock_guard lock(mutex_);
  remarks_.insert(remark);
}

void EngineNotes::add_restart(const std::string& defect) {
  const std::lock_guard lock(mutex_);
  ++restarts_;
  last_defect_ = defect;
}

void EngineNotes::add_stray_line(const std::string& line) {
  const std::lock_guard lock(mutex_);
  ++stray_lines_;
  last_stray_ = excerpt(line, most_of_a_line);
}

std::string EngineNotes::of_first_line() const {
  const std::lock_guard lock(mutex_);
  std::string text;
  for (const std::string& remark : remarks_) text += "; " + remark;
  return text;
}

std::uint64_t EngineNotes::restarts() const {
  const std::lock_guard lock(mutex_);
  return restarts_;
}

std::uint64_t EngineNotes::stray_lines() const {
  const std::lock_guard lock(mutex_);
  return stray_lines_;
}

void EngineNotes::tell(std::ostream& err, bool all) const {
  const std::lock_guard lock(mutex_);
  const std::size_t shown = all ? remarks_.size() : std::min<std::size_t>(remarks_.size(), 1);
  const std::string more =
      shown < remarks_.size() ? "; --verbose tells " + std::to_string(remarks_.size() - shown) + " more" : "";
  auto remark = remarks_.begin();
  for (std::size_t i = 0; i < shown; ++i, ++remark)
    err << "touchstone: engine: first line: " << *remark << more << '\n';
  if (restarts_ > 0)
    err << "touchstone: engine: restarted " << times(restarts_) << ", the last time for: " << last_defect_ << '\n';
  if (stray_lines_ > 0) {
    err << "touchstone: engine: " << stray_lines_ << (stray_lines_ == 1 ? " line" : " lines")
        << " of its standard output that " << (stray_lines_ == 1 ? "is" : "are")
        << " no answer, the last: " << last_stray_ << '\n';
  }
  err << std::flush;
}

}  // namespace touchstone::audit
