// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>
#include <ostream>
#include <unordered_map>

#include "audit/logs/byte_source.h"
#include "audit/logs/recorded_call.h"

/// The two forms of a log, which LogReader and LogWriter unify (docs/own_inputs.md).
namespace touchstone::audit {

/// Reads one form; everything except calls goes into the account.
class LogForm {
 public:
  LogForm(std::string file, ByteSource& source, LogAccount& account)
      : file_(std::move(file)), source_(source), account_(account) {}
  virtual ~LogForm() = default;
  /// Fills in all of the call except its ordinal; returns false at the end of the file.
  virtual bool next(RecordedCall& call) = 0;

 protected:
  /// Starts a log; the one before it, if it is still open, had no end mark.
  void begin_log(LogHeader header);
  void end_log(const LogEnd& end);
  /// The file has ended, or the rest of it cannot be read, which has been reported.
  void end_file(bool read_all = true);
  void refuse(const std::string& place, const InvalidInput& reason, std::uint64_t calls = 1);
  void remark(const std::string& place, const std::string& what);
  /// The index of that text in the account's sites.
  std::size_t site_of(const std::string& text);

  std::string file_;
  ByteSource& source_;
  LogAccount& account_;

 private:
  bool open_ = false;
  std::unordered_map<std::string, std::size_t> sites_;
};

std::unique_ptr<LogForm> json_form(std::string file, ByteSource& source, LogAccount& account);
std::unique_ptr<LogForm> binary_form(std::string file, ByteSource& source, LogAccount& account);

/// The operation of that name whose calls can be recorded. Throws InvalidInput if there is none.
const Operation& recorded_operation(const std::string& name);

/// The first bytes of the binary form; the next is the version.
inline constexpr std::string_view binary_magic{"\x89TSLOG\n", 7};
/// The parts of a file of the binary form, each with its length: text in JSON, or calls.
enum class Frame : char { header = 'H', declaration = 'D', calls = 'C', end = 'E' };

/// The names of number types and answers in both forms.
inline constexpr const char* number_names[] = {"binary64", "binary32"};
inline constexpr const char* answer_names[] = {"plain", "whole", "partial", "text", "error", "word"};
inline constexpr std::size_t word_alone = 5;  ///< an enumerator alone, in the binary form

/// Writes one form.
class LogWriter {
 public:
  explicit LogWriter(std::ostream& out) : out_(out) {}
  virtual ~LogWriter() = default;
  virtual void header(const LogHeader& header) = 0;
  virtual void write(const RecordedCall& call, const std::string& site) = 0;
  virtual void end(const LogEnd& end) = 0;
  /// Writes nothing more: a log without an end mark stays without.
  virtual void flush() {}

 protected:
  std::ostream& out_;
};
std::unique_ptr<LogWriter> json_writer(std::ostream& out);
std::unique_ptr<LogWriter> binary_writer(std::ostream& out);

}  // namespace touchstone::audit
