// SPDX-License-Identifier: Apache-2.0
#include "audit/counting/audit_run.h"
#include "audit/engines/notes.h"
#include "audit/meshes/formats/mesh_file.h"
#include "audit/text/geometries.h"
#include "audit/text/regression_test.h"
#include "catalogue/codec/plain.h"
#include "catalogue/operation/probes/explained.h"
#include "program/commands/commands.h"
#include "program/commands/file_meshes.h"
#include "program/terminal/exit_codes.h"
#include "report/words/wording.h"

namespace touchstone::program {
namespace {

Json said_by(Engine& engine, const Operation& operation, const Question& question, const Examination& examination,
             bool& found_any) {
  const Reply reply = engine.ask(operation, {question})[0];
  const Judgement judgement = judged(reply, examination, engine.declaration());
  found_any = found_any || is_finding(judgement.verdict);
  Json result = Json::object();
  result["name"] = engine.declaration().engine;
  result.update(verdict_json(judgement, kept(reply.answer)));
  return result;
}

}  // namespace

int ask_command(const AskCommand& command, std::ostream& out, std::ostream& err) {
  const Operation& operation = operation_named(command.operation);
  EngineNotes notes;
  const std::unique_ptr<Engine> engine = engine_for(operation, command.engine, command.timeout, notes);
  const std::string& file = command.file;
  if (named_as_mesh(file))
    throw UsageError(file + ": a mesh is given by --mesh, not as lines of JSON: echo '{}' | touchstone ask " +
                     operation.name() + " --mesh " + file);
  const FileMeshes meshes(command.meshes, command.preparation, &operation);
  if (command.verbose) meshes.tell(err);
  bool refused_any = false, found_any = false;
  RegressionTests tests(command.as);
  const auto refuse = [&](std::uint64_t number, const InvalidInput& refused) {
    Json error = Json::object();
    error["error"]["field"] = refused.field();
    error["error"]["rule"] = refused.rule();
    const auto in_file = meshes.in_file(refused);
    if (in_file) error["error"]["in_file"] = in_file->what();
    if (command.as.empty()) out << one_line(error) << '\n';
    err << (in_file ? in_file->what() : place(file, number) + refused.what()) << '\n';
    refused_any = true;
  };
  const auto answer = [&](std::uint64_t number, const std::string& text) {
    try {
      const Json input = input_in(text, command.wkt, command.geojson, operation, meshes.fields());
      Question question = operation.parse(input);
      if (engine && engine->declaration().binary32) question = operation.in_binary32(question);
      const auto examination = operation.examine(question);
      const Json said = engine ? said_by(*engine, operation, question, *examination, found_any) : Json();
      if (!command.as.empty()) {
        out << tests.next(*examination, said);
        return;
      }
      Json line = command.truth ? truth_alone(*examination) : explained(*examination);
      if (command.truth) meshes.name_in(line["input"]);
      meshes.add_to(line);
      if (engine) line["engine"] = said;
      if (command.as_typed) {
        line["as_typed"] = Json::object();
        line["as_typed"]["truth"] = operation.truth_as_typed(input);
      }
      out << one_line(line) << '\n';
    } catch (const InvalidInput& refused) {
      const std::string option = command.wkt || command.geojson ? "" : option_for(text);
      refuse(number, option.empty()
                         ? refused
                         : InvalidInput(refused.field(), refused.rule() + " (did you mean " + option + "?)"));
    } catch (const std::bad_alloc&) {
      refuse(number, InvalidInput("line", "out of memory"));
    }
  };
  const std::uint64_t lines = command.geojson ? each_json_text(file, answer) : each_line(file, answer);
  notes.tell(err);
  if (lines == 0) {
    err << place(file, 1) << "line: one JSON object, found an empty file\n";
    return bad_usage;
  }
  return refused_any ? bad_usage : found_any ? findings : nothing_found;
}

}  // namespace touchstone::program
