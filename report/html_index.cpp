// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include "audit/engines/protocol.h"
#include "report/html.h"
#include "report/html_map.h"
#include "report/html_parts.h"

namespace touchstone::audit {
namespace {

std::string conditions(const Tally& tally) {
  const Declaration& declared = tally.declaration;
  std::string text = counted(tally.operations.size(), "operation");
  text += tally.grid.size > 0
              ? fmt::format(", every configuration on the {0} \u00d7 {0} grid ({1} of {2})", tally.grid.size,
                            tally.grid.done.size(), counted(tally.grid.shards, "shard"))
              : ", " + counted(tally.cases, "case") + " each, seed " + std::to_string(tally.seed);
  text += ". Boundary convention: " + boundary_word(declared.boundary) + ".";
  if (declared.tolerance > 0) text += fmt::format(" Declared tolerance: {}.", declared.tolerance);
  if (tally.grid.size == 0) {
    text +=
        " Most families are degenerate on purpose or a few units in the last place away from it, so the shares say "
        "where an "
        "implementation fails, not how often everyday input would meet it.";
  }
  if (tally.interrupted) text += " The run was interrupted; this is what had been counted.";
  return text;
}

/// The closing sentence of the table, where the heading already says whose answers these are.
std::string lead(const Tally& tally) {
  const Cell robust = sum_of(tally.robust);
  std::string text = summary_of(sum_of(tally.operations)) + ".";
  if (!tally.robust.empty()) {
    const std::uint64_t wrong = robust.cases() - robust.count(Verdict::agree);
    text += " Robust, asked the same questions: " + (wrong == 0 ? "none wrong." : grouped(wrong) + " not right.");
  }
  return text;
}

std::string tile(const std::string& style, std::uint64_t n, const std::string& words) {
  return "<div class=\"tile " + style + "\"><b>" + grouped(n) + "</b><span>" + escaped(words) + "</span></div>";
}

std::string tiles(const Tally& tally, const Cell& sum) {
  std::string text =
      "<div class=\"tiles\">" + tile("", sum.cases() - sum.count(Verdict::unsupported), "answers judged");
  const auto counts = sum.counts();
  for (std::size_t v = 0; v < verdict_count; ++v) {
    const auto verdict = static_cast<Verdict>(v);
    const bool always = verdict == Verdict::agree || verdict == Verdict::rounding || verdict == Verdict::algorithm;
    if (always || counts[v] > 0) text += tile(verdict_names[v], counts[v], verdict_names[v]);
  }
  if (sum.not_asked > 0) text += tile("", sum.not_asked, "not asked");
  if (!tally.robust.empty()) {
    const Cell robust = sum_of(tally.robust);
    text += tile("", robust.cases() - robust.count(Verdict::agree), "wrong by robust");
  }
  return text + "</div>";
}

std::string operations_table(const Tally& tally) {
  std::string text =
      "<div class=\"card scroll\"><table><thead><tr><th scope=\"col\">operation</th><th scope=\"col\" "
      "class=\"text\">all answers</th>"
      "<th scope=\"col\">findings</th><th scope=\"col\">share</th><th scope=\"col\" class=\"text\">their "
      "causes</th></tr></thead><tbody>";
  for (const OperationTally& operation : tally.operations) {
    const Cell total = operation.total();
    const Operation* known = find_operation(operation.operation);
    text += fmt::format(
        "<tr><th scope=\"row\"><a href=\"{0}.html\">{0}</a><div class=\"small quiet\" "
        "style=\"font-weight:400;white-space:normal\">{1}</div></th>"
        "<td class=\"wide\">{2}</td><td>{3}</td><td>{4}</td><td style=\"min-width:130px\">{5}</td></tr>",
        escaped(operation.operation), escaped(known ? known->card().question : ""), verdict_bar(total, false),
        grouped(total.findings()), share(total.findings(), total.cases()), cause_bar(total));
  }
  return text + "</tbody></table></div>";
}

/// The words of the pages that a reader may not know.
std::string glossary() {
  return "<p class=\"small quiet\" style=\"margin:14px 0 0\">The slide is the textbook formula of an operation, deck "
         "p. the "
         "page of the lecture deck that it stands on (<em>Collision handling: detection and response</em>, CSE 3541, "
         "M. "
         "Boggus); an ulp is one unit in the last place of a number, and a family named +ulp holds the inputs of the "
         "family before it with one coordinate moved by a few ulps.</p>";
}

std::string legend(Speaker speaker) {
  std::string text = "<div class=\"card\"><dl class=\"legend\">";
  for (std::size_t v = 0; v < verdict_count; ++v) {
    text += fmt::format(
        "<dt><span class=\"swatch {0} hatch\" style=\"background-color:var(--c)\"></span>{0}</dt><dd>{1}</dd>",
        verdict_names[v], escaped(meaning(static_cast<Verdict>(v), speaker)));
  }
  return text + "</dl>" + glossary() + "</div>";
}

/// A foreign engine is not always at hand when the report is written; then the maps are those of the slide's formula.
std::string gallery_heading(const Tally& tally, const OperationMaps& maps) {
  const bool shown = speaker_of(tally.declaration) == Speaker::reference || maps[0].second.size() > 2;
  return shown ? "Where it goes wrong" : "For comparison: where the slide's formula goes wrong";
}

std::string gallery(const OperationMaps& maps) {
  const std::vector<FailureMap>& first = maps[0].second;
  std::string text =
      "<p class=\"quiet\">Every pixel is one question, at most 128 of the smallest steps away from a degenerate one. "
      "Left: " +
      escaped(first[first.size() > 2 ? 2 : 0].subject) +
      "; right: robust. Pale areas are right answers, one tint for each answer; strong colours are verdicts, as "
      "above.</p>"
      "<div class=\"gallery\">";
  for (const auto& [operation, shown] : maps) {
    const FailureMap& map = subject_of(shown);
    if (map.findings() == 0) continue;
    text += fmt::format("<a href=\"{0}.html#map\">{1}<strong>{0}</strong></a>", escaped(operation),
                        map_picture(map, map.subject));
  }
  return text + "</div>";
}

std::string whole_table(const Tally& tally) {
  std::string text = "<div class=\"card scroll\"><table><thead><tr><th scope=\"col\">operation, family</th>" +
                     verdict_columns() + "</tr></thead>";
  for (const OperationTally& operation : tally.operations) {
    text += "<tbody><tr class=\"total\"><th scope=\"row\"><a href=\"" + escaped(operation.operation) + ".html\">" +
            escaped(operation.operation) + "</a></th>" + verdict_numbers(operation.total()) + "</tr>";
    const Cell total = operation.total();
    const bool unknown = total.count(Verdict::unsupported) == total.cases();
    for (const auto& [family, cell] : operation.families) {
      if (unknown) break;
      text += "<tr><td>" + escaped(family) + "</td>" + verdict_numbers(cell) + "</tr>";
    }
    text += "</tbody>";
  }
  text += "<tbody><tr class=\"total\"><th scope=\"row\">all</th>" + verdict_numbers(sum_of(tally.operations)) + "</tr>";
  if (!tally.robust.empty()) {
    text += "<tr><th scope=\"row\">robust, the same questions</th>" + verdict_numbers(sum_of(tally.robust)) + "</tr>";
  }
  return text + "</tbody></table></div>";
}

std::string conventions(const Tally& tally) {
  std::string items;
  for (const OperationTally& operation : tally.operations) {
    if (!operation.inconsistent_convention()) continue;
    const Cell total = operation.total();
    items += fmt::format("<li><a href=\"{0}.html\">{0}</a>: as closed sets in {1}, as open sets in {2}</li>",
                         escaped(operation.operation), counted(total.touches_closed, "case"),
                         counted(total.touches_open, "case"));
  }
  if (items.empty()) return "";
  return "<h2>Inconsistent convention</h2><div class=\"card\"><p>Where shapes only touch, these operations answer now "
         "as closed "
         "sets do, now as open sets do:</p><ul>" +
         items + "</ul></div>";
}

std::string command(const Tally& tally) {
  if (tally.grid.size > 0) return "";
  std::string names;
  for (const OperationTally& operation : tally.operations) names += (names.empty() ? "" : ",") + operation.operation;
  if (tally.operations.size() == catalogue().size()) names = "all";
  const bool foreign = speaker_of(tally.declaration) == Speaker::foreign && !tally.repeat.options.empty();
  const std::string engine = foreign ? " " + tally.repeat.options : "";
  return "<h2>Repeat</h2><pre class=\"repeat\">" +
         escaped(fmt::format("{} audit{} --ops {} --cases {} --seed {} --report DIR", tally.repeat.program, engine,
                             names, tally.cases, tally.seed)) +
         "</pre>";
}

}  // namespace

std::string index_page(const Tally& tally, const OperationMaps& maps) {
  const Cell sum = sum_of(tally.operations);
  const std::string name = subject(tally.declaration);
  std::string body = "<header><p class=\"kicker\">touchstone audit</p><h1>" + escaped(name) +
                     "</h1><p class=\"lead\">" + escaped(lead(tally)) + "</p><p class=\"quiet\">" +
                     escaped(conditions(tally)) + "</p></header><main>";
  body += tiles(tally, sum) + "<h2>By operation</h2>" + operations_table(tally);
  body += "<h2>What the verdicts mean</h2>" + legend(speaker_of(tally.declaration));
  if (!maps.empty()) body += "<h2>" + gallery_heading(tally, maps) + "</h2>" + gallery(maps);
  body += conventions(tally) + "<h2>By family of inputs</h2>" + whole_table(tally) + command(tally);
  return page(
      "touchstone: " + name,
      body +
          "</main><footer>The truth is computed in exact rationals and comes with a certificate for "
          "every answer. Numbers are binary64 inputs, taken as exactly the real numbers that they are.</footer>");
}

}  // namespace touchstone::audit
