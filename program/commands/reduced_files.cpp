// SPDX-License-Identifier: Apache-2.0
#include "program/commands/reduced_files.h"

#include <filesystem>
#include <memory>

#include "audit/meshes/repair.h"
#include "audit/platform.h"
#include "audit/text/regression_test.h"
#include "audit/version.h"
#include "catalogue/operation/probes/explained.h"
#include "catalogue/operation/probes/values_in.h"
#include "program/terminal/exit_codes.h"
#include "program/terminal/names.h"
#include "report/pages/html_finding.h"
#include "report/parts/html_parts.h"
#include "report/words/wording.h"

namespace touchstone::program {
namespace {

/// A longer certificate is only in a file of its own.
constexpr std::size_t longest_claim = 4000;

Finding finding_of(const Smallest& smallest) {
  Finding finding{smallest.question, smallest.judgement, smallest.answer};
  finding.range = range_of(smallest.question);
  return finding;
}

std::string picture(const Smallest& smallest) {
  const Finding finding = finding_of(smallest);
  report::OperationOutcome outcome{{smallest.judgement.verdict, "", ""}, {}, "", {}};
  outcome.counted.cases[static_cast<std::size_t>(finding.range)] = 1;
  outcome.counted.example = finding;
  const std::string title = smallest.operation.name() + ", reduced";
  return report::page(title, "<header><p class=\"kicker\">touchstone reduce</p><h1>" + smallest.operation.name() +
                                 "</h1></header><main>" +
                                 report::finding_card(smallest.operation, outcome, *smallest.declaration,
                                                      report::speaker_of(*smallest.declaration), smallest.again) +
                                 "</main>");
}

/// The answer, as `ask` prints it; null if nothing was asked.
Json said_in(const Smallest& smallest) {
  if (smallest.declaration == nullptr) return nullptr;
  Json said = Json::object();
  said["name"] = smallest.declaration->engine;
  said.update(verdict_json(smallest.judgement, smallest.answer));
  return said;
}

std::string block(const std::string& language, const std::string& text) {
  return "```" + language + "\n" + text + "\n```\n";
}

std::string sizes_in_words(const Json& before, const Json& after) {
  std::string text;
  for (const auto& [name, size] : after.items()) {
    const std::string was = before.contains(name) ? one_line(before[name]) : "0";
    text += (text.empty() ? "" : ", ") + name + " from " + was + " to " + one_line(size);
  }
  return text;
}

/// The meshes of a question by the names of their fields, in order.
std::vector<std::string> mesh_names(const Json& input) {
  std::vector<std::string> names;
  for (const auto& [name, value] : input.items())
    if (value.is_object() && value.contains("vertices")) names.push_back(name);
  return names;
}

}  // namespace

std::string bug_report(const Smallest& smallest) {
  const Operation& operation = smallest.operation;
  const std::string input = one_line(operation.print(smallest.question));
  const std::string engine_name = smallest.declaration == nullptr ? "" : smallest.declaration->engine;
  std::string text = "# " + operation.name() + (engine_name.empty() ? "" : ": " + engine_name + " is wrong") + "\n\n";
  text += std::string(operation.metadata().question) + "\n\n";
  if (smallest.examination != nullptr)
    text += "The truth, in exact arithmetic:\n\n" + block("json", one_line(smallest.examination->truth())) + "\n";
  if (!engine_name.empty()) {
    text += engine_name + " answers (" + cause_of(smallest.judgement) + "):\n\n" +
            block("json", one_line(smallest.answer)) + "\n";
    if (smallest.examination != nullptr)
      text += report::why(finding_of(smallest), &operation, report::speaker_of(*smallest.declaration),
                          smallest.declaration->binary32) +
              "\n\n";
  }
  text += "## Input\n\n" + block("json", input);
  const std::string hexadecimal = one_line(operation.print_hexadecimal(smallest.question));
  text += "\nThe same numbers, hexadecimal:\n\n" + block("json", hexadecimal);
  text += "\n## How to repeat\n\n" + block("sh", smallest.repeat);
  text += "\nReduced by `touchstone reduce`: " + sizes_in_words(smallest.before, smallest.after) + ".\n";
  if (smallest.examination != nullptr) {
    const std::string claim = claim_of(*smallest.examination).dump();
    text += "\n## Certificate\n\n`touchstone certify` checks this line without the code that made it";
    text += claim.size() <= longest_claim ? ".\n\n" + block("json", claim) : ": claim.json.\n";
  }
  text += std::string("\n## Versions\n\n- touchstone ") + version_number + ", " + compiler_name + "\n";
  return text + (engine_name.empty() ? "" : "- " + engine_name + "\n");
}

void write_reduced_files(const Smallest& smallest, const std::string& directory) {
  std::error_code error;
  std::filesystem::create_directories(path_of(directory), error);
  if (error) throw UsageError("--out " + directory + ": cannot be made: " + error.message());
  const auto write = [&](const std::string& name, const std::string& text) {
    write_file("--out", directory + "/" + name, text);
  };
  const Json input = smallest.operation.print(smallest.question);
  write("question.json", one_line(input) + "\n");
  const std::vector<std::string> names = mesh_names(input);
  std::size_t mesh_number = 0;
  for_each_value<Meshd>(smallest.operation, smallest.question, [&](const Meshd& mesh, const Cursor<double>&) {
    MeshFile file{};
    file.vertices = mesh.vertices;
    for (std::size_t face = 0; face < named_faces(mesh); ++face) file.faces.push_back(corners_of_named(mesh, face));
    const std::string name = names.at(mesh_number++) + ".obj";
    write(name, text_of_mesh(file, name));
  });
  write("report.md", bug_report(smallest));
  if (smallest.examination == nullptr) return;
  write("claim.json", claim_of(*smallest.examination).dump() + "\n");
  for (const char* framework : test_frameworks)
    write(test_file(framework), RegressionTests(framework).next(*smallest.examination, said_in(smallest)));
  if (smallest.declaration != nullptr) write("picture.html", picture(smallest));
}

}  // namespace touchstone::program
