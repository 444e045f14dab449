// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include "report/condition_plot.h"
#include "report/html.h"
#include "report/html_finding.h"
#include "report/html_map.h"
#include "report/html_parts.h"

namespace touchstone::audit {
namespace {

std::string kind_in_words(const Card& card) {
  switch (card.kind) {
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
  if (operation > 0) link(operation - 1, "\u2190 " + escaped(tally.operations[operation - 1].operation));
  if (operation + 1 < tally.operations.size())
    link(operation + 1, escaped(tally.operations[operation + 1].operation) + " \u2192");
  return text + "</nav>";
}

std::string opening(const Tally& tally, const OperationTally& counted_here, const Operation* known) {
  std::string text = "<header><p class=\"kicker\">touchstone audit of " + escaped(subject(tally.declaration)) +
                     "</p><h1>" + escaped(counted_here.operation) + "</h1>";
  if (known) {
    const Card& card = known->card();
    std::string fields;
    for (const char* field : card.fields) fields += std::string(fields.empty() ? "" : ", ") + field;
    text += "<p class=\"lead\">" + escaped(card.question) + "</p><ul class=\"chips\">";
    for (const std::string& chip : {"chapter: " + std::string(card.chapter), "deck p. " + std::string(card.pages),
                                    "input: " + fields, kind_in_words(card)}) {
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
    text += "<p style=\"margin-top:14px\"><strong>robust</strong>, the same questions: " + escaped(summary_of(same)) +
            ".</p>" + verdict_bar(same, true);
  }
  if (total.not_asked > 0) text += "<p style=\"margin-top:14px\">" + escaped(not_asked_in_words(total)) + ".</p>";
  if (tally.operations[operation].inconsistent_convention()) {
    text +=
        "<p style=\"margin-top:14px\"><strong>Inconsistent convention</strong>: where shapes only touch, it answers as "
        "closed sets do in " +
        counted(total.touches_closed, "case") + " and as open sets do in " + counted(total.touches_open, "case") +
        ".</p>";
  }
  return text + "</div>";
}

std::string cards(const OperationTally& tally, const Operation& known, const Tally& whole, Speaker speaker) {
  std::string text;
  const Cell total = tally.total();
  for (std::size_t v = 1; v < verdict_count; ++v) {
    const auto verdict = static_cast<Verdict>(v);
    const Smallest smallest = smallest_of(tally, verdict);
    if (smallest.finding && verdict != Verdict::unsupported)
      text += finding_card(known, smallest, total.count(verdict), whole.declaration, speaker, whole.repeat);
  }
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
             : "<p>Nothing was found.</p>";
}

std::string by_family(const OperationTally& tally) {
  const std::uint64_t refused = tally.total().refused;
  std::string text =
      "<div class=\"card scroll\"><table><thead><tr><th scope=\"col\">family</th><th scope=\"col\" "
      "class=\"text\"></th>" +
      verdict_columns() + "</tr></thead><tbody>";
  for (const auto& [family, cell] : tally.families) {
    text += "<tr><td>" + escaped(family) + "</td><td>" + verdict_bar(cell, true) + "</td>" + verdict_numbers(cell) +
            "</tr>";
  }
  return text + "<tr class=\"total\"><th scope=\"row\">all</th><td></td>" + verdict_numbers(tally.total()) +
         "</tr></tbody></table>" +
         (refused == 0
              ? ""
              : "<p class=\"small quiet\">Drawn but outside the contract, so no cases: " + grouped(refused) + ".</p>") +
         "</div>";
}

std::string outcomes(const Cell& total) {
  // Where the truth has no words there is nothing to tell apart.
  const auto truths = total.truths();
  if (truths.empty() || (truths.size() == 1 && truths.begin()->first == "value")) return "";
  std::string text =
      "<h2>What the truth was</h2><div class=\"card\"><p class=\"quiet\">How often the truth was what. A family that "
      "never reaches an answer "
      "tests nothing about it.</p><ul class=\"chips\">";
  for (const auto& [outcome, n] : truths) text += "<li>" + escaped(outcome) + " " + grouped(n) + "</li>";
  return text + "</ul></div>";
}

}  // namespace

std::string operation_page(const Tally& tally, std::size_t operation, const std::vector<FailureMap>& maps) {
  const OperationTally& here = tally.operations[operation];
  const Operation* known = find_operation(here.operation);
  std::string body = navigation(tally, operation) + opening(tally, here, known) + "<main>" + summary(tally, operation);
  if (known) body += "<h2>The smallest input of each cause</h2>" + findings(tally, here, *known);
  if (known && !maps.empty()) {
    body += "<h2 id=\"map\">Failure map</h2><div class=\"card\">" + map_section(*known, maps, tally.repeat) + "</div>";
  }
  if (known && speaker_of(tally.declaration) == Speaker::reference && !tally.declaration.binary32)
    body += condition_section(*known);
  body += "<h2>By family of inputs</h2>" + by_family(here) + outcomes(here.total());
  return page("touchstone: " + here.operation, body + "</main><footer></footer>");
}

std::string map_page(const Operation& operation, const std::vector<FailureMap>& maps, const Repeat& repeat) {
  const Card& card = operation.card();
  return page("touchstone map: " + operation.name(),
              "<header><p class=\"kicker\">touchstone map</p><h1>" + escaped(operation.name()) +
                  "</h1><p class=\"lead\">" + escaped(card.question) + " Deck p. " + escaped(card.pages) + ".</p><p>" +
                  escaped(in_words(maps)) + ".</p></header><main><div class=\"card\">" +
                  map_section(operation, maps, repeat) + "</div></main><footer></footer>");
}

}  // namespace touchstone::audit
