// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <map>
#include <mutex>

#include "report/pages/condition_plot.h"
#include "report/pages/contract.h"
#include "report/pages/html.h"
#include "report/pages/html_compare.h"
#include "report/pages/html_confusion.h"
#include "report/pages/html_finding.h"
#include "report/pages/html_footer.h"
#include "report/pages/html_map.h"
#include "report/pages/html_nearness.h"
#include "report/pages/html_search.h"
#include "report/parts/html_parts.h"
#include "report/words/phrases.h"
#include "report/words/ways.h"

namespace touchstone::report {
namespace {

std::string kind_in_words(const Metadata& metadata) {
  switch (metadata.kind) {
    case Kind::decision: return "a decision: right or wrong";
    case Kind::measure: return "numbers: judged by their distance from the exact value in ulps";
    case Kind::set: return "a set: equal after canonical order";
    case Kind::checked: return "many right answers: a checker accepts or refuses";
    case Kind::covering: return "nothing may be missing";
  }
  return "";
}

std::string navigation(const Tally& tally, std::size_t operation) {
  std::string text = "<nav><a href=\"index.html\">All operations</a>";
  const auto link = [&](std::size_t to, const std::string& words) {
    text += fmt::format("<a href=\"{0}.html\"{2}>{1}</a>", escaped(tally.operations[to].operation), words,
                        to > operation ? " class=\"end\"" : "");
  };
  if (operation > 0) link(operation - 1, "\u2190 " + breakable(tally.operations[operation - 1].operation));
  if (operation + 1 < tally.operations.size())
    link(operation + 1, breakable(tally.operations[operation + 1].operation) + " \u2192");
  return text + "</nav>";
}

std::string opening(const Tally& tally, const OperationTally& counted_here, const Operation* known) {
  std::string text = std::string("<header><p class=\"kicker\">touchstone ") +
                     (tally.repeat.recorded ? "judge" : "audit") + " of " + escaped(subject(tally.declaration)) +
                     "</p><h1>" + breakable(counted_here.operation) + "</h1>";
  if (known) {
    const Metadata& metadata = known->metadata();
    std::string fields;
    for (const char* field : metadata.fields) fields += std::string(fields.empty() ? "" : ", ") + field;
    text += "<p class=\"lead\">" + escaped(metadata.question) + "</p><ul class=\"chips\">";
    for (const std::string& chip : {"chapter: " + std::string(metadata.chapter), pages_in_words(*known),
                                    "input: " + fields, kind_in_words(metadata)}) {
      text += "<li>" + escaped(chip) + "</li>";
    }
    text += "</ul>";
  }
  return text + "</header>";
}

std::string summary(const Tally& tally, std::size_t operation) {
  const Cell total = tally.operations[operation].total();
  std::string text = "<div class=\"card\"><p><strong>" + escaped(subject(tally.declaration)) +
                     "</strong>: " + escaped(summary_of(total)) + ".</p>" + verdict_bar(total, false);
  for (const OperationTally& robust : tally.robust) {
    if (robust.operation != tally.operations[operation].operation) continue;
    const Cell same = robust.total();
    text += "<p class=\"apart\"><strong>robust</strong>, the same questions: " + escaped(summary_of(same)) + ".</p>" +
            verdict_bar(same, true);
  }
  if (total.nothing_right()) text += "<p class=\"apart\">" + escaped(nothing_right_in_words(total)) + ".</p>";
  if (total.not_asked > 0) text += "<p class=\"apart\">" + escaped(not_asked_in_words(total)) + ".</p>";
  if (total.surplus > 0) text += "<p class=\"apart\">" + escaped(surplus_in_words(total, tally.max_surplus)) + ".</p>";
  if (tally.operations[operation].inconsistent_convention()) {
    text +=
        "<p class=\"apart\"><strong>Inconsistent convention</strong>: where shapes only touch, it answers as "
        "closed sets do in " +
        counted(total.touches_closed, "case") + " and as open sets do in " + counted(total.touches_open, "case") +
        ".</p>";
  }
  return text + "</div>";
}

std::string cards(const OperationTally& tally, const Operation& known, const Tally& whole, Speaker speaker) {
  std::string text, others;
  const std::vector<OperationOutcome> outcomes = outcomes_of(tally);
  for (std::size_t i = 0; i < outcomes.size(); ++i) {
    if (i < most_outcomes) {
      text += finding_card(known, outcomes[i], whole.declaration, speaker, whole.repeat);
      continue;
    }
    const JudgedOutcome& outcome = outcomes[i].outcome;
    others += "<li>" + badge(outcome.verdict, speaker) + " " +
              escaped(phrase(known, outcome) + ": " + counted(both(outcomes[i].counted.cases), "case")) + "</li>";
  }
  if (!others.empty()) text += "<details><summary>Less frequent ways</summary><ul>" + others + "</ul></details>";
  return text;
}

std::string findings(const Tally& tally, const OperationTally& here, const Operation& known) {
  std::string text = cards(here, known, tally, speaker_of(tally.declaration));
  for (const OperationTally& robust : tally.robust) {
    if (robust.operation != here.operation) continue;
    const std::string of_robust = cards(robust, known, tally, Speaker::robust);
    if (!of_robust.empty()) text += "<h2>robust is wrong</h2>" + of_robust;
  }
  if (!text.empty()) return text;
  const Cell total = here.total();
  return total.count(Verdict::unsupported) == total.cases() && total.cases() > 0
             ? "<p>The engine does not answer this operation.</p>"
         : total.surplus > 0 ? "<p>Nothing is missing; what is listed beyond the truth is counted above.</p>"
                             : "<p>Nothing was found.</p>";
}

std::string by_family(const OperationTally& tally, bool recorded) {
  const Cell total = tally.total();
  const std::vector<Column> columns = columns_of(total);
  std::string text = "<div class=\"card scroll\"><table class=\"stack\"><thead><tr><th scope=\"col\">" +
                     std::string(recorded ? "call site" : "family") +
                     "</th><th "
                     "scope=\"col\" class=\"text\"></th>" +
                     headings(columns) + "</tr></thead><tbody>";
  for (const auto& [family, cell] : tally.families) {
    text += "<tr><th scope=\"row\">" + breakable(family) + "</th><td class=\"bar-cell\">" + verdict_bar(cell, true) +
            "</td>" + numbers(columns, cell) + "</tr>";
  }
  return text + "<tr class=\"total\"><th scope=\"row\">all</th><td></td>" + numbers(columns, total) +
         "</tr></tbody></table>" +
         (total.refused == 0 ? ""
                             : "<p class=\"small quiet\">Drawn but outside the contract, so no cases: " +
                                   grouped(total.refused) + ".</p>") +
         "</div>";
}

/// The part of a page that does not depend on the audit. It requires solving questions, so it is made once.
template <std::string (*section)(const Operation&)>
const std::string& of_operation(const Operation& operation) {
  struct Made {
    std::once_flag begun;
    std::string text;
  };
  static std::mutex guard;
  static std::map<const Operation*, Made> made;
  Made& here = [&]() -> Made& {
    const std::scoped_lock lock(guard);
    return made[&operation];
  }();
  std::call_once(here.begun, [&] { here.text = section(operation); });
  return here.text;
}

}  // namespace

std::string operation_page(const Tally& tally, std::size_t operation, const std::vector<FailureMap>& maps,
                           const ReportNotes& notes) {
  const OperationTally& here = tally.operations[operation];
  const Operation* known = find_operation(here.operation);
  const Speaker speaker = speaker_of(tally.declaration);
  const bool recorded = tally.repeat.recorded;
  std::string body = navigation(tally, operation) + opening(tally, here, known) + "<main>" + summary(tally, operation);
  if (notes.before != nullptr) body += comparison(*notes.before, tally, here.operation);
  if (known) body += contract_section(*known);
  if (known) {
    const std::string matrix = confusion_matrix(
        *known, here.total(), speaker == Speaker::foreign ? tally.declaration.engine : std::string("the formula"));
    if (!matrix.empty()) body += "<h2>Truth and answer</h2>" + matrix;
    if (recorded) body += "<h2>By call site</h2>" + by_family(here, recorded) + nearness_section(here);
    body += "<h2>How it fails, an example of each way</h2>" + findings(tally, here, *known);
    // These concern the textbook formula, and drawn questions.
    if (!recorded) body += of_operation<right_case>(*known) + of_operation<search_section>(*known);
  }
  if (known && !maps.empty() && subject_of(maps).findings() > 0) {
    body += "<h2 id=\"map\">Failure map</h2><div class=\"card\">" + map_section(*known, maps, tally.repeat) + "</div>";
  }
  const bool is_over = notes.expected == 0;
  if (is_over && known && speaker == Speaker::reference && !tally.declaration.binary32)
    body += of_operation<condition_section>(*known);
  if (!recorded) body += "<h2>By family of inputs</h2>" + by_family(here, recorded);
  return page("touchstone: " + here.operation, body + "</main>" + page_footer(tally, notes));
}

std::string map_page(const Operation& operation, const std::vector<FailureMap>& maps, const Repeat& repeat) {
  const Metadata& metadata = operation.metadata();
  return page("touchstone map: " + operation.name(),
              "<header><p class=\"kicker\">touchstone map</p><h1>" + breakable(operation.name()) +
                  "</h1><p class=\"lead\">" + escaped(metadata.question) + " (" + escaped(pages_in_words(operation)) +
                  ")</p><p>" + escaped(in_words(maps)) + ".</p></header><main><div class=\"card\">" +
                  map_section(operation, maps, repeat) + "</div></main>" + page_footer());
}

}  // namespace touchstone::report
