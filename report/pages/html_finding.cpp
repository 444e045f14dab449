// SPDX-License-Identifier: Apache-2.0
#include "report/pages/html_finding.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "audit/counting/audit_run.h"
#include "audit/counting/generic.h"
#include "catalogue/codec/json.h"
#include "catalogue/codec/plain.h"
#include "catalogue/judge/tolerated.h"
#include "catalogue/operation/probes/explained.h"
#include "catalogue/operation/truth_drawing.h"
#include "geometry/invalid_input.h"
#include "report/figures/space_model.h"
#include "report/figures/svg.h"
#include "report/pages/html_search.h"
#include "report/parts/html_parts.h"
#include "report/words/answered.h"
#include "report/words/phrases.h"

namespace touchstone::report {
namespace {

/// A note such as "ta = p/q" or "angles: [...]", with long exact values shortened.
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

/// True if a note is about a field of the truth, which the caption states.
bool is_said(const std::string& note, const Json& truth) {
  const std::string field = note.substr(0, note.find_first_of(":= "));
  return truth.is_object() && truth.contains(field);
}

/// The least gap that may decide, if an invisibly narrow gap may: the margin is that narrow, and not 0. Any other gap
/// of the figure is coincidental, and so is one that is much narrower than the margin.
std::optional<mpq_class> least_gap_that_decides(const Operation& operation, const Examination& question) {
  constexpr int narrower = 64;  // a margin that is a product may have factors of several magnitudes
  const int degree = operation.metadata().margin_degree;
  if (!question.margin() || degree == 0) return mpq_class(0);
  const mpq_class size = exact_value(greatest(question.question()));
  mpq_class least = *question.margin() / narrower;
  if (sgn(least) == 0 || !within(*question.margin(), mpq_class(size / 32), size, degree)) return std::nullopt;
  for (int i = 1; i < degree; ++i) least /= size;
  return least;
}

std::string drawn(const Drawing& drawing, const std::string& title, const std::string& caption,
                  const std::optional<mpq_class>& least_gap) {
  const std::string svg =
      drawing.figures.empty() ? space_figure(drawing, title, least_gap) : drawing_svg(drawing, title, least_gap);
  return "<figure>" + svg + "<figcaption>" + caption + search_caption(drawing) + "</figcaption></figure>";
}

bool shows_an_answer(const Drawing& drawing) {
  const auto said = [](const auto& figure) { return figure.said; };
  return std::any_of(drawing.figures.begin(), drawing.figures.end(), said) ||
         std::any_of(drawing.space.begin(), drawing.space.end(), said);
}

/// The drawing without the truth.
Drawing answered_alone(Drawing drawing) {
  const auto true_one = [](const auto& figure) { return figure.answer; };
  drawing.figures.erase(std::remove_if(drawing.figures.begin(), drawing.figures.end(), true_one),
                        drawing.figures.end());
  drawing.space.erase(std::remove_if(drawing.space.begin(), drawing.space.end(), true_one), drawing.space.end());
  return drawing;
}

std::string figures(const Operation& operation, const Finding& finding, const Drawing& drawing, const Json& truth,
                    const std::string& speaker_name, const std::string& margin,
                    const std::optional<mpq_class>& least_gap) {
  std::string notes;
  for (const std::string& note : drawing.notes) {
    if (is_said(note, truth)) continue;
    notes += (notes.empty() ? "" : "; ") + in_short(note);
  }
  const std::string title = operation.name() + ": the input " + one_line(operation.print(finding.question));
  const bool in_space = drawing.figures.empty() && !drawing.space.empty();
  const bool unseen =
      in_space && least_gap && !margin.empty() && !has_space_lens(space_figure(drawing, title, least_gap));
  const std::string right = "<b class=\"truth-said\">Truth:</b> " + escaped(sentence(operation, truth)) + "." +
                            (unseen ? " The figure cannot show the margin, " + escaped(margin) + "." : ""),
                    wrong = "<b class=\"who-said\">" + escaped(speaker_name) + ":</b> " +
                            escaped(sentence(operation, plain(finding.answer))) + ".";
  Drawing both = drawing;
  draw_answered(both, operation, plain(finding.answer), finding.question);
  if (!shows_an_answer(both)) {
    const std::string more = notes.empty() ? "" : "<br><span class=\"quiet\">" + escaped(notes) + "</span>";
    return drawn(drawing, title, right + " " + wrong + more, least_gap);
  }
  return "<div class=\"beside\">" + drawn(drawing, title, right, least_gap) +
         drawn(answered_alone(both), title + ", and what was answered", wrong, least_gap) + "</div>";
}

std::string said_row(const Operation& operation, const std::string& speaker_name, const Json& answer,
                     const Judgement* judgement, Speaker speaker, const char* style = "") {
  std::string text = "<tr class=\"" + std::string(style) + "\"><th scope=\"row\">" + escaped(speaker_name) +
                     "</th><td>" + escaped(answer.is_null() ? "no answer" : sentence(operation, answer)) + "</td><td>";
  if (judgement) {
    text += badge(judgement->verdict, speaker);
    if (judgement->number || (judgement->ulps > 0 && std::isfinite(judgement->ulps)))
      text += " <span class=\"small quiet\">" + off_in_words(*judgement) + "</span>";
  }
  return text + "</td></tr>";
}

/// The answers of the implementations: in words, and folded as JSON.
struct Said {
  std::string table, json;
};

Said what_was_said(const Operation& operation, const Examination& question, const Finding& finding,
                   const Declaration& declaration, Speaker speaker, bool exact_in_float) {
  Said said{"<table class=\"said\"><tbody>", ""};
  const auto add = [&](const std::string& speaker_name, const Json& answer, const Judgement* judgement, Speaker of,
                       const char* style = "") {
    said.table += said_row(operation, speaker_name, plain(answer), judgement, of, style);
    said.json += "<dt>" + escaped(speaker_name) + "</dt><dd>" + code(one_line(readable(answer))) + "</dd>";
  };
  add("truth, exact", question.truth(), nullptr, speaker, "truth");
  if (speaker == Speaker::foreign) add(declaration.engine, finding.answer, &finding.judgement, speaker);
  add("the formula in double", question.reference(false), &question.judge_reference(false), Speaker::reference);
  add(exact_in_float ? "the formula in float" : "the formula in float, the input rounded to float first",
      question.reference(true), &question.judge_reference(true), Speaker::reference);
  add("robust", question.robust(), &question.judge_robust(), Speaker::robust);
  said.table += "</tbody></table>";
  return said;
}

std::string certificate(const Examination& question) {
  const Json json = certificate_json(question.certificate());
  return "<details><summary>Certificate of the truth</summary><pre>" + escaped(json.dump(1)) +
         "</pre><p class=\"small quiet\">Checked by <code>touchstone certify</code>, which knows no geometry: it "
         "multiplies, adds and "
         "compares.</p></details>";
}

}  // namespace

std::string name_of(Speaker speaker, const Declaration& declaration) {
  return speaker == Speaker::reference ? "Formula" : speaker == Speaker::robust ? "Robust" : declaration.engine;
}

std::string right_case(const Operation& operation) {
  constexpr std::uint64_t most_drawn = 40;
  constexpr std::size_t longest = 400;
  std::unique_ptr<Examination> best;
  // The case with the most content and the fewest degenerate features; of two, that with the shorter input.
  std::pair<std::size_t, std::size_t> least{std::numeric_limits<std::size_t>::max(), longest};
  const std::size_t families = operation.families().size();
  for (std::uint64_t i = 0; i < most_drawn; ++i) {
    DrawStream draws = case_draws(operation, i % families, 1, i / families);
    const Question question = operation.draw(draws, i % families);
    const std::size_t length = one_line(operation.print(question)).size();
    if (range_of(question) != Range::ordinary || length >= longest) continue;
    try {
      auto examination = std::make_unique<Examination>(operation, question);
      const std::pair<std::size_t, std::size_t> key{degenerate_features(operation, question, examination->degenerate()),
                                                    length};
      if (key >= least || examination->judge_reference().verdict != Verdict::agree) continue;
      const Drawing& drawing = examination->drawing();
      if (drawing.figures.empty() && drawing.space.empty()) continue;
      least = key, best = std::move(examination);
    } catch (const InvalidInput&) {
    }
  }
  if (!best) return "";
  const std::string input = one_line(operation.print(best->question()));
  return "<section class=\"card right-case\"><h3>For comparison: a case where the formula is right</h3>" +
         drawn(best->drawing(), operation.name() + ": the input " + input,
               "<b class=\"truth-said\">Truth:</b> " + escaped(sentence(operation, plain(best->truth()))) +
                   ". The formula answers the same.",
               least_gap_that_decides(operation, *best)) +
         "<details class=\"exactly\"><summary>The input as JSON</summary>" + code(input) + "</details></section>";
}

std::string finding_card(const Operation& operation, const OperationOutcome& shown, const Declaration& declaration,
                         Speaker speaker, const Repeat& repeat) {
  const Finding& finding = *shown.counted.example;
  const Verdict verdict = finding.judgement.verdict;
  const std::uint64_t cases = both(shown.counted.cases), ordinary = shown.counted.cases[0],
                      out_of_range = both(shown.counted.out_of_range);
  std::string how_often =
      counted(cases, "case") + (ordinary == cases ? ", all" : ", " + grouped(ordinary)) + " of ordinary size";
  if (out_of_range > 0) how_often += "; " + grouped(out_of_range) + " by over- or underflow";
  std::string words = shown.outcome.answer == shown.outcome.truth || shown.outcome.answer.empty()
                          ? ""
                          : phrase(operation, shown.outcome) + " ";
  std::string text =
      fmt::format("<section class=\"card finding\"><h3>{} {}<span class=\"how-often\">{}</span></h3><p>{}</p>",
                  badge(verdict, speaker), escaped(words), escaped(how_often),
                  words_in_html(why(finding, &operation, speaker, declaration.binary32)));
  std::string margin, proof;
  Said said;
  Json truth;
  Drawing drawing;
  std::optional<mpq_class> least_gap = mpq_class(0);
  try {
    const Examination& question = finding.examination(operation);
    const bool narrow = operation.in_binary32(finding.question) == finding.question;
    truth = plain(question.truth());
    said = what_was_said(operation, question, finding, declaration, speaker, narrow);
    if (question.margin()) margin = readable(*question.margin());
    least_gap = least_gap_that_decides(operation, question);
    proof = certificate(question);
    drawing = question.drawing();
  } catch (const InvalidInput& refused) {
    truth = std::string("refused, ") + refused.what();
    drawing = drawing_of_refused(operation, finding.question, refused);
    said.table = "<p>The oracle refuses this input: " + code(refused.what()) + "</p>";
  }
  text += "<div class=\"seen\">" +
          figures(operation, finding, drawing, truth, name_of(speaker, declaration), margin, least_gap) + said.table +
          "</div>";
  const auto fact = [&](const char* key, const std::string& html) {
    text += std::string("<dt>") + key + "</dt><dd>" + html + "</dd>";
  };
  text += "<dl class=\"facts\">";
  if (!margin.empty()) fact("margin", code(margin));
  fact("found in", escaped(place_in_words(shown.family, finding, repeat)));
  text +=
      "</dl><details class=\"exactly\"><summary>The input and the answers as JSON, and in hexadecimal</summary><dl "
      "class=\"facts\">";
  fact("input", code(one_line(operation.print(finding.question))));
  fact("hexadecimal", code(one_line(operation.print_hexadecimal(finding.question))));
  text += said.json +
          "</dl></details><details><summary>Ask again</summary><p class=\"small quiet\">touchstone is "
          "build/release/touchstone where it is not installed:</p>" +
          shell_line(repeat_command(operation, finding.question, speaker, repeat)) + "</details>";
  return text + proof + "</section>";
}

}  // namespace touchstone::report
