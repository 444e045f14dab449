// SPDX-License-Identifier: Apache-2.0
#include "program/terminal/engine_lines.h"

#include "audit/engines/process.h"
#include "catalogue/codec/json.h"
#include "program/terminal/uses.h"

namespace touchstone::program {
namespace {

using Clock = std::chrono::steady_clock;
using simulate::EngineFailure;

constexpr double time_to_start = 30;           // seconds: allows for an interpreter on a busy machine
constexpr std::size_t longest_line = 1 << 26;  // 10,000 bodies take less than 2 MiB

class ProcessLines : public simulate::EngineLines {
 public:
  ProcessLines(const std::string& command, double timeout) : timeout_(timeout), process_(command) {}

  std::string answer_to(const std::string& line) override {
    const double seconds = first_ ? timeout_ + time_to_start : timeout_;
    first_ = false;
    const auto deadline =
        Clock::now() + std::chrono::duration_cast<Clock::duration>(std::chrono::duration<double>(seconds));
    std::string outbox = line + "\n";
    while (true) {
      std::string_view rest = outbox;
      process_.write(rest);
      outbox.erase(0, outbox.size() - rest.size());
      while (auto answer = next_line())
        if (answer->starts_with('{')) return *answer;
      if (closed_) throw EngineFailure(process_.end());
      if (inbox_.size() > longest_line) throw EngineFailure("a line that does not end");
      if (Clock::now() >= deadline) throw EngineFailure("no answer in " + catalogue::decimal(seconds) + " s");
      process_.wait_for(!outbox.empty(), deadline);
      closed_ = !process_.read(inbox_);
    }
  }

 private:
  std::optional<std::string> next_line() {
    const std::size_t end = inbox_.find('\n', searched_);
    searched_ = end == std::string::npos ? inbox_.size() : 0;
    if (end == std::string::npos) return std::nullopt;
    std::string line = inbox_.substr(0, end);
    inbox_.erase(0, end + 1);
    return line;
  }

  double timeout_;
  audit::Process process_;
  std::string inbox_;
  std::size_t searched_ = 0;
  bool first_ = true, closed_ = false;
};

}  // namespace

std::unique_ptr<simulate::EngineLines> engine_lines(const std::string& command, double timeout) {
  return std::make_unique<ProcessLines>(command, timeout);
}

}  // namespace touchstone::program
