// SPDX-License-Identifier: Apache-2.0
#include "report/space_svg.h"

#include <fmt/format.h>

#include "report/axes.h"
#include "report/labels.h"
#include "report/space_view.h"

namespace touchstone::audit {
namespace {

constexpr const char* opening = "<svg xmlns=\"http://www.w3.org/2000/svg\" class=\"fig space\" role=\"img\"";
constexpr std::size_t many_items = 400;
constexpr double side_room = 8, top_room = 8, line_height = 15, longest_bar = 90;

/// "x: 1 to 3", or "x: 1000000.5 ± 2e-9" where the two would look alike.
std::string span_in_words(char axis, const mpq_class& low, const mpq_class& high) {
  const std::string start = std::string(1, axis) + ": ";
  if (low == high) return start + about(low, 9);
  const mpq_class size = abs(low) < abs(high) ? mpq_class(abs(high)) : mpq_class(abs(low)), wide = high - low;
  if (1000 * wide > size) return start + about(low, 5) + " to " + about(high, 5);
  return start + about(mpq_class((low + high) / 2), 9) + " \u00b1 " + about(mpq_class(wide / 2), 2);
}

std::string text_at(double x, double y, const char* anchor, const std::string& words) {
  return fmt::format("<text class=\"scale\" x=\"{}\" y=\"{}\" text-anchor=\"{}\">{}</text>", pixels(x), pixels(y),
                     anchor, escaped(words));
}

/// A round length, as long as it is everywhere and in all directions across the view.
std::string scale_bar(const SpaceModel& model) {
  const mpq_class pixels_per_unit = model.scale.steps_per_unit[0] * mpq_class(space_frame.room) / model.reach;
  const mpq_class length = round_length(mpq_class(2 * longest_bar / pixels_per_unit));
  const double right = space_frame.frame.width, y = space_frame.frame.height,
               long_as = mpq_class(length * pixels_per_unit).get_d();
  return fmt::format("<path class=\"tick\" d=\"M{} {}v6m0 -3h{}m0 -3v6\"/>", pixels(right - long_as), pixels(y + 7),
                     pixels(long_as)) +
         text_at(right - long_as - 6, y + 14, "end", about(length, 1));
}

/// Empty where there is one scale.
std::string stretch_in_words(const SpaceModel& model) {
  const auto& scale = model.scale.steps_per_unit;
  mpq_class least = scale[0];
  for (const mpq_class& s : scale) least = s < least ? s : least;
  std::string words;
  for (std::size_t i = 0; i < 3; ++i) {
    if (scale[i] == least) continue;
    words += (words.empty() ? "" : ", ") + std::string(1, "xyz"[i]) + " stretched " +
             about(mpq_class(scale[i] / least), 2) + " times";
  }
  return words;
}

std::string below(const SpaceModel& model) {
  const double right = space_frame.frame.width, y = space_frame.frame.height;
  std::string text;
  for (std::size_t i = 0; i < 3; ++i) {
    text += text_at(0, y + 14 + line_height * static_cast<double>(i), "start",
                    span_in_words("xyz"[i], model.scale.low[i], model.scale.high[i]));
  }
  const std::string stretched = stretch_in_words(model);
  text += stretched.empty() ? scale_bar(model) : text_at(right, y + 14, "end", stretched);
  if (model.left_out > 0)
    text += text_at(right, y + 14 + line_height, "end", fmt::format("{} more are not drawn", model.left_out));
  return text;
}

}  // namespace

std::string space_style() {
  return ".fig.space{max-width:100%}.space .face{fill:var(--c);fill-opacity:.1}.space .truth.face{fill-opacity:.06}"
         ".fig.space .stroke{stroke-width:1.4;stroke-linecap:round;stroke-linejoin:round}"
         ".fig.space .q0.stroke{stroke-width:2.2}.fig.space .q1.stroke{stroke-width:1.7}"
         ".fig.space .truth.stroke{stroke-width:3.4}"
         ".fig.space .many .stroke{stroke-width:.8}"
         ".fig.space .stroke.thin{stroke-width:.8;stroke-opacity:.7}"
         ".fig.space .stroke.hid{stroke-width:1;stroke-dasharray:2 4;stroke-opacity:.6}"
         ".turns{cursor:grab;touch-action:pan-y;user-select:none;-webkit-user-select:none}"
         ".turns:active{cursor:grabbing}.turns:focus:not(:focus-visible){outline:none}";
}

bool has_space_svg(const std::string& html) { return html.find(opening) != std::string::npos; }

std::string space_svg(const Drawing& scene, const std::string& title) {
  const SpaceModel model = space_model(scene);
  if (model.items.empty()) return "";
  const Frame& frame = space_frame.frame;
  const double width = frame.width + 2 * side_room, height = frame.height + top_room + 3 * line_height + 6;
  std::string svg = opening;
  svg += fmt::format(" viewBox=\"0 0 {0} {1}\" width=\"{0}\" height=\"{1}\" data-space=\"{2}\"><title>{3}</title>",
                     pixels(width), pixels(height), escaped(model_data(model, first_turn)), escaped(title));
  svg += fmt::format("<g transform=\"translate({} {})\">", pixels(side_room), pixels(top_room));
  svg += fmt::format(
      "<rect class=\"frame\" width=\"{0}\" height=\"{1}\"/>"
      "<svg width=\"{0}\" height=\"{1}\"><g class=\"turning{2}\">{3}</g></svg>",
      pixels(frame.width), pixels(frame.height), model.items.size() > many_items ? " many" : "",
      turned(model, first_turn));
  return svg + below(model) + "</g></svg>";
}

}  // namespace touchstone::audit
