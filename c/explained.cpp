// SPDX-License-Identifier: Apache-2.0
#include "catalogue/operation/probes/explained.h"

#include <array>
#include <cmath>

#include "c/made.h"
#include "c/touchstone.h"
#include "catalogue/codec/plain.h"
#include "report/figures/space_model.h"
#include "report/figures/svg.h"
#include "report/maps/map_grid.h"
#include "report/words/answered.h"
#include "report/words/phrases.h"
#include "report/words/wording.h"

namespace touchstone::c {
namespace {

/// Adds to an answer and its verdict the answer in words, and the reason where it is wrong.
void add_words(Json& line, const Examination& examination, const Judgement& judgement, report::Speaker speaker,
               bool binary32) {
  const Operation& operation = examination.operation();
  line["sentence"] = report::sentence(operation, plain(line["answer"]));
  if (judgement.verdict == Verdict::agree) return;
  const audit::Finding finding{examination.question(), judgement, line["answer"]};
  line["why"] = report::why(finding, &operation, speaker, binary32);
}

/// The formula's answer to a question of floats, with the exact truth about that question where it is another one.
Json formula_in_float(const Examination& examination) {
  if (const std::string steps = too_many_for_a_cause(examination); !steps.empty())
    return Json::object({{"not_evaluated", steps}});
  const Operation& operation = examination.operation();
  const auto in_floats = operation.examine(operation.in_binary32(examination.question()));
  const Judgement& judgement = in_floats->judge_reference(true);
  Json line = verdict_json(judgement, in_floats->reference(true));
  add_words(line, *in_floats, judgement, report::Speaker::reference, true);
  if (in_floats->question() != examination.question()) {
    line["input"] = operation.print(in_floats->question());
    line["truth"] = in_floats->truth();
  }
  return line;
}

Json explained_in_words(const Operation& operation, const Json& typed) {
  const auto examination = operation.examine(operation.parse(typed));
  Json line = explained(*examination);
  line["sentence"] = report::sentence(operation, examination->truth());
  line["rounded"] = examination->rounded_truth();
  line["outcome"] = examination->outcome();
  line["touch"] = examination->touch();
  if (operation.row().solve_as_typed != nullptr) {
    const Json exact = operation.truth_as_typed(typed);
    line["as_typed"]["sentence"] = report::sentence(operation, exact);
    line["as_typed"]["truth"] = exact;
  }
  add_words(line["robust"], *examination, examination->judge_robust(), report::Speaker::robust, false);
  Json& reference = line["reference"];
  if (reference.contains("cause_not_evaluated"))
    reference["sentence"] = report::sentence(operation, plain(reference["answer"]));
  else if (reference.contains("verdict"))
    add_words(reference, *examination, examination->judge_reference(), report::Speaker::reference, false);
  line["reference_in_float"] = formula_in_float(*examination);
  line["checker"] = certificate_complaint(*examination);
  return line;
}

template <class Figures, std::size_t count>
Json figures_json(const Figures& figures, const std::array<const char*, count>& kinds) {
  Json list = Json::array();
  for (const auto& figure : figures) {
    Json one = Json::object();
    one["kind"] = kinds[static_cast<std::size_t>(figure.kind)];
    one["label"] = figure.label;
    one["numbers"] = Json::array();
    for (const double number : figure.numbers) one["numbers"].push_back(written(number));
    if constexpr (requires { figure.faces; }) {
      if (!figure.faces.empty()) one["faces"] = figure.faces;
    }
    one["whose"] = figure.said ? "answer" : figure.answer ? "truth" : "question";
    if (figure.node) one["node"] = figure.node->depth, one["entered"] = figure.node->entered;
    list.push_back(std::move(one));
  }
  return list;
}

Json drawing_json(const Examination& examination, const Json& answer) {
  const Operation& operation = examination.operation();
  Drawing drawing = examination.drawing();
  if (!answer.is_null()) report::draw_answered(drawing, operation, answer, examination.question());
  const std::string title = operation.name();
  Json line = Json::object();
  line["figures"] =
      figures_json(drawing.figures, std::array{"point", "segment", "line", "ray", "circle", "arrow", "polygon"});
  line["space"] =
      figures_json(drawing.space, std::array{"point", "segment", "arrow", "plane", "polygon", "box", "sphere", "mesh"});
  line["notes"] = drawing.notes;
  line["search"] = drawing.search;
  if (!drawing.figures.empty()) line["svg"] = report::drawing_svg(drawing, title);
  else line["model"] = report::space_model(drawing, title, mpq_class(0));
  return line;
}

}  // namespace
}  // namespace touchstone::c

using namespace touchstone;
using namespace touchstone::catalogue;

int touchstone_explain(const char* operation, const char* question, char** result, touchstone_error* error) {
  return c::made(result, error, [&] {
    return one_line(c::explained_in_words(c::operation_named(operation), parse_line(c::text_of(question, "question"))));
  });
}

int touchstone_drawing(const char* operation, const char* question, const char* answer, char** result,
                       touchstone_error* error) {
  return c::made(result, error, [&] {
    const Operation& asked = c::operation_named(operation);
    return one_line(c::drawing_json(*asked.examine(c::question_of(asked, question)),
                                    answer == nullptr ? Json() : plain(parse_line(answer))));
  });
}

int touchstone_map(const char* operation, const char* question, size_t first, size_t second, size_t side, int binary32,
                   char** result, touchstone_error* error) {
  return c::made(result, error, [&] {
    const Operation& asked = c::operation_named(operation);
    const Question centre = c::question_of(asked, question);
    const std::size_t count = centre.numbers.size();
    if (first >= count || second >= count || first == second)
      throw InvalidInput("axes",
                         "two different numbers of the question, counted from 0 to " + std::to_string(count - 1));
    if (side % 2 == 0 || side >= report::MapGrid::side) throw InvalidInput("side", "an odd number up to 255");
    const report::MapGrid grid = report::map_grid(asked, centre, {first, second}, binary32 != 0);
    constexpr int column_of_centre = report::MapGrid::side / 2, row_of_centre = report::MapGrid::side / 2 - 1;
    const int reach = static_cast<int>(side / 2);
    Json line = Json::object();
    line["fields"] = {grid.fields.first, grid.fields.second};
    line["steps"] = {grid.step.first, grid.step.second};
    line["verdicts"] = Json::array();
    line["truths"] = Json::array();
    for (int down = -reach; down <= reach; ++down) {
      Json verdicts = Json::array(), truths = Json::array();
      for (int right = -reach; right <= reach; ++right) {
        try {
          const auto examination = asked.examine(grid.at(column_of_centre + right, row_of_centre + down));
          verdicts.push_back(name_of(examination->judge_reference(binary32 != 0).verdict));
          truths.push_back(examination->outcome());
        } catch (const InvalidInput&) {
          verdicts.push_back("refused");
          truths.push_back("refused");
        }
      }
      line["verdicts"].push_back(std::move(verdicts));
      line["truths"].push_back(std::move(truths));
    }
    return one_line(line);
  });
}
