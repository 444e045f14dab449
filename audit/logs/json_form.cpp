// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cmath>
#include <string_view>

#include "audit/engines/question_text.h"
#include "audit/logs/log_form.h"
#include "catalogue/codec/expected.h"
#include "catalogue/codec/plain.h"

namespace touchstone::audit {
namespace {

/// The data kept for each operation to read its lines without a document: most answers of a program are the same few.
struct KnownOperation {
  explicit KnownOperation(const Operation& operation) : operation(operation), text(operation) {}
  const Operation& operation;
  QuestionText text;
  std::unordered_map<std::string, RecordedAnswer> answers;
};
constexpr std::size_t most_answers = 1000, longest_answer = 100;

/// The parts of a line in the form of JsonWriter: the same fields in the same order, no spaces.
struct LineParts {
  std::string_view operation, input, answer, number, site;
};

bool take_suffix(std::string_view& text, std::string_view begin, std::string_view& value) {
  const std::size_t at = text.rfind(begin);
  if (at == text.npos || text.back() != '"') return false;
  value = text.substr(at + begin.size(), text.size() - at - begin.size() - 1);
  if (value.find_first_of("\"\\") != value.npos) return false;
  text = text.substr(0, at);
  return true;
}

bool split(std::string_view line, LineParts& parts) {
  constexpr std::string_view begin = R"({"op":")", input = R"(","input":)", answer = R"(,"answer":)";
  if (line.substr(0, begin.size()) != begin || line.back() != '}') return false;
  line = line.substr(begin.size(), line.size() - begin.size() - 1);
  const std::size_t name = line.find(input);
  if (name == line.npos) return false;
  parts = {line.substr(0, name), {}, {}, {}, {}};
  line.remove_prefix(name + input.size());
  const std::size_t question = line.find(answer);
  if (question == line.npos) return false;
  parts.input = line.substr(0, question);
  line.remove_prefix(question + answer.size());
  take_suffix(line, R"(,"site":")", parts.site);
  take_suffix(line, R"(,"number":")", parts.number);
  parts.answer = line;
  return true;
}

bool read_number_type(const Json& json) {
  const auto known = [&](const char* name) { return json == name; };
  const auto* const found = std::find_if(std::begin(number_names), std::end(number_names), known);
  if (found == std::end(number_names)) throw InvalidInput("number", expected("binary64 or binary32", json));
  return found != number_names;
}

std::string read_text(const Json& json, const char* field) {
  if (!json.is_string() || is_typed_number(json)) throw InvalidInput(field, expected("text", json));
  return json.get<std::string>();
}

class JsonForm : public LogForm {
 public:
  using LogForm::LogForm;

  bool next(RecordedCall& call) override {
    while (const auto line = source_.line()) {
      ++line_;
      const std::size_t last = line->text.find_last_not_of(" \t\r");
      if (last == line->text.npos) continue;
      const std::string_view text = line->text.substr(0, last + 1);
      if (read_quickly(text, call)) return true;
      try {
        if (read(parse_line(std::string(text)), call)) return true;
      } catch (const InvalidInput& wrong) {
        if (line->ended) refuse(place(), wrong);
        else remark(place(), "the last line is incomplete");
      }
    }
    end_file();
    return false;
  }

 private:
  std::string place() const { return ":" + std::to_string(line_); }

  KnownOperation& known(const std::string& name) {
    const auto found = known_.find(name);
    if (found != known_.end()) return found->second;
    return known_.try_emplace(name, recorded_operation(name)).first->second;
  }

  bool read_quickly(std::string_view text, RecordedCall& call) {
    LineParts parts;
    if (!split(text, parts)) return false;
    const auto found = known_.find(std::string(parts.operation));
    if (found == known_.end() || !found->second.text.read(parts.input, call.question)) return false;
    try {
      call.operation = &found->second.operation;
      call.binary32 = parts.number.empty() ? account_.header.declaration.binary32
                                           : read_number_type(Json(std::string(parts.number)));
      call.site = site_of(std::string(parts.site));
      read_answer(found->second, parts.answer, call.answer);
      return true;
    } catch (const InvalidInput&) {
      return false;
    }
  }

  static void read_answer(KnownOperation& known, std::string_view text, RecordedAnswer& answer) {
    if (text == "true" || text == "false") {
      answer.kind = RecordedAnswer::Kind::plain;
      answer.text.clear();
      answer.value.numbers.clear();
      answer.value.words.assign(1, text == "true" ? 1 : 0);
      return;
    }
    const std::string owned(text);
    const auto found = known.answers.find(owned);
    if (found != known.answers.end()) {
      answer = found->second;
      return;
    }
    answer = recorded_answer(known.operation, parse_line(owned));
    if (owned.size() <= longest_answer && known.answers.size() < most_answers) known.answers.emplace(owned, answer);
  }

  /// Returns false if the line is a header or an end mark.
  bool read(const Json& json, RecordedCall& call) {
    if (!json.is_object()) throw InvalidInput("line", expected("one JSON object", json));
    if (json.contains("touchstone_log")) {
      begin(json);
      return false;
    }
    if (json.contains("end") && json.size() == 1) {
      end_log(read_log_end(json["end"]));
      return false;
    }
    require_fields(json, "", {"op", "input", "answer", "error", "number", "site"});
    for (const char* name : {"op", "input"}) {
      if (!json.contains(name)) throw InvalidInput(name, "missing");
    }
    KnownOperation& of = known(read_text(json["op"], "op"));
    call.operation = &of.operation;
    call.question = of.operation.parse_any(json["input"]);
    call.binary32 = json.contains("number") ? read_number_type(json["number"]) : account_.header.declaration.binary32;
    if (json.contains("answer") == json.contains("error"))
      throw InvalidInput("answer", json.contains("error") ? "given, and an error too" : "missing");
    if (json.contains("error")) call.answer = {RecordedAnswer::Kind::error, {}, read_text(json["error"], "error")};
    else call.answer = recorded_answer(of.operation, json["answer"]);
    call.site = site_of(json.contains("site") ? read_text(json["site"], "site") : "");
    return true;
  }

  void begin(const Json& json) {
    LogHeader header;
    try {
      header = read_log_header(json);
    } catch (const InvalidInput& wrong) {
      throw LogError(file_ + place(), wrong.what());
    }
    begin_log(std::move(header));
  }

  std::unordered_map<std::string, KnownOperation> known_;
  std::uint64_t line_ = 0;
};

class JsonWriter : public LogWriter {
 public:
  using LogWriter::LogWriter;

  void header(const LogHeader& header) override {
    binary32_ = header.declaration.binary32;
    out_ << one_line(header.fields) << '\n';
  }

  void write(const RecordedCall& call, const std::string& site) override {
    line_ = R"({"op":")";
    line_ += call.operation->metadata().name;
    line_ += R"(","input":)";
    const auto finite = [](double number) { return std::isfinite(number); };
    if (std::all_of(call.question.numbers.begin(), call.question.numbers.end(), finite))
      text_of(*call.operation).write(call.question, line_);
    else line_ += one_line(call.operation->print(call.question));
    const bool error = call.answer.kind == RecordedAnswer::Kind::error;
    line_ += error ? R"(,"error":)" : R"(,"answer":)";
    line_ += error ? one_line(call.answer.text) : one_line(written_answer(call));
    if (call.binary32 != binary32_) (line_ += R"(,"number":")") += std::string(number_names[call.binary32]) + '"';
    if (!site.empty()) (line_ += R"(,"site":)") += one_line(site);
    out_ << line_ << "}\n";
  }

  void end(const LogEnd& end) override { out_ << one_line(Json{{"end", json_of(end)}}) << '\n'; }

 private:
  static Json written_answer(const RecordedCall& call) {
    if (call.answer.kind == RecordedAnswer::Kind::text) return parse_own_line(call.answer.text);
    return plain(answer_json(*call.operation, call.answer));
  }
  const QuestionText& text_of(const Operation& operation) {
    return texts_.try_emplace(&operation, operation).first->second;
  }

  std::unordered_map<const Operation*, QuestionText> texts_;
  std::string line_;
  bool binary32_ = false;
};

}  // namespace

std::unique_ptr<LogForm> json_form(std::string file, ByteSource& source, LogAccount& account) {
  return std::make_unique<JsonForm>(std::move(file), source, account);
}

std::unique_ptr<LogWriter> json_writer(std::ostream& out) { return std::make_unique<JsonWriter>(out); }

}  // namespace touchstone::audit
