// SPDX-License-Identifier: Apache-2.0
#include "report/figures/labels.h"

#include <fmt/format.h>

#include <algorithm>
#include <limits>

namespace touchstone::report {
namespace {

constexpr double letter_width = 6.9, line_height = 15, clearance = 8, not_there = 1000;
/// Distances in pixels at which a text may stand from its place, if there is no room near it.
constexpr double farther[] = {0, 14, 28};

struct Box {
  double left, top, right, bottom;
  bool holds(const Pixel& p) const { return p.x >= left && p.x <= right && p.y >= top && p.y <= bottom; }
  bool meets(const Box& other) const {
    return left < other.right && other.left < right && top < other.bottom && other.top < bottom;
  }
};

/// Directions from its place in which a text may stand, the best first.
constexpr Pixel directions[] = {{1, -1}, {-1, -1}, {1, 1}, {-1, 1}, {0, -1}, {0, 1}, {1, 0}, {-1, 0}};

Box box_next_to(const Pixel& place, const Pixel& displacement, double width, double far) {
  const bool corner = displacement.x != 0 && displacement.y != 0;
  const double reach = (corner ? clearance * 0.7 : clearance) + far;
  const double left = displacement.x > 0   ? place.x + reach
                      : displacement.x < 0 ? place.x - reach - width
                                           : place.x - width / 2;
  const double top = displacement.y > 0   ? place.y + reach
                     : displacement.y < 0 ? place.y - reach - line_height
                                          : place.y - line_height / 2;
  return {left, top, left + width, top + line_height};
}

double cost(const Box& box, const std::vector<Box>& texts, const std::vector<Pixel>& drawn, const Frame& frame) {
  const bool inside = box.left >= 2 && box.top >= 2 && box.right <= frame.width - 2 && box.bottom <= frame.height - 2;
  double sum = inside ? 0 : not_there;
  for (const Box& text : texts) sum += box.meets(text) ? not_there : 0;
  for (const Pixel& p : drawn) sum += box.holds(p) ? 4 : 0;
  return sum;
}

std::size_t letters(const std::string& text) {
  return static_cast<std::size_t>(std::count_if(text.begin(), text.end(), [](char c) { return (c & 0xc0) != 0x80; }));
}

}  // namespace

std::string escaped(const std::string& text) {
  std::string result;
  for (const char c : text) {
    switch (c) {
      case '&': result += "&amp;"; break;
      case '<': result += "&lt;"; break;
      case '>': result += "&gt;"; break;
      case '"': result += "&quot;"; break;
      case '\'': result += "&#39;"; break;
      default: result += c;
    }
  }
  return result;
}

std::string placed_labels(const std::vector<LabelWish>& wishes, std::vector<Pixel> drawn, const Frame& frame) {
  std::string svg;
  std::vector<Box> texts;
  for (const LabelWish& wish : wishes) {
    const double width = letter_width * static_cast<double>(letters(wish.text));
    Box best{};
    double least = std::numeric_limits<double>::infinity(), preference = 0;
    for (const Pixel& place : wish.places) {
      for (const double far : farther) {
        for (const Pixel& displacement : directions) {
          const Box box = box_next_to(place, displacement, width, far);
          const double price = cost(box, texts, drawn, frame) + (preference += 0.1) + 2 * far;
          if (price < least) least = price, best = box;
        }
      }
    }
    if (least >= not_there) continue;
    texts.push_back({best.left - 4, best.top - 1, best.right + 4, best.bottom + 1});
    svg += fmt::format("<text class=\"{}\" x=\"{}\" y=\"{}\">{}</text>", wish.style, pixels(best.left),
                       pixels(best.bottom - 3.5), escaped(wish.text));
  }
  return svg;
}

}  // namespace touchstone::report
