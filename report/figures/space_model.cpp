// SPDX-License-Identifier: Apache-2.0
#include "report/figures/space_model.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "report/figures/axes.h"
#include "report/figures/labels.h"
#include "report/figures/space_lens.h"
#include "report/figures/space_scale.h"

namespace touchstone::report {
namespace {

constexpr const char* figure_opening = "<div class=\"space-figure\" data-space=\"";
constexpr int normal_length = 2 * steps_of_box / 5, longest_bar = 9 * steps_of_box / 10;

const char* name_of(SpaceFigure::Kind kind) {
  constexpr const char* names[] = {"point", "segment", "arrow", "plane", "polygon", "box", "sphere", "mesh"};
  return names[static_cast<std::size_t>(kind)];
}

/// The point at which a plane is drawn, and the tip of its normal.
std::array<SpacePoint, 2> normal_of(const SpaceFigure& plane, const SpaceScale& scale) {
  // Subnormal coordinates have few digits, but as many as there are.
  const std::vector<double>& n = plane.numbers;
  const double size = std::max({std::fabs(n[0]), std::fabs(n[1]), std::fabs(n[2])});
  const std::array<double, 3> displacement{n[0] / size, n[1] / size, n[2] / size};
  const double length = std::sqrt(displacement[0] * displacement[0] + displacement[1] * displacement[1] +
                                  displacement[2] * displacement[2]);
  const SpacePoint foot = scale.at(scale.foot(plane));
  SpacePoint tip = foot;
  for (std::size_t i = 0; i < 3; ++i)
    tip[i] += static_cast<int>(std::floor(displacement[i] / length * normal_length + 0.5));
  return {foot, tip};
}

Json json_of(const SpaceFigure& figure, const SpaceScale& scale) {
  Json json{
      {"kind", name_of(figure.kind)}, {"label", figure.label}, {"whose", whose(figure)}, {"points", Json::array()}};
  for (const ExactPlace& place : places_of(figure)) json["points"].push_back(scale.at(place));
  if (figure.kind == SpaceFigure::Kind::plane) json["points"] = normal_of(figure, scale);
  if (figure.kind == SpaceFigure::Kind::sphere) json["radius"] = scale.radius_in_steps(figure);
  if (figure.kind == SpaceFigure::Kind::mesh) json["faces"] = figure.faces;
  if (figure.moves) {
    const auto back = scale.steps(figure.moves->at_minus_1), on = scale.steps(figure.moves->at_1);
    const SpacePoint still{};
    if (back && on && (*back != still || *on != still)) json["moves"] = {*back, *on};
  }
  add_node(json, figure);
  return json;
}

/// "x: 1 to 3", or "x: 1000000.5 ± 2e-9" if the two would look alike.
std::string span_in_words(char axis, const mpq_class& low, const mpq_class& high) {
  const std::string start = std::string(1, axis) + ": ";
  if (low == high) return start + about(low, 9);
  const mpq_class size = abs(low) < abs(high) ? mpq_class(abs(high)) : mpq_class(abs(low)), wide = high - low;
  if (1000 * wide > size) return start + about(low, 5) + " to " + about(high, 5);
  return start + about(mpq_class((low + high) / 2), 9) + " \u00b1 " + about(mpq_class(wide / 2), 2);
}

/// Empty if there is one scale.
std::string stretch_in_words(const SpaceScale& scale) {
  const auto& per_unit = scale.steps_per_unit;
  const mpq_class& least = *std::min_element(per_unit.begin(), per_unit.end());
  std::string words;
  for (std::size_t i = 0; i < 3; ++i) {
    if (per_unit[i] == least) continue;
    words += (words.empty() ? "" : ", ") + std::string(1, "xyz"[i]) + " stretched " +
             about(mpq_class(per_unit[i] / least), 2) + " times";
  }
  return words;
}

/// "In space: sphere a, 7 × point points, truth: mesh; x: 0 to 1; ..."
std::string in_words(const Json& model, const Drawing& scene) {
  std::vector<std::pair<std::string, std::size_t>> lists;
  for (const Json& figure : model["figures"]) {
    const std::string label = figure["label"], kind = figure["kind"], list = label.substr(0, label.find('['));
    const bool node = figure.contains("node");
    const std::string name =
        (figure["whose"] == "truth" ? "truth: " : "") + (node ? "node" : kind) + (list.empty() ? "" : " ") + list;
    if (lists.empty() || lists.back().first != name) lists.emplace_back(name, 0);
    ++lists.back().second;
  }
  std::string text = "In space: ";
  for (const auto& [name, count] : lists) {
    text += (&name == &lists[0].first ? "" : ", ") + (count > 1 ? fmt::format("{} \u00d7 ", count) : "") + name;
  }
  for (const char* lines : {"spans", "remarks"})
    for (const std::string line : model[lines]) text += "; " + line;
  if (model.contains("lens")) text += "; " + model["lens"]["spans"][0].get<std::string>();
  for (const std::string& note : scene.notes) text += "; " + note;
  return text + "." + (scene.search.empty() ? "" : " " + scene.search);
}

}  // namespace

std::string space_style() {
  return ".fig.space{max-width:100%}.space .face{fill:var(--c);fill-opacity:.1}.space .truth.face{fill-opacity:.06}"
         ".fig.space .stroke{stroke-width:1.4;stroke-linecap:round;stroke-linejoin:round}"
         ".fig.space .q0.stroke{stroke-width:2.2}.fig.space .q1.stroke{stroke-width:1.7}"
         ".fig.space .truth.stroke{stroke-width:3.4}"
         ".fig.space .many .stroke{stroke-width:.8}"
         ".space .facet{stroke-width:.5;stroke-linejoin:round}"
         ".fig.space .node.stroke{stroke-width:1.1;stroke-opacity:.6}.fig.space .deep.stroke{stroke-width:.8}"
         ".fig.space .deepest.stroke{stroke-width:.5}.fig.space .node.face{fill-opacity:.045}"
         ".fig.space .stroke.thin{stroke-width:.8;stroke-opacity:.7}"
         ".fig.space .stroke.hid{stroke-width:1;stroke-dasharray:2 4;stroke-opacity:.6}"
         ".turns{cursor:grab;touch-action:pan-y;user-select:none;-webkit-user-select:none}"
         ".time input{width:11em;vertical-align:middle}.time output{display:inline-block;min-width:5em}"
         ".turns:active{cursor:grabbing}.turns:focus:not(:focus-visible){outline:none}";
}

Json space_model(const Drawing& scene, const std::string& title, const std::optional<mpq_class>& least_gap,
                 std::size_t most_corners) {
  std::vector<SpaceFigure> figures;
  std::copy_if(scene.space.begin(), scene.space.end(), std::back_inserter(figures), drawable);
  if (figures.empty()) return nullptr;
  const SpaceScale scale = SpaceScale::of(figures);
  Json model{{"title", title}, {"figures", Json::array()}, {"spans", Json::array()}, {"remarks", Json::array()}};
  std::size_t corners = 0, left_out = 0;
  std::vector<SpaceFigure> drawn;
  for (const SpaceFigure& figure : figures) {
    std::size_t own = figure.numbers.size() / 3 + 1;
    for (const auto& face : figure.faces) own += 1 + face.size();
    if (corners + own > most_corners) {
      ++left_out;
      continue;
    }
    corners += own;
    model["figures"].push_back(json_of(figure, scale));
    drawn.push_back(figure);
  }
  for (std::size_t i = 0; i < 3; ++i) model["spans"].push_back(span_in_words("xyz"[i], scale.low[i], scale.high[i]));
  const std::string stretched = stretch_in_words(scale);
  if (stretched.empty()) {
    const mpq_class length = round_length(mpq_class(2 * longest_bar / scale.steps_per_unit[0]));
    model["bar"] = {mpq_class(length * scale.steps_per_unit[0]).get_d(), about(length, 1)};
  } else {
    model["remarks"].push_back(stretched);
  }
  if (left_out > 0) model["remarks"].push_back(fmt::format("{} more are not drawn", left_out));
  if (!least_gap) return model;
  if (const auto gap = narrowest_gap(drawn, scale, *least_gap)) model["lens"] = space_lens(drawn, scale, *gap);
  return model;
}

std::string space_figure(const Drawing& scene, const std::string& title, const std::optional<mpq_class>& least_gap,
                         std::size_t most_corners) {
  const Json model = space_model(scene, title, least_gap, most_corners);
  if (model.is_null()) return "";
  return figure_opening + escaped(one_line(model)) + "\"><noscript><p>" + escaped(in_words(model, scene)) +
         "</p></noscript></div>";
}

bool has_space_figure(const std::string& html) { return html.find(figure_opening) != std::string::npos; }
bool has_space_lens(const std::string& html) { return html.find(escaped("\"lens\":")) != std::string::npos; }

}  // namespace touchstone::report
