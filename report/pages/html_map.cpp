// SPDX-License-Identifier: Apache-2.0
#include "report/pages/html_map.h"

#include <fmt/format.h>

#include <algorithm>

#include "catalogue/codec/json.h"
#include "catalogue/numbers/ulps.h"
#include "report/parts/html_parts.h"
#include "report/words/phrases.h"

namespace touchstone::report {
namespace {

std::string axis_in_words(const MapGrid& grid, std::size_t number, const std::string& field, double step) {
  return escaped(
      fmt::format("{} = {} + k \u00b7 {}", field, decimal(grid.centre.numbers[number]), about(exact_value(step))));
}

/// Two images of the same pixels, the second for dark screens. Paper is light.
std::string picture(const Image& light, const Image& dark, const std::string& attributes) {
  return "<picture><source media=\"screen and (prefers-color-scheme:dark)\" srcset=\"" + data_uri(png(dark)) +
         "\"><img " + attributes + " src=\"" + data_uri(png(light)) + "\"></picture>";
}

std::string sample(const MapClass& entry) {
  return picture(sample_of(entry, Scheme::light), sample_of(entry, Scheme::dark),
                 "class=\"sample\" alt=\"\" width=\"12\" height=\"12\"");
}

std::string verdict_in_words(Verdict verdict) {
  switch (verdict) {
    case Verdict::agree: return "right";
    case Verdict::rounding: return "wrong by rounding";
    case Verdict::algorithm: return "wrong by algorithm";
    case Verdict::inexact: return "inexact number";
    case Verdict::convention: return "right for open sets";
    case Verdict::tolerance: return "within the tolerance";
    case Verdict::invalid: return "invalid answer";
    case Verdict::unsupported: return "not supported";
  }
  return "";
}

/// The legend's text for a class without its verdict, which is next to it.
std::string said(const Operation& operation, const MapClass& entry) {
  if (entry.said.empty()) return verdict_in_words(entry.verdict);
  const auto words = operation.words();
  const bool word = std::find(words.begin(), words.end(), entry.said) != words.end();
  return word ? phrase(operation, entry.said) : entry.said;
}

/// The text with one number of the input replaced, wherever the input occurs in it.
std::string with_places(const Operation& operation, const MapGrid& grid, const std::string& text) {
  const std::string whole = one_line(operation.print(grid.centre));
  Json places = operation.print(grid.centre);
  const auto put = [&](const std::string& field, const char* mark) {
    // "a.b[0][1]" as the pointer /a/b/0/1
    std::string pointer = "/";
    for (const char c : field) pointer += c == '.' || c == '[' ? "/" : c == ']' ? "" : std::string(1, c);
    places[Json::json_pointer(pointer)] = mark;
  };
  put(grid.fields.first, "{x}");
  put(grid.fields.second, "{y}");
  std::string marked = one_line(places);
  for (const std::string& mark : {std::string("\"{x}\""), std::string("\"{y}\"")}) {
    const std::size_t at = marked.find(mark);
    marked.replace(at, mark.size(), mark.substr(1, mark.size() - 2));
  }
  const std::size_t at = text.find(whole);
  return at == std::string::npos ? text : std::string(text).replace(at, whole.size(), marked);
}

/// The initial square: among those where the subject fails the one nearest to the middle.
std::pair<int, int> start_of(const FailureMap& map) {
  int best = map.side * map.side;
  std::pair<int, int> start{map.side / 2, map.side / 2 - 1};
  for (int i = 0; i < map.side * map.side; ++i) {
    const std::size_t of = map.squares[static_cast<std::size_t>(i)];
    if (of >= map.classes.size() || !is_finding(map.classes[of].verdict)) continue;
    const int column = i % map.side, row = i / map.side;
    const int far = std::abs(column - map.side / 2) + std::abs(row - map.side / 2 + 1);
    if (far < best) best = far, start = {column, row};
  }
  return start;
}

std::string data_of(const Operation& operation, const std::vector<FailureMap>& maps, const Repeat& repeat) {
  const MapGrid& grid = maps[0].grid;
  std::string xs, ys;
  const int side = maps[0].side;
  for (int i = 0; i < side; ++i) {
    const Question question = grid.at(column_of(i, side), row_of(i, side));
    xs += (i == 0 ? "" : " ") + decimal(question.numbers[grid.axes.first]);
    ys += (i == 0 ? "" : " ") + decimal(question.numbers[grid.axes.second]);
  }
  Json shown = Json::array();
  for (const FailureMap& map : maps) {
    Json classes = Json::array();
    for (const MapClass& entry : map.classes) {
      classes.push_back({{"verdict", name_of(entry.verdict)}, {"says", said(operation, entry)}});
    }
    shown.push_back({{"who", map.subject}, {"classes", classes}});
  }
  const Speaker speaker = maps.size() > 2 ? Speaker::foreign : Speaker::reference;
  const auto start = start_of(subject_of(maps));
  const std::string input = one_line(operation.print(grid.centre));
  return one_line(
      Json{{"x", grid.fields.first},
           {"y", grid.fields.second},
           {"xs", xs},
           {"ys", ys},
           {"side", side},
           {"start", {start.first, start.second}},
           {"input", with_places(operation, grid, input)},
           {"repeat", with_places(operation, grid, repeat_command(operation, grid.centre, speaker, repeat))},
           {"maps", shown}});
}

}  // namespace

std::string class_in_words(const Operation& operation, const MapClass& entry) {
  const std::string words = verdict_in_words(entry.verdict);
  return entry.said.empty() ? words : words + ": " + said(operation, entry);
}

std::string map_picture(const FailureMap& map, const std::string& alt) {
  return picture(image_of(map, Scheme::light), image_of(map, Scheme::dark),
                 fmt::format("alt=\"{0}\" width=\"{1}\" height=\"{1}\"", escaped(alt), 2 * MapGrid::side));
}

std::string squares_in_words(int side) {
  const int wide = MapGrid::side / side;
  return wide == 1 ? "Each pixel" : fmt::format("Each square of {0} \u00d7 {0} pixels", wide);
}

std::string map_section(const Operation& operation, const std::vector<FailureMap>& maps, const Repeat& repeat) {
  const MapGrid& grid = maps[0].grid;
  std::string text = map_opening + escaped(data_of(operation, maps, repeat)) + "\"><div class=\"maps\">";
  for (const FailureMap& map : maps) {
    text += "<div><h4>" + escaped(map.subject) + "</h4><div class=\"map\">" +
            map_picture(map, map.subject + ": " + summary_of(Cell::of(map.counts))) + "</div><ul>";
    for (const MapClass& entry : map.classes) {
      text += fmt::format("<li><span>{}{}</span><b>{}</b></li>", sample(entry),
                          escaped(class_in_words(operation, entry)), grouped(entry.count));
    }
    if (map.refused > 0)
      text += fmt::format("<li><span>{}outside the contract</span><b>{}</b></li>", swatch("var(--paper)"),
                          grouped(map.refused));
    text += "</ul></div>";
  }
  return text +
         fmt::format(
             "</div><p class=\"small quiet below\">{} is one question. To the right {}, upwards {}, k = "
             "\u2212128 \u2026 127: the smallest steps that the number format allows at this size. The other numbers "
             "stay as in {}. Strong colours are findings; what is right is pale, and the pattern says which "
             "answer it is.</p></div>",
             squares_in_words(maps[0].side), axis_in_words(grid, grid.axes.first, grid.fields.first, grid.step.first),
             axis_in_words(grid, grid.axes.second, grid.fields.second, grid.step.second),
             code(one_line(operation.print(grid.centre))));
}

}  // namespace touchstone::report
