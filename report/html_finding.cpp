// SPDX-License-Identifier: Apache-2.0
#include "report/html_finding.h"

#include <fmt/format.h>

#include <cmath>

#include "catalogue/codec/json.h"
#include "catalogue/codec/plain.h"
#include "catalogue/explained.h"
#include "geometry/invalid_input.h"
#include "report/answered.h"
#include "report/html_parts.h"
#include "report/space_svg.h"
#include "report/svg.h"

namespace touchstone::audit {
namespace {

/// A note such as "ta = p/q" or "angles: [...]", exact values shortened where they are long.
std::string in_short(const std::string& note) {
  constexpr std::size_t longest = 160;
  const std::size_t equals = note.find(" = ");
  std::string shorter;
  if (equals != std::string::npos) {
    shorter = note.substr(0, equals + 3) + readable(Json(note.substr(equals + 3))).get<std::string>();
  } else {
    for (std::size_t at = 0; at < note.size();) {
      const std::size_t open = note.find('"', at);
      const std::size_t close = open == std::string::npos ? open : note.find('"', open + 1);
      shorter += note.substr(at, open - at);
      if (close == std::string::npos) break;
      shorter += readable(Json(note.substr(open + 1, close - open - 1))).get<std::string>();
      at = close + 1;
    }
  }
  return shorter.size() > longest ? shorter.substr(0, longest) + " \u2026" : shorter;
}

std::string figure(const Operation& operation, const Finding& finding) {
  const Question& question = finding.question;
  Scene scene = operation.scene(question);
  draw_answered(scene, plain(finding.answer));
  std::string notes;
  for (const std::string& note : scene.notes) {
    notes += (notes.empty() ? "" : "; ") + in_short(note);
  }
  const std::string title = operation.name() + ": the input " + one_line(operation.print(question));
  const std::string svg = scene.figures.empty() ? space_svg(scene, title) : scene_svg(scene, title);
  return "<figure>" + svg + (notes.empty() ? "" : "<figcaption>" + escaped(notes) + "</figcaption>") + "</figure>";
}

std::string said_row(const std::string& who, const std::string& answer, const Judgement* judgement, Speaker speaker,
                     const char* style = "") {
  std::string text = "<tr class=\"" + std::string(style) + "\"><th scope=\"row\">" + escaped(who) + "</th><td>" +
                     code(answer) + "</td><td>";
  if (judgement) {
    text += badge(judgement->verdict, speaker);
    if (judgement->ulps > 0 && std::isfinite(judgement->ulps))
      text += " <span class=\"small quiet\">" + ulps_in_words(judgement->ulps) + " off</span>";
  }
  return text + "</td></tr>";
}

std::string what_was_said(const Examination& question, const Finding& finding, const Declaration& declaration,
                          Speaker speaker, bool exact_in_float) {
  std::string text = "<table class=\"said\"><tbody>";
  text += said_row("truth, exact", one_line(readable(question.truth())), nullptr, speaker, "truth");
  if (speaker == Speaker::foreign) {
    text += said_row(declaration.engine, finding.answer.is_null() ? "no answer" : one_line(readable(finding.answer)),
                     &finding.judgement, speaker);
  }
  const Judgement in_double = question.judge_reference(false), in_float = question.judge_reference(true),
                  exact = question.judge_robust();
  text += said_row("the formula in double", one_line(question.reference(false)), &in_double, Speaker::reference);
  text += said_row(exact_in_float ? "the formula in float" : "the formula in float, the input rounded to float first",
                   one_line(question.reference(true)), &in_float, Speaker::reference);
  text += said_row("robust", one_line(question.robust()), &exact, Speaker::robust);
  return text + "</tbody></table>";
}

std::string certificate(const Examination& question) {
  const Json json = certificate_json(question.certificate());
  return "<details><summary>Certificate of the truth</summary><pre>" + escaped(json.dump(1)) +
         "</pre><p class=\"small quiet\">Checked by <code>touchstone certify</code>, which knows no geometry: it "
         "multiplies, adds and "
         "compares.</p></details>";
}

}  // namespace

std::string finding_card(const Operation& operation, const Smallest& smallest, std::uint64_t count,
                         const Declaration& declaration, Speaker speaker, const Repeat& repeat) {
  const Finding& finding = *smallest.finding;
  const std::string verdict = name_of(finding.judgement.verdict);
  std::string text =
      fmt::format("<section class=\"card\" id=\"{0}{1}\"><h3>{2} {3}</h3><p>{4}</p>",
                  speaker == Speaker::robust ? "robust-" : "", verdict, badge(finding.judgement.verdict, speaker),
                  escaped(counted(count, "case")), escaped(why(finding, &operation, speaker, declaration.binary32)));
  text += "<div class=\"seen\">" + figure(operation, finding);
  std::string margin, proof;
  try {
    const auto question = operation.examine(finding.question);
    const bool narrow = operation.in_binary32(finding.question) == finding.question;
    text += what_was_said(*question, finding, declaration, speaker, narrow) + "</div>";
    if (question->margin()) margin = readable(*question->margin());
    proof = certificate(*question);
  } catch (const InvalidInput& refused) {
    text += "<p>The oracle refuses this input: " + code(refused.what()) + "</p></div>";
  }
  const auto fact = [&](const char* key, const std::string& html) {
    text += std::string("<dt>") + key + "</dt><dd>" + html + "</dd>";
  };
  text += "<dl class=\"facts\">";
  if (!margin.empty()) fact("margin", code(margin));
  fact("input", code(one_line(operation.print(finding.question))));
  fact("hexadecimal", code(one_line(operation.print_hexadecimal(finding.question))));
  fact("found in", escaped(fmt::format("family {}, case {}", smallest.family, finding.index)));
  text +=
      "</dl><p class=\"small quiet\" style=\"margin:10px 0 0\">Ask again (touchstone is build/release/touchstone "
      "where it is not installed"
      "):</p><pre class=\"repeat\">" +
      escaped(repeat_command(operation, finding.question, speaker, repeat)) + "</pre>";
  return text + proof + "</section>";
}

}  // namespace touchstone::audit
