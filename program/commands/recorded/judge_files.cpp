// SPDX-License-Identifier: Apache-2.0
#include "program/commands/recorded/judge_files.h"

#include <filesystem>

#include "audit/counted.h"
#include "audit/meshes/in_file.h"
#include "catalogue/codec/excerpt.h"
#include "catalogue/codec/nearest_double.h"
#include "program/commands/commands.h"
#include "audit/text/geometries.h"
#include "program/terminal/each_line.h"
#include "program/terminal/interruptible.h"

namespace touchstone::program {
namespace {

/// A shape of a file, as a field of a question, and its name.
struct NamedShape {
  std::string name;
  Json shape;
};

bool ends_in(const std::string& file, std::initializer_list<const char*> extensions) {
  const std::string extension = std::filesystem::path(file).extension().string();
  return std::any_of(extensions.begin(), extensions.end(), [&](const char* one) { return extension == one; });
}

void add_geometries(const std::string& file, const Json& geometries, std::uint64_t line,
                    std::vector<NamedShape>& shapes) {
  for (const Json& geometry : geometries) shapes.push_back({file + ":" + std::to_string(line), geometry});
}

std::vector<NamedShape> shapes_in(const std::vector<std::string>& files) {
  std::vector<NamedShape> shapes;
  for (const std::string& file : files) {
    try {
      if (ends_in(file, {".wkt", ".txt"}))
        each_line(file, [&](std::uint64_t line, const std::string& text) {
          add_geometries(file, geometries_of_wkt(text), line, shapes);
        });
      else if (ends_in(file, {".geojson", ".json"}))
        each_json_text(file, [&](std::uint64_t line, const std::string& text) {
          add_geometries(file, geometries_of_geojson(text), line, shapes);
        });
      else
        shapes.push_back({file, parse_line(one_line(to_json(audit::prepared(audit::read_mesh_file(file), {}).mesh)))});
    } catch (const InvalidInput& refused) {
      throw UsageError((refused.field().starts_with(file) ? "" : file + ": ") + refused.what());
    }
  }
  return shapes;
}

/// Asks and judges a batch of questions at a time.
class AskedFiles {
 public:
  AskedFiles(const Operation& operation, Engine& engine)
      : operation_(operation), engine_(engine), judge_(engine.declaration(), {}) {}

  void add(Question question, const std::string& name) {
    calls_.emplace_back();
    calls_.back().operation = &operation_;
    calls_.back().question = std::move(question);
    calls_.back().binary32 = engine_.declaration().binary32;
    calls_.back().site = names_.size();
    calls_.back().ordinal = asked_++;
    names_.push_back(name);
    if (calls_.size() == at_once) ask();
  }

  void ask() {
    std::vector<Question> questions;
    for (RecordedCall& call : calls_) {
      if (call.binary32) call.question = operation_.in_binary32(call.question);
      questions.push_back(call.question);
    }
    const std::vector<Reply> replies = engine_.ask(operation_, questions);
    for (std::size_t i = 0; i < calls_.size(); ++i) {
      if (replies[i].kind == Reply::Kind::unsupported) continue;
      if (!replies[i].asked) {
        if (!Interruptible::stopped()) judge_.leave(calls_[i], replies[i].remark);
        continue;
      }
      calls_[i].answer = replies[i].kind == Reply::Kind::failed
                             ? RecordedAnswer{RecordedAnswer::Kind::error, {}, replies[i].remark}
                             : audit::recorded_answer(operation_, replies[i].answer);
      judge_.judge(calls_[i]);
    }
    calls_.clear();
  }

  audit::CallJudge& judge() { return judge_; }
  const std::vector<std::string>& names() const { return names_; }

 private:
  static constexpr std::size_t at_once = 64;
  const Operation& operation_;
  Engine& engine_;
  audit::CallJudge judge_;
  std::vector<RecordedCall> calls_{};
  std::vector<std::string> names_{};
  std::uint64_t asked_ = 0;
};

void add_pairs(const Operation& operation, const std::vector<std::string>& files, AskedFiles& asked) {
  const FieldNames& fields = operation.fields();
  if (fields.size() != 2) throw UsageError("--pairs " + operation.name() + ": expected an operation of two shapes");
  const std::vector<NamedShape> shapes = shapes_in(files);
  if (shapes.size() < 2)
    throw UsageError("--pairs: expected at least two shapes, got " + std::to_string(shapes.size()));
  for (std::size_t i = 0; i < shapes.size() && !Interruptible::stopped(); ++i) {
    for (std::size_t j = i + 1; j < shapes.size(); ++j) {
      const std::string name = shapes[i].name + " " + shapes[j].name;
      try {
        const bool geometries = shapes[i].shape.contains("type");
        const Json input = geometries
                               ? input_of(operation, Json::array({shapes[i].shape, shapes[j].shape}), Json::object())
                               : Json{{fields[0], shapes[i].shape}, {fields[1], shapes[j].shape}};
        asked.add(operation.parse(input), name);
      } catch (const InvalidInput& refused) {
        throw UsageError(name + ": " + refused.what());
      }
    }
  }
}

/// The numbers of a line, separated by commas, semicolons or tabs; none if no cell is a number, as in a heading.
std::vector<double> numbers_of(const std::string& line, const std::string& place, bool may_be_heading) {
  std::vector<double> numbers;
  std::string wrong;
  for (std::size_t begin = 0; begin <= line.size();) {
    const std::size_t end = std::min(line.find_first_of(",;\t", begin), line.size());
    std::string cell = line.substr(begin, end - begin);
    cell.erase(0, cell.find_first_not_of(" \r"));
    cell.erase(cell.find_last_not_of(" \r") + 1);
    const std::optional<double> number = nearest_double(cell);
    if (number) numbers.push_back(*number);
    else if (wrong.empty()) wrong = "column " + std::to_string(numbers.size() + 1) + ": expected a number, got " + cell;
    begin = end + 1;
  }
  if (!wrong.empty() && !(numbers.empty() && may_be_heading)) throw UsageError(place + excerpt(wrong, 200));
  return numbers;
}

void add_columns(const Operation& operation, const std::vector<std::string>& files, AskedFiles& asked) {
  // The number of columns selects one of several forms, in the plane or in space; it is the only word of a question.
  const std::vector<Question> forms = operation.zeros_of_alternatives(0);
  const std::size_t words = forms.size() > 1 ? 1 : 0;
  std::string lengths;
  for (const Question& form : forms) lengths += (lengths.empty() ? "" : " or ") + std::to_string(form.numbers.size());
  const auto of_numbers = [&](const Question& form) { return form.words.size() == words; };
  if (!std::all_of(forms.begin(), forms.end(), of_numbers))
    throw UsageError("--columns " + operation.name() + ": expected an operation whose questions are numbers alone");
  for (const std::string& file : files) {
    each_line(file, [&](std::uint64_t line, const std::string& text) {
      const std::string place = (file == "-" ? "standard input" : file) + ": line " + std::to_string(line) + ": ";
      std::vector<double> numbers = numbers_of(text, place, line == 1);
      if (numbers.empty()) return;
      const auto form = std::find_if(forms.begin(), forms.end(),
                                     [&](const Question& one) { return one.numbers.size() == numbers.size(); });
      if (form == forms.end())
        throw UsageError(place + "expected " + lengths + " numbers, got " + std::to_string(numbers.size()));
      asked.add({std::move(numbers), form->words}, file);
    });
  }
}

}  // namespace

audit::JudgedLogs judge_files(const JudgeCommand& command, EngineNotes& notes) {
  const Operation& operation = operation_named(command.pairs.empty() ? command.columns : command.pairs);
  if (command.engine.empty()) throw UsageError("--pairs, --columns: expected --engine too, to answer the questions");
  require_asked_of_engines({&operation});
  const auto engine = pipe_engine(command.engine, command.timeout, &Interruptible::stopped(), &notes);
  if (!engine->supports(operation.name()))
    throw EngineError(engine->declaration().engine + ": it does not declare " + operation.name());
  AskedFiles asked(operation, *engine);
  command.pairs.empty() ? add_columns(operation, command.files, asked) : add_pairs(operation, command.files, asked);
  asked.ask();
  audit::JudgedLogs judged;
  judged.tally.declaration = engine->declaration();
  judged.tally.logs = command.files;
  audit::SumOfCalls sum;
  sum.add(asked.judge(), asked.names());
  sum.complete(judged.tally);
  judged.tally.declaration.binary32 = engine->declaration().binary32;
  judged.tally.repeat = repeat_of(command.program, command.engine, command.timeout);
  judged.tally.repeat.recorded = true;
  judged.tally.interrupted = Interruptible::stopped();
  return judged;
}

}  // namespace touchstone::program
