// SPDX-License-Identifier: Apache-2.0
#include "program/runs/checkpoint.h"

#include <algorithm>
#include <filesystem>

#include "audit/place.h"
#include "audit/platform.h"
#include "audit/version.h"
#include "catalogue/codec/excerpt.h"
#include "program/terminal/names.h"

namespace touchstone::program {
namespace {

/// At most an eighth of the time spent is lost, or this much.
constexpr std::chrono::milliseconds least{500}, most{30'000};

}  // namespace

Checkpoint::Checkpoint(const std::string& file, Json run, std::ostream& err) {
  if (file.empty() || is_standard_output(file)) return;
  std::error_code error;
  const bool is_special =
      std::filesystem::exists(path_of(file), error) && !std::filesystem::is_regular_file(path_of(file), error);
  if (is_special) return;
  part_ = file + ".part";
  run["version"] = version_number;
  run_ = one_line(run);
  if (!std::filesystem::exists(path_of(part_), error)) return;
  std::string of;
  try {
    const Json stopped = parse_line(text_of_file(part_));
    of = Place{stopped, ""}.at("run").value.get<std::string>();
    found_ = Place{stopped, ""}.at("state").value;
  } catch (const std::exception& refused) {
    throw UsageError(part_ + ": expected the state of a run that was stopped, or no such file; " + refused.what());
  }
  if (of != run_)
    throw UsageError(part_ + ": expected the state of this run, " + run_ + ", or no such file; it is of " +
                     excerpt(of, 500));
  err << "touchstone: resumes from " << part_ << '\n';
}

void Checkpoint::keep(const std::function<Json()>& state) {
  const Clock::time_point now = Clock::now();
  if (part_.empty() || now - kept_ < std::clamp<Clock::duration>((now - began_) / 8, least, most)) return;
  keep_now(state());
  kept_ = now;
}

void Checkpoint::keep_now(const Json& state) const {
  if (part_.empty()) return;
  write_file("state of the run:", part_, one_line({{"touchstone", 1}, {"run", run_}, {"state", state}}) + "\n");
}

void Checkpoint::remove() const {
  std::error_code ignored;
  if (!part_.empty()) std::filesystem::remove(path_of(part_), ignored);
}

}  // namespace touchstone::program
