// SPDX-License-Identifier: Apache-2.0
#include "program/commands/recorded/reduce.h"

#include "audit/counting/repeat.h"
#include "audit/engines/pipe.h"
#include "audit/parallel.h"
#include "audit/platform.h"
#include "audit/reducing/reduced.h"
#include "audit/reducing/same_finding.h"
#include "audit/reducing/until.h"
#include "audit/text/geometries.h"
#include "catalogue/codec/plain.h"
#include "catalogue/operation/probes/explained.h"
#include "program/commands/file_meshes.h"
#include "program/commands/reduced_files.h"
#include "program/terminal/each_line.h"
#include "program/terminal/exit_codes.h"
#include "program/terminal/interruptible.h"
#include "program/terminal/progress.h"

namespace touchstone::program {
namespace {

constexpr const char* with_float = "reference,float";

/// The question of the file: alone, or the input of a line from draw, ask or a log of calls.
Question question_of(const ReduceCommand& command, const Operation& operation, const FileMeshes& meshes) {
  std::optional<std::string> text;
  const auto take = [&](std::uint64_t number, const std::string& found) {
    if (text)
      throw UsageError(command.file + ": line " + std::to_string(number) + ": one question, found a second one");
    text = found;
  };
  if (command.file.empty() && !meshes.fields().empty()) text = "{}";
  else if (command.geojson) each_json_text(command.file, take);
  else each_line(command.file, take);
  if (!text) throw UsageError((command.file.empty() ? "standard input" : command.file) + ": one question, found none");
  try {
    Json input = input_in(*text, command.wkt, command.geojson, operation, meshes.fields());
    if (input.is_object() && input.contains("op") && input.contains("input")) {
      if (input["op"] != operation.name()) throw InvalidInput("op", "expected " + operation.name());
      input = Json(input["input"]);
    }
    return operation.parse(input);
  } catch (const InvalidInput& refused) {
    const auto in_file = meshes.in_file(refused);
    if (in_file) throw UsageError(in_file->what());
    throw UsageError((command.file.empty() ? "standard input" : command.file) + ": " + refused.what());
  }
}

/// Engines may crash or hang without limit: that is what is being reduced.
std::vector<std::unique_ptr<Engine>> engines_of(const ReduceCommand& command, const Operation& operation, int jobs,
                                                EngineNotes& notes) {
  require_asked_of_engines({&operation});
  PipeLimits limits;
  limits.timeout = command.timeout;
  limits.start_timeout = 2 * command.timeout;
  limits.restarts = limits.restarts_in_a_row = limits.timeouts = std::numeric_limits<int>::max();
  std::vector<std::unique_ptr<Engine>> engines;
  for (int job = 0; job < jobs; ++job)
    engines.push_back(std::make_unique<PipeEngine>(command.engine, limits, &Interruptible::stopped(), &notes));
  if (!engines[0]->supports(operation.name()))
    throw EngineError(engines[0]->declaration().engine + ": it does not declare " + operation.name() +
                      notes.of_first_line());
  return engines;
}

/// The lengths of the lists that a question has as fields, or as parts of these: {"a.vertices": 8, "a.faces": 12}.
void add_lengths(const Shape& shape, const std::string& path, Cursor<double>& at, Json& lengths) {
  Cursor<double> end = at;
  struct {
    void number(const Shape&, const Cursor<double>&) {}
    void word(const Shape&, const Cursor<double>&) {}
  } nothing;
  walk_encoded(shape, end, nothing);
  if (shape.kind == Shape::Kind::list && (*at.word > 0 || !path.ends_with(".polygons"))) lengths[path] = *at.word;
  if (shape.kind == Shape::Kind::choice) {
    const Word which = *at.word++;
    add_lengths(*shape.parts[which].shape, path, at, lengths);
  } else if (shape.kind == Shape::Kind::record) {
    const bool bare = shape.form == Form::bare;
    for (const Shape::Part& part : shape.parts)
      add_lengths(*part.shape,
                  bare || part.name[0] == 0 ? path
                  : path.empty()            ? part.name
                                            : path + "." + part.name,
                  at, lengths);
  }
  at = end;
}

Json size_of(const Operation& operation, const Question& question) {
  Json size = Json::object();
  Cursor<double> at(question);
  add_lengths(operation.question_shape(), "", at, size);
  size["characters"] = one_line(operation.print(question)).size();
  return size;
}

/// Decides whether a question is still of interest.
struct Deciding {
  std::unique_ptr<Respondent> asked{};  ///< nullptr: a command decides
  std::unique_ptr<Interest> interest{};
};

/// Rounds the question as it will be asked. Throws UsageError if there is nothing to reduce.
Deciding deciding(const ReduceCommand& command, const Operation& operation, int jobs, EngineNotes& notes,
                  Question& question) {
  Deciding made;
  if (!command.until.empty()) {
    made.interest = std::make_unique<Until>(operation, command.until, command.timeout, command.allow_invalid);
    const audit::Look look = made.interest->look(0, question);
    if (look == audit::Look::refused)
      throw UsageError("the question is outside the contract; --allow-invalid takes it");
    if (look == audit::Look::fails)
      throw UsageError("--until: the command does not end with exit code 0 on the question");
    return made;
  }
  made.asked = command.engine.empty() ? formula_as_respondent(command.with == with_float)
                                      : respondent(engines_of(command, operation, jobs, notes));
  auto same = std::make_unique<SameFinding>(operation, *made.asked,
                                            SameFindingOptions{command.any_answer, command.allow_invalid});
  question = same->fitted(question);
  try {
    const std::string why_not = same->begin(question);
    if (!why_not.empty()) throw UsageError("nothing to reduce: " + why_not);
  } catch (const InvalidInput& refused) {
    throw UsageError(std::string("the question is outside the contract: ") + refused.what());
  }
  made.interest = std::move(same);
  return made;
}

/// The line that asks the question again.
std::string repeat_line(const ReduceCommand& command, const Operation& operation, const Question& question,
                        const Repeat& repeat) {
  if (!command.until.empty())
    return "echo '" + one_line(operation.print(question)) + "' | (" + command.until + "); echo $?";
  std::string line = repeat_command(operation, question, repeat, !command.engine.empty());
  // `ask` evaluates the formula only in double.
  if (command.engine.empty() && command.with == with_float)
    line.replace(line.rfind(" ask "), std::string::npos, " reduce " + operation.name() + " --with " + with_float);
  return line;
}

}  // namespace

int reduce_command(const ReduceCommand& command, std::ostream& out, std::ostream& err) {
  const Operation& operation = operation_named(command.operation);
  const FileMeshes meshes(command.meshes, command.preparation, &operation);
  Question question = question_of(command, operation, meshes);
  const int jobs = command.jobs > 0 ? command.jobs : jobs_of_machine();
  const Interruptible interruptible;
  EngineNotes notes;
  const Deciding decide = deciding(command, operation, jobs, notes, question);
  Progress progress(err, is_terminal(Stream::error), {}, 0);
  const Reduced found =
      reduced(operation, question, *decide.interest,
              {jobs, TimeLimit(command.seconds), &Interruptible::stopped(),
               [&](const Question& best) { progress.tell("reduce: " + one_line(size_of(operation, best))); },
               command.allow_degenerate});
  progress.end();
  notes.tell(err);
  Smallest smallest{operation, found.question};
  smallest.before = size_of(operation, question), smallest.after = size_of(operation, found.question);
  smallest.again = repeat_of(command.program, command.engine, command.timeout);
  smallest.repeat = repeat_line(command, operation, found.question, smallest.again);
  Json line = Json::object();
  line["op"] = operation.name();
  line["input"] = operation.print(found.question);
  std::unique_ptr<const Examination> examination;
  std::string outside;
  const bool too_large = steps_too_many(operation, found.question);
  try {
    if (too_large) line["robust"] = operation.answer_json(operation.row().robust(found.question, 0));
    else examination = operation.examine(found.question), line["truth"] = examination->truth();
  } catch (const InvalidInput& refused) {
    outside = refused.what();
  }
  smallest.examination = examination.get();
  if (decide.asked) {
    const Reply reply = decide.asked->reply(0, operation, found.question);
    smallest.declaration = &decide.asked->declaration();
    smallest.answer = kept(reply.answer);
    if (examination) smallest.judgement = decide.asked->judgement(reply, *examination);
    else if (reply.kind == Reply::Kind::failed) smallest.judgement = {Verdict::invalid, 0, reply.remark};
    line["engine"]["name"] = smallest.declaration->engine;
    line["engine"].update(verdict_json(smallest.judgement, smallest.answer));
    if (too_large && reply.kind != Reply::Kind::failed) line["engine"]["verdict"] = "not robust's answer";
  }
  if (!outside.empty()) line["outside_the_contract"] = outside;
  line["before"] = smallest.before, line["after"] = smallest.after;
  line["candidates"] = found.candidates, line["rounds"] = found.rounds, line["finished"] = found.finished;
  out << one_line(line) << '\n';
  if (!command.directory.empty()) write_reduced_files(smallest, command.directory);
  return Interruptible::stopped() ? interrupted : nothing_found;
}

}  // namespace touchstone::program
