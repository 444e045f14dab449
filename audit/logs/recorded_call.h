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

/// Calls of somebody's own functions, recorded with their answers while a program ran (docs/own_inputs.md).
namespace touchstone::audit {

/// A log that cannot be read at all: it begins with its name, and the place in it where there is one.
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
    partial,  ///< the same with numbers left out: a word before each says whether it is there, as read_json has it
    text,     ///< `text` is JSON that is no answer of the operation
    error,    ///< the function ended with an error instead, which `text` describes
  };
  Kind kind = Kind::plain;
  EncodedValue<double> value;
  std::string text;
  friend bool operator==(const RecordedAnswer&, const RecordedAnswer&) = default;
};

/// An answer of the engines' protocol as parse_line reads it: true, {"relation":"disjoint"}. What the operation's shape
/// does not take is text.
RecordedAnswer recorded_answer(const Operation& operation, const Json& answer);
/// An enumerator alone, of an answer whose other parts are numbers or may be left out. Throws InvalidInput where the
/// operation has no such answer, or no such enumerator.
RecordedAnswer recorded_word(const Operation& operation, Word word);
/// What judgement_of_engine reads. Not of an error.
Json answer_json(const Operation& operation, const RecordedAnswer& answer);

/// Throws InvalidInput unless these words and that many numbers are a value of the shape. Places in lists are not
/// checked: that is for whoever validates the question.
void require_shape(const Shape& shape, const std::vector<Word>& words, std::size_t numbers, const char* field,
                   bool partial = false);

/// Where a value of alternatives leaves out the word that says which it is: puts it before the other words. It is the
/// first alternative that words and numbers fit.
void say_alternative(const Shape& shape, EncodedValue<double>& value);

struct RecordedCall {
  const Operation* operation = nullptr;
  Question question;  ///< its numbers may be NaN or infinite, and it may break any rule that the oracle checks
  RecordedAnswer answer;
  std::size_t site = 0;       ///< where the program made the call: a place in LogReader::sites()
  bool binary32 = false;      ///< the function's number type is float
  std::uint64_t ordinal = 0;  ///< which call of the log it is, in the order of the file, from 0
};

/// The answer of a recorded call as if an engine had given it.
Reply reply_of(const RecordedCall& call);

/// What a log says of its recording.
struct LogHeader {
  Json fields = Json::object();  ///< as they stand in the log
  Declaration declaration;       ///< of the engine that was recorded; its name is empty where the log has no header
};
/// Of {"touchstone_log":1,"engine":"my game 1.0","boundary":"closed"}. The fields are those of an engine's first line
/// but "ops", none of them mandatory, and "sampled", an object that says which calls were recorded. Throws
/// InvalidInput, naming the version where it is another.
LogHeader read_log_header(const Json& fields);

/// The end mark of a log: what became of the calls.
struct LogEnd {
  std::uint64_t seen = 0, written = 0;
  std::uint64_t sampled_out = 0;  ///< left out by sampling
  std::uint64_t lost = 0;         ///< not written because the file had reached its bound, or could not be written
  friend bool operator==(const LogEnd&, const LogEnd&) = default;
};
LogEnd read_log_end(const Json& fields);
Json json_of(const LogEnd& end);

/// Calls that no operation takes, of one reason.
struct RefusedCalls {
  std::uint64_t count = 0;
  std::string first;  ///< its place and complaint
};

/// What a log holds beside its calls.
struct LogAccount {
  LogHeader header;  ///< where several logs stand in one file, the last that has begun
  std::vector<std::string> sites;
  std::map<std::string, RefusedCalls> refused;  ///< by reason
  std::vector<std::string> remarks;             ///< what else has to be told: a cut log, a record that is incomplete
  std::uint64_t calls = 0;                      ///< those handed over
  std::uint64_t logs = 0, cut = 0;              ///< of the logs in the file, those without an end mark
  LogEnd end;                                   ///< the sum of the end marks
};

}  // namespace touchstone::audit
