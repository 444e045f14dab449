// SPDX-License-Identifier: Apache-2.0
#include "audit/counting/drawn_questions.h"
#include "program/commands/commands.h"
#include "program/terminal/exit_codes.h"

namespace touchstone::program {
namespace {

Json line_of(const std::string& family, std::uint64_t index, const Examination& examination) {
  Json line = Json::object();
  line["op"] = examination.operation().name();
  line["family"] = family;
  line["index"] = index;
  line["input"] = examination.operation().print(examination.question());
  line["truth"] = examination.truth();
  line["rounded"] = examination.rounded_truth();
  if (examination.margin()) line["margin"] = written(*examination.margin());
  line["touch"] = examination.touch();
  return line;
}

}  // namespace

int draw_command(const DrawCommand& command, std::ostream& out) {
  const DrawOptions options{split(command.families), command.cases, command.seed, command.range == "ordinary",
                            command.binary32};
  try {
    draw_questions(operation_named(command.operation), options,
                   [&](const std::string& family, std::uint64_t index, const Examination& examination) {
                     out << one_line(line_of(family, index, examination)) << '\n';
                   });
  } catch (const InvalidInput& refused) {
    throw UsageError("--families " + refused.rule());
  }
  return nothing_found;
}

}  // namespace touchstone::program
