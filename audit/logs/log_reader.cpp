// SPDX-License-Identifier: Apache-2.0
#include "audit/logs/log_reader.h"

#include "audit/engines/protocol.h"
#include "catalogue/codec/did_you_mean.h"
#include "catalogue/codec/excerpt.h"

namespace touchstone::audit {
namespace {

/// A log may be wrong in every line, each time differently.
constexpr std::size_t most_reasons = 1000, most_remarks = 100, most_sites = 65536;

/// The rule without the part that says what was found instead.
std::string reason_of(const InvalidInput& refused) {
  const std::string& rule = refused.rule();
  return rule.substr(0, rule.find(", got "));
}

}  // namespace

void LogForm::begin_log(LogHeader header) {
  if (open_) {
    ++account_.cut;
    remark("", "a log has no end mark: the program was ended before it closed the log");
  }
  open_ = true;
  ++account_.logs;
  account_.header = std::move(header);
}

void LogForm::end_log(const LogEnd& end) {
  if (!open_) ++account_.logs;
  open_ = false;
  account_.end.seen += end.seen;
  account_.end.written += end.written;
  account_.end.sampled_out += end.sampled_out;
  account_.end.lost += end.lost;
}

void LogForm::end_file(bool read_all) {
  if (!source_.broken().empty()) remark("", source_.broken());
  if (!open_) return;
  ++account_.cut;
  open_ = false;
  if (!read_all) return;
  remark("", "the log has no end mark: the program was ended before it closed the log, or is running");
}

void LogForm::refuse(const std::string& place, const InvalidInput& reason, std::uint64_t calls) {
  std::string name = reason_of(reason);
  if (account_.refused.size() >= most_reasons && !account_.refused.contains(name)) name = "other reasons";
  RefusedCalls& refused = account_.refused[name];
  if (refused.count == 0) refused.first = excerpt(file_ + place + ": " + reason.what(), 500);
  refused.count += calls;
}

void LogForm::remark(const std::string& place, const std::string& what) {
  if (account_.remarks.size() < most_remarks) account_.remarks.push_back(file_ + place + ": " + what);
}

std::size_t LogForm::site_of(const std::string& text) {
  const auto known = sites_.find(text);
  if (known != sites_.end()) return known->second;
  if (sites_.size() >= most_sites) throw InvalidInput("site", "at most 65,536 different ones");
  sites_.emplace(text, account_.sites.size());
  account_.sites.push_back(text);
  return account_.sites.size() - 1;
}

const Operation& recorded_operation(const std::string& name) {
  const Operation* const operation = find_operation(name);
  if (operation == nullptr) {
    std::vector<const char*> known;
    for (const Operation* each : all_operations()) known.push_back(each->metadata().name);
    throw InvalidInput("op",
                       excerpt(name, most_of_a_key) + ": no operation of the catalogue" + did_you_mean(name, known));
  }
  if (operation->metadata().is_implementation())
    throw InvalidInput(
        "op", name + ": a method of " + operation->metadata().implementation_of + ", whose calls are recorded instead");
  return *operation;
}

LogReader::LogReader(const std::string& file)
    : source_(file),
      binary_(source_.peek(binary_magic.size()).substr(0, binary_magic.size()) == binary_magic),
      form_((binary_ ? binary_form : json_form)(file == "-" ? "standard input" : file, source_, account_)) {}

LogReader::~LogReader() = default;

bool LogReader::next(RecordedCall& call) {
  if (!form_->next(call)) return false;
  call.ordinal = account_.calls++;
  return true;
}

}  // namespace touchstone::audit
