// SPDX-License-Identifier: Apache-2.0
#include "program/commands/recorded/log.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <filesystem>
#include <map>

#include "audit/counted.h"
#include "audit/logs/log_reader.h"
#include "audit/platform.h"
#include "catalogue/codec/excerpt.h"
#include "catalogue/codec/expected.h"

namespace touchstone::program {
namespace {

using Cells = std::array<std::string, 5>;

/// Columns as narrow as possible.
void print_columns(const std::vector<Cells>& rows, std::ostream& out) {
  std::array<std::size_t, 5> width{};
  for (const Cells& row : rows)
    for (std::size_t k = 0; k < row.size(); ++k) width[k] = std::max(width[k], row[k].size());
  for (const Cells& row : rows) {
    std::string line = fmt::format("{:{}}  {:{}}  {:>{}}  {:{}}  {}", row[0], width[0], row[1], width[1], row[2],
                                   width[2], row[3], width[3], row[4]);
    out << line.erase(line.find_last_not_of(' ') + 1) << '\n';
  }
}

std::string header_in_words(const LogReader& log) {
  const LogHeader& header = log.header();
  std::string words = log.is_binary() ? "binary" : "JSON lines";
  words += fmt::format(", version {}", log_version);
  if (log.account().logs == 0) return words + ", no header";
  const Declaration& declared = header.declaration;
  if (!declared.engine.empty()) words += ", recorded from " + declared.engine;
  if (header.fields.contains("sampled")) words += ", sampled " + one_line(header.fields["sampled"]);
  return words;
}

std::string end_in_words(const LogAccount& account) {
  const LogEnd& end = account.end;
  std::string words = audit::counted(end.seen, "call") + " seen: " + grouped(end.written) + " written";
  if (end.sampled_out > 0) words += ", " + grouped(end.sampled_out) + " left out by sampling";
  if (end.lost > 0) words += ", " + grouped(end.lost) + " lost because the file was full or could not be written";
  return words;
}

void show(const std::string& file, std::ostream& out) {
  LogReader log(file);
  constexpr std::array<const char*, 5> kinds{"true or false", "whole", "partial", "no answer of it", "error"};
  using Row = std::tuple<std::string, std::size_t, bool, std::size_t>;
  std::map<Row, std::uint64_t> counts;
  for (RecordedCall call; log.next(call);)
    ++counts[{call.operation->name(), call.site, call.binary32, static_cast<std::size_t>(call.answer.kind)}];
  const LogAccount& account = log.account();
  out << (file == "-" ? "standard input" : file) << ": " << header_in_words(log) << '\n';
  if (account.logs > account.cut) out << end_in_words(account) << '\n';
  std::vector<Cells> rows{{"operation", "site", "calls", "numbers", "answers"}};
  for (const auto& [row, count] : counts) {
    const auto& [operation, site, binary32, kind] = row;
    rows.push_back({operation, excerpt(log.sites()[site], 60), grouped(count), number_names[binary32], kinds[kind]});
  }
  if (rows.size() > 1) print_columns(rows, out);
  else out << "no calls\n";
  print_account(account, out);
}

/// Copies the calls, and the header and the end mark of the one log that a file may hold.
void copy(LogReader& log, LogWriter& to) {
  bool begun = false;
  const auto begin = [&] {
    if (log.account().logs > 1) throw UsageError("the file holds several logs: convert each by itself");
    if (!begun && log.account().logs == 1) to.header(log.header());
    begun = true;
  };
  for (RecordedCall call; log.next(call);) {
    begin();
    to.write(call, log.sites()[call.site]);
  }
  begin();
  if (log.account().logs == 1 && log.account().cut == 0) to.end(log.account().end);
  else to.flush();
}

}  // namespace

void print_account(const LogAccount& account, std::ostream& out) {
  for (const auto& [reason, refused] : account.refused)
    out << audit::counted(refused.count, "call") << " that no operation takes: " << excerpt(reason, 200)
        << "; the first: " << refused.first << '\n';
  for (const std::string& remark : account.remarks) out << remark << '\n';
}

int log_show_command(const std::vector<std::string>& files, std::ostream& out) {
  for (const std::string& file : files) show(file, out);
  return nothing_found;
}

int log_convert_command(const LogConvertCommand& command, std::ostream& out, std::ostream& err) {
  std::error_code unknown;
  if (std::filesystem::equivalent(path_of(command.in), path_of(command.out), unknown))
    throw UsageError(command.out + ": is the log that is read");
  LogReader log(command.in);
  std::ofstream opened;
  const bool to_standard_output = is_standard_output(command.out);
  errno = 0;
  if (!to_standard_output) opened.open(command.out, std::ios::binary);
  std::ostream& written = to_standard_output ? out : opened;
  if (!written) throw UsageError(command.out + ": cannot be written: " + why_of(errno));
  const bool binary = command.to.empty() ? !log.is_binary() : command.to == "binary";
  copy(log, *(binary ? binary_writer : json_writer)(written));
  if (!written.flush()) throw UsageError(command.out + ": cannot be written: " + why_of(errno));
  print_account(log.account(), err);
  return log.account().refused.empty() ? nothing_found : bad_usage;
}

}  // namespace touchstone::program
