// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <map>
#include <stdexcept>
#include <string>
#include <vector>

#include "audit/engines/engine.h"
#include "audit/uses.h"
#include "catalogue/judge/verdict.h"
#include "catalogue/operation/operation.h"

/// Calls of foreign functions, recorded with their answers while a program ran (docs/own_inputs.md).
namespace touchstone::audit {

/// A log that cannot be read at all: begins with its name, and the position in it if there is one.
struct LogError : std::runtime_error {
  LogError(const std::string& place, const std::string& what) : std::runtime_error(place + ": " + what) {}
};

/// The version of logs that is written, and the only one that is read.
inline constexpr int log_version = 1;

/// The answer of a recorded call, as it was given.
struct RecordedAnswer {
  enum class Kind {
    plain,    ///< true or false: the only word of `value`
    whole,    ///< `value` is an answer of the operation, all its numbers there
    partial,  ///< the same with numbers omitted: a flag before each tells whether it is present, as in read_json
    text,     ///< `text` is JSON that is no answer of the operation
    error,    ///< the function ended with an error instead, which `text` describes
  };
  Kind kind = Kind::plain;
  EncodedValue<double> value;
  std::string text;
  friend bool operator==(const RecordedAnswer&, const RecordedAnswer&) = default;
};

/// An answer of the engines' protocol as parse_line reads it: true, {"relation":"disjoint"}. An answer that does not
/// fit the operation's shape is text.
RecordedAnswer recorded_answer(const Operation& operation, const Json& answer);
/// An enumerator alone, of an answer whose other parts are numbers or optional. Throws InvalidInput if the operation
/// has no such answer, or no such enumerator.
RecordedAnswer recorded_word(const Operation& operation, Word word);
/// The input of judgement_of_engine. Not for errors.
Json answer_json(const Operation& operation, const RecordedAnswer& answer);

/// Throws InvalidInput unless these words and that many numbers are a value of the shape. Indices in lists are not
/// checked: the validation of the question does that.
void require_shape(const Shape& shape, const std::vector<Word>& words, std::size_t numbers, const char* field,
                   bool partial = false);

/// If a value of alternatives omits the word that tells which it is, inserts it before the other words. It is the first
/// alternative that fits the words and numbers.
void say_alternative(const Shape& shape, EncodedValue<double>& value);

struct RecordedCall {
  const Operation* operation = nullptr;
  Question question;  ///< its numbers may be NaN or infinite, and it may break any rule that the oracle checks
  RecordedAnswer answer;
  std::size_t site = 0;       ///< the call site in the program: an index in LogReader::sites()
  bool binary32 = false;      ///< the function's number type is float
  std::uint64_t ordinal = 0;  ///< the number of the call in the log, in the order of the file, from 0
};

/// The answer of a recorded call as if an engine had given it.
Reply reply_of(const RecordedCall& call);

/// A log's description of its recording.
struct LogHeader {
  Json fields = Json::object();  ///< as they are in the log
  Declaration declaration;       ///< of the recorded engine; its name is empty if the log has no header
};
/// Parses {"touchstone_log":1,"engine":"my game 1.0","boundary":"closed"}. The fields are those of an engine's first
/// line except "ops", all optional, and "sampled", an object that tells which calls were recorded. Throws InvalidInput,
/// which names the version if it is another.
LogHeader read_log_header(const Json& fields);

/// The end mark of a log: the counts of its calls.
struct LogEnd {
  std::uint64_t seen = 0, written = 0;
  std::uint64_t sampled_out = 0;  ///< skipped by sampling
  std::uint64_t lost = 0;         ///< not written because the file had reached its limit, or could not be written
  friend bool operator==(const LogEnd&, const LogEnd&) = default;
};
LogEnd read_log_end(const Json& fields);
Json json_of(const LogEnd& end);

/// Calls that no operation takes, with the same reason.
struct RefusedCalls {
  std::uint64_t count = 0;
  std::string first;  ///< its place and complaint
};

/// The contents of a log besides its calls.
struct LogAccount {
  LogHeader header;  ///< if one file contains several logs, that of the most recent one
  std::vector<std::string> sites;
  std::map<std::string, RefusedCalls> refused;  ///< by reason
  std::vector<std::string> remarks;             ///< further remarks: a truncated log, an incomplete record
  std::uint64_t calls = 0;                      ///< the number delivered
  std::uint64_t logs = 0, cut = 0;              ///< logs in the file, and those without an end mark
  LogEnd end;                                   ///< the sum of the end marks
};

}  // namespace touchstone::audit
